// SPDX-License-Identifier: BSD-3-Clause
/// Stress of the dummy particles of walls, extrapolated from the soil near them.
#pragma once

#include "kernels/pair/pair_geometry.hpp"

namespace scarp::kernels {

/// Equation: B2; sigma_w = sum_j [sigma_j - rho_j (g - a_w).(x_w - x_j) I] W_wj / sum_j W_wj; a
/// dummy without soil in reach has zero stress. Sweeps clusters [begin, end) of dummies. Errors:
/// none, hot path.
template <class Arch, class Real, int Dim>
void wall_sweep(const WallSweepView<Real>& view, std::int64_t begin, std::int64_t end) {
  using B = Batch<Real, Arch>;
  constexpr int half = cluster_size<Real, Arch>;
  constexpr int components = Dim == 2 ? 4 : 6;
  const HalfSelect<Real, Arch> select;
  const std::int32_t* entries = view.neighbours.entries;
  for (std::int64_t cluster = begin; cluster < end; ++cluster) {
    const std::int64_t first = view.first_wall + cluster * half;
    alignas(64) Real lane[2 * half];
    B position[Dim];
    for (int a = 0; a < Dim; ++a) {
      for (int l = 0; l < half; ++l)
        lane[l] = lane[l + half] = view.records[(first + l) * record_size + a];
      position[a] = B::load_aligned(lane);
    }
    B weight_sum(Real(0)), sums[components];
    for (auto& sum : sums) sum = B(Real(0));
    const std::int64_t end_entry = view.neighbours.wall_begin[cluster];
    for (std::int64_t e = view.neighbours.soil_begin[cluster]; e < end_entry; e += 2) {
      const Real* p = view.records + std::int64_t{entries[e]} * record_size;
      const Real* r = view.records + std::int64_t{entries[e + 1]} * record_size;
      B squared(Real(0)), fall(Real(0));
      for (int a = 0; a < Dim; ++a) {
        const B offset = position[a] - select(p + record_x + a, r + record_x + a);
        squared = xsimd::fma(offset, offset, squared);
        fall = xsimd::fma(offset, B(view.gravity[a]), fall);
      }
      const B weight = smoothing_value(xsimd::sqrt(squared), view.smoothing);
      const B lithostatic = select(p + record_density, r + record_density) * fall;
      weight_sum = weight_sum + weight;
      for (int c = 0; c < components; ++c) {
        B stress = select(p + record_stress + c, r + record_stress + c);
        if (c <= zz) stress = stress - lithostatic;
        sums[c] = xsimd::fma(weight, stress, sums[c]);
      }
    }
    alignas(64) Real weights[2 * half];
    weight_sum.store_aligned(weights);
    for (int c = 0; c < components; ++c) {
      sums[c].store_aligned(lane);
      for (int l = 0; l < half; ++l) {
        const Real total = weights[l] + weights[l + half];
        // One millionth of a touching neighbour's weight: below it the quotient is noise.
        const Real reach =
            Real(1e-6) * view.smoothing.value[0] + Real(1e-6) * view.smoothing.value[1];
        view.stress[c][cluster * half + l] =
            total > reach ? static_cast<double>((lane[l] + lane[l + half]) / total) : 0.0;
      }
    }
  }
}

}  // namespace scarp::kernels
