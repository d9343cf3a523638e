// SPDX-License-Identifier: BSD-3-Clause
/// Velocity and stress of the dummy particles of walls, extrapolated from the soil near them.
#pragma once

#include <algorithm>

#include "kernels/neighbour_block.hpp"
#include "kernels/pair/pair_geometry.hpp"

namespace scarp::kernels {

/// Equation: B1, v_w = v_wall - min(limit, d_w/d) (v - v_wall), where d_w is the distance of the
/// dummy to the face, d and v are averages of the soil's, with the weights W_wj. B2, sigma_w =
/// sum_j [sigma_j - rho_j g.(x_w - x_j) I] W_wj / sum_j W_wj. A dummy without soil in reach
/// keeps the velocity of its wall and has zero stress. Sweeps clusters [begin, end) of dummies.
/// Errors: none, hot path.
template <class Arch, class Real, int Dim>
void wall_sweep(const WallSweepView<Real>& view, std::int64_t begin, std::int64_t end) {
  using B = Batch<Real, Arch>;
  constexpr int half = cluster_size<Real, Arch>;
  constexpr int components = Dim == 2 ? 4 : 6;
  using Quad = RecordQuad<Real, Arch>;
  for (std::int64_t cluster = begin; cluster < end; ++cluster) {
    const std::int64_t first = view.first_wall + cluster * half;
    const Real* faces = view.faces + cluster * half * wall_record_size;
    alignas(64) Real lane[2 * half];
    const auto load = [&](const Real* values, int stride) {
      for (int l = 0; l < half; ++l) lane[l] = lane[l + half] = values[l * stride];
      return B::load_aligned(lane);
    };
    B position[Dim], normal[Dim];
    for (int a = 0; a < Dim; ++a) {
      position[a] = load(view.records + first * record_size + record_x + a, record_size);
      normal[a] = load(faces + wall_normal_x + a, wall_record_size);
    }
    B weight_sum(Real(0)), height_sum(Real(0)), velocity_sums[Dim], sums[components];
    for (auto& sum : velocity_sums) sum = B(Real(0));
    for (auto& sum : sums) sum = B(Real(0));
    const auto add = [&](std::int32_t low, std::int32_t high) SCARP_LAMBDA {
      const Real* p = view.records + std::int64_t{low} * record_size;
      const Real* r = view.records + std::int64_t{high} * record_size;
      const Quad where(p + record_x, r + record_x),
          moving(p + record_velocity_x, r + record_velocity_x);
      const Quad stresses(p + record_stress, r + record_stress),
          more(p + record_stress + 4, r + record_stress + 4);
      B squared(Real(0)), fall(Real(0)), depth(Real(0));
      unrolled<Dim>([&](auto a) SCARP_LAMBDA {
        const B offset = position[a] - where(a);
        squared = xsimd::fma(offset, offset, squared);
        fall = xsimd::fma(offset, B(view.gravity[a]), fall);
        depth = xsimd::fma(offset, normal[a], depth);
      });
      const B weight = smoothing_value(TruncatedPowers(xsimd::sqrt(squared)), view.smoothing);
      const B lithostatic = moving(constant<record_density - record_velocity_x>) * fall;
      weight_sum = weight_sum + weight;
      height_sum = xsimd::fnma(weight, depth, height_sum);
      unrolled<Dim>([&](auto a) SCARP_LAMBDA {
        velocity_sums[a] = xsimd::fma(weight, moving(a), velocity_sums[a]);
      });
      B stress[6];
      take_tensor<Dim>(stresses, more, stress);
      unrolled<components>([&](auto c) SCARP_LAMBDA {
        if constexpr (c <= zz) stress[c] = stress[c] - lithostatic;
        sums[c] = xsimd::fma(weight, stress[c], sums[c]);
      });
    };
    const std::int64_t end_block = view.neighbours.wall_begin[cluster];
    for (std::int64_t block = view.neighbours.soil_begin[cluster]; block < end_block; ++block) {
      const NeighbourBlock j(view.neighbours, block);
      for (int k = 0; k < entry_block; k += 2) add(j.record[k], j.record[k + 1]);
    }
    alignas(64) Real weights[2 * half], heights[2 * half];
    weight_sum.store_aligned(weights);
    height_sum.store_aligned(heights);
    // One millionth of a touching neighbour's weight: below it the quotients are noise.
    const Real least = Real(1e-6) * (view.smoothing.value[0] + view.smoothing.value[1]);
    for (int l = 0; l < half; ++l) weights[l] += weights[l + half];
    for (int a = 0; a < Dim; ++a) {
      velocity_sums[a].store_aligned(lane);
      for (int l = 0; l < half; ++l) {
        Real velocity = view.records[(first + l) * record_size + record_velocity_x + a];
        if (weights[l] > least) {
          const Real behind = faces[l * wall_record_size + wall_distance];
          const Real before = (heights[l] + heights[l + half]) / weights[l] - behind;
          const Real limit = faces[l * wall_record_size + wall_limit];
          const Real factor = behind / std::max(before, behind / limit);
          velocity -= factor * ((lane[l] + lane[l + half]) / weights[l] - velocity);
        }
        view.velocity[a][cluster * half + l] = static_cast<double>(velocity);
      }
    }
    for (int c = 0; c < components; ++c) {
      sums[c].store_aligned(lane);
      for (int l = 0; l < half; ++l) {
        view.stress[c][cluster * half + l] =
            weights[l] > least ? static_cast<double>((lane[l] + lane[l + half]) / weights[l]) : 0.0;
      }
    }
  }
}

}  // namespace scarp::kernels
