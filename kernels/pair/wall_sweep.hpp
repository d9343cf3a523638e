// SPDX-License-Identifier: BSD-3-Clause
/// What the dummy particles of walls take from the soil near them.
#pragma once

#include <algorithm>
#include <limits>

#include "kernels/neighbour_block.hpp"
#include "kernels/pair/force_correction.hpp"
#include "kernels/pair/pair_geometry.hpp"

namespace scarp::kernels {

/// Weights W_wj below this share of a touching neighbour's make quotients of noise.
template <class Real>
inline constexpr Real least_wall_weight = Real(1e-6);

/// The dummies of one cluster, twice: each half of the lanes meets its own entries of the list.
template <class Arch, class Real, int Dim>
class DummyCluster {
 public:
  using B = Batch<Real, Arch>;
  static constexpr int half = cluster_size<Real, Arch>;
  using Quad = RecordQuad<Real, Arch>;

  DummyCluster(const WallSweepView<Real>& view, std::int64_t cluster)
      : view_(view), cluster_(cluster), first_(view.first_wall + cluster * half) {}

  SCARP_INLINE B load(const Real* values, int stride) const {
    alignas(64) Real lane[2 * half];
    for (int l = 0; l < half; ++l) lane[l] = lane[l + half] = values[l * stride];
    return B::load_aligned(lane);
  }
  SCARP_INLINE B record(int slot) const {
    return load(view_.records + first_ * record_size + slot, record_size);
  }
  SCARP_INLINE B face(int slot) const {
    return load(view_.faces + cluster_ * half * wall_record_size + slot, wall_record_size);
  }
  /// add(low record, high record) for every two entries of the list.
  template <class Add>
  SCARP_INLINE void each_pair(Add&& add) const {
    const std::int64_t end = view_.neighbours.wall_begin[cluster_];
    for (std::int64_t block = view_.neighbours.soil_begin[cluster_]; block < end; ++block) {
      const NeighbourBlock j(view_.neighbours, block);
      for (int k = 0; k < entry_block; k += 2) add(j.record[k], j.record[k + 1]);
    }
  }
  /// Sums over both halves by dummy.
  SCARP_INLINE void fold(const B& sum, Real (&out)[half]) const {
    alignas(64) Real lane[2 * half];
    sum.store_aligned(lane);
    for (int l = 0; l < half; ++l) out[l] = lane[l] + lane[l + half];
  }
  /// Writes the sum of the weights, zero without soil in reach, and returns what averages divide
  /// by: infinity there.
  SCARP_INLINE void put_weight(const B& sum, Real (&divisor)[half]) const {
    Real weights[half];
    fold(sum, weights);
    const Real least =
        least_wall_weight<Real> * (view_.smoothing.value[0] + view_.smoothing.value[1]);
    for (int l = 0; l < half; ++l) {
      const bool has_soil = weights[l] > least;
      divisor[l] = has_soil ? weights[l] : std::numeric_limits<Real>::infinity();
      view_.weight[cluster_ * half + l] = has_soil ? static_cast<double>(weights[l]) : 0.0;
    }
  }
  /// Writes a sum over the weights, zero without soil in reach.
  SCARP_INLINE void put_average(double* out, const B& sum, const Real (&divisor)[half]) const {
    Real sums[half];
    fold(sum, sums);
    for (int l = 0; l < half; ++l)
      out[cluster_ * half + l] = static_cast<double>(sums[l] / divisor[l]);
  }
  std::int64_t first() const { return first_; }

 private:
  const WallSweepView<Real>& view_;
  std::int64_t cluster_, first_;
};

/// Distance of dummies to two records, and what the soil there weighs on the way.
template <class Arch, class Real, int Dim>
struct DummyPair {
  using B = Batch<Real, Arch>;
  B offset[Dim];  ///< x_w - x_j, in h
  B squared;

  template <class Quad>
  SCARP_INLINE DummyPair(const B (&position)[Dim], const Quad& where) : squared(closest<Real>) {
    unrolled<Dim>([&](auto a) SCARP_LAMBDA {
      offset[a] = position[a] - where(a);
      squared = xsimd::fma(offset[a], offset[a], squared);
    });
  }
  /// n.(x_w - x_j), negative below the soil: n points from the wall to it.
  SCARP_INLINE B depth(const B (&normal)[Dim]) const {
    B sum(Real(0));
    unrolled<Dim>([&](auto a) SCARP_LAMBDA { sum = xsimd::fma(offset[a], normal[a], sum); });
    return sum;
  }
  SCARP_INLINE B along(const Real (&direction)[3]) const {
    B sum(Real(0));
    unrolled<Dim>([&](auto a) SCARP_LAMBDA { sum = xsimd::fma(offset[a], B(direction[a]), sum); });
    return sum;
  }
};

/// Equation: B1 where forces are not corrected: v_w = v_wall - min(limit, d_w/d) (v - v_wall),
/// where d_w is the distance of the dummy to the face, d and v are averages of the soil's, with the
/// weights W_wj; and B2, sigma_w = sum_j [sigma_j - rho_j g.(x_w - x_j) I] W_wj / sum_j W_wj. A
/// dummy without soil in reach keeps the velocity of its wall and has zero stress.
template <class Arch, class Real, int Dim>
void extrapolate_dummies(const WallSweepView<Real>& view, std::int64_t cluster) {
  using B = Batch<Real, Arch>;
  constexpr int components = Dim == 2 ? 4 : 6;
  const DummyCluster<Arch, Real, Dim> dummies(view, cluster);
  constexpr int half = dummies.half;
  using Quad = RecordQuad<Real, Arch>;
  B position[Dim], normal[Dim];
  for (int a = 0; a < Dim; ++a) {
    position[a] = dummies.record(record_x + a);
    normal[a] = dummies.face(wall_normal_x + a);
  }
  B weight_sum(Real(0)), height_sum(Real(0)), velocity_sums[Dim], sums[components];
  for (auto& sum : velocity_sums) sum = B(Real(0));
  for (auto& sum : sums) sum = B(Real(0));
  dummies.each_pair([&](std::int32_t low, std::int32_t high) SCARP_LAMBDA {
    const Real* p = view.records + std::int64_t{low} * record_size;
    const Real* r = view.records + std::int64_t{high} * record_size;
    const Quad moving(p + record_velocity_x, r + record_velocity_x),
        stresses(p + record_stress, r + record_stress),
        more(p + record_stress + 4, r + record_stress + 4);
    const DummyPair<Arch, Real, Dim> pair(position, Quad(p + record_x, r + record_x));
    const B depth = pair.depth(normal);
    const B weight = smoothing_value(TruncatedPowers(xsimd::sqrt(pair.squared)), view.smoothing);
    const B lithostatic =
        moving(constant<record_density - record_velocity_x>) * pair.along(view.gravity);
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
  });
  Real divisor[half], heights[half], velocities[half];
  dummies.put_weight(weight_sum, divisor);
  dummies.fold(height_sum, heights);
  const Real* faces = view.faces + cluster * half * wall_record_size;
  for (int a = 0; a < Dim; ++a) {
    dummies.fold(velocity_sums[a], velocities);
    for (int l = 0; l < half; ++l) {
      Real velocity = view.records[(dummies.first() + l) * record_size + record_velocity_x + a];
      if (divisor[l] < std::numeric_limits<Real>::infinity()) {
        const Real behind = faces[l * wall_record_size + wall_distance];
        const Real before = heights[l] / divisor[l] - behind;
        const Real limit = faces[l * wall_record_size + wall_limit];
        const Real factor = behind / std::max(before, behind / limit);
        velocity -= factor * (velocities[l] / divisor[l] - velocity);
      }
      view.velocity[a][cluster * half + l] = static_cast<double>(velocity);
    }
  }
  for (int c = 0; c < components; ++c) dummies.put_average(view.sums[c], sums[c], divisor);
}

/// Equation: B5; G_w/sum_k W_wk with G_w = sum_j V_j (v_wall - v_j) (x) grad_j W_jw [1/s], and the
/// mean height of the soil; zero without soil in reach.
template <class Arch, class Real, int Dim>
void sum_dummy_gradients(const WallSweepView<Real>& view, std::int64_t cluster) {
  using B = Batch<Real, Arch>;
  const DummyCluster<Arch, Real, Dim> dummies(view, cluster);
  constexpr int half = dummies.half;
  using Quad = RecordQuad<Real, Arch>;
  B position[Dim], velocity[Dim], normal[Dim], weight_sum(Real(0)), height_sum(Real(0)),
      sums[Dim * Dim];
  for (int a = 0; a < Dim; ++a) {
    position[a] = dummies.record(record_x + a);
    velocity[a] = dummies.record(record_velocity_x + a);
    normal[a] = dummies.face(wall_normal_x + a);
  }
  for (auto& sum : sums) sum = B(Real(0));
  dummies.each_pair([&](std::int32_t low, std::int32_t high) SCARP_LAMBDA {
    const Real* p = view.records + std::int64_t{low} * record_size;
    const Real* r = view.records + std::int64_t{high} * record_size;
    const Quad where(p + record_x, r + record_x),
        moving(p + record_velocity_x, r + record_velocity_x);
    const DummyPair<Arch, Real, Dim> pair(position, where);
    const B inverse_distance = inverse_sqrt(pair.squared);
    const TruncatedPowers<B> powers(pair.squared * inverse_distance);
    const B weight = smoothing_value(powers, view.smoothing);
    weight_sum = weight_sum + weight;
    height_sum = xsimd::fnma(weight, pair.depth(normal), height_sum);
    // Times x_w - x_j it is minus V_j grad_j W.
    const B slope = where(constant<record_volume - record_x>) *
                    smoothing_slope(powers, view.smoothing) * inverse_distance;
    unrolled<Dim>([&](auto a) SCARP_LAMBDA {
      const B approach = slope * (moving(a) - velocity[a]);
      unrolled<Dim>([&](auto b) SCARP_LAMBDA {
        sums[a * Dim + b] = xsimd::fma(approach, pair.offset[b], sums[a * Dim + b]);
      });
    });
  });
  Real divisor[half];
  dummies.put_weight(weight_sum, divisor);
  dummies.put_average(view.height, height_sum, divisor);
  for (int a = 0; a < Dim; ++a) {
    for (int b = 0; b < Dim; ++b)
      dummies.put_average(view.sums[3 * a + b], sums[a * Dim + b], divisor);
  }
}

/// Equation: B2 for T in place of sigma, the weight along the normal apart. The records of the soil
/// hold T (K3).
template <class Arch, class Real, int Dim>
void average_corrected_stress(const WallSweepView<Real>& view, std::int64_t cluster) {
  using B = Batch<Real, Arch>;
  const DummyCluster<Arch, Real, Dim> dummies(view, cluster);
  constexpr int half = dummies.half;
  using Quad = RecordQuad<Real, Arch>;
  B position[Dim], normal[Dim], steepness(Real(0)), weight_sum(Real(0)), height_sum(Real(0)),
      overburden_sum(Real(0)), lithostatic_sum(Real(0)), sums[Dim * Dim];
  for (int a = 0; a < Dim; ++a) {
    position[a] = dummies.record(record_x + a);
    normal[a] = dummies.face(wall_normal_x + a);
    steepness = xsimd::fma(normal[a], B(view.gravity[a]), steepness);
  }
  for (auto& sum : sums) sum = B(Real(0));
  dummies.each_pair([&](std::int32_t low, std::int32_t high) SCARP_LAMBDA {
    const Real* p = view.records + std::int64_t{low} * record_size;
    const Real* r = view.records + std::int64_t{high} * record_size;
    const Quad stresses(p + record_stress, r + record_stress),
        more(p + record_stress + 4, r + record_stress + 4),
        moving(p + record_velocity_x, r + record_velocity_x);
    const DummyPair<Arch, Real, Dim> pair(position, Quad(p + record_x, r + record_x));
    const B weight = smoothing_value(TruncatedPowers(xsimd::sqrt(pair.squared)), view.smoothing);
    const B mass = weight * moving(constant<record_density - record_velocity_x>),
            depth = pair.depth(normal), upright = steepness * depth;
    weight_sum = weight_sum + weight;
    height_sum = xsimd::fnma(weight, depth, height_sum);
    overburden_sum = xsimd::fnma(mass, upright, overburden_sum);
    lithostatic_sum = xsimd::fma(mass, pair.along(view.gravity) - upright, lithostatic_sum);
    unrolled<Dim>([&](auto a) SCARP_LAMBDA {
      unrolled<Dim>([&](auto b) SCARP_LAMBDA {
        constexpr int place = corrected_place<Dim>(a, b);
        B& sum = sums[a * Dim + b];
        if constexpr (place < 4) {
          sum = xsimd::fma(weight, stresses(constant<place>), sum);
        } else if constexpr (place < 8) {
          sum = xsimd::fma(weight, more(constant<place - 4>), sum);
        } else {
          constexpr int slot = corrected_extra + place - 8, quad = slot / 4 * 4;
          const Quad extra(view.extra + std::int64_t{low} * extra_record_size + quad,
                           view.extra + std::int64_t{high} * extra_record_size + quad);
          sum = xsimd::fma(weight, extra(constant<slot - quad>), sum);
        }
      });
    });
  });
  Real divisor[half];
  dummies.put_weight(weight_sum, divisor);
  dummies.put_average(view.height, height_sum, divisor);
  dummies.put_average(view.overburden, overburden_sum, divisor);
  // Not under a condition on a and b, for which gcc 12 subtracts in the first lane alone.
  for (int a = 0; a < Dim; ++a) sums[a * Dim + a] = sums[a * Dim + a] - lithostatic_sum;
  for (int a = 0; a < Dim; ++a) {
    for (int b = 0; b < Dim; ++b)
      dummies.put_average(view.sums[corrected_place<Dim>(a, b)], sums[a * Dim + b], divisor);
  }
}

/// Equation: B6; sum_k W_wk and the mean height of the soil, which is all that the sweep of
/// gradients needs at the inner points.
template <class Arch, class Real, int Dim>
void sum_dummy_weights(const WallSweepView<Real>& view, std::int64_t cluster) {
  using B = Batch<Real, Arch>;
  const DummyCluster<Arch, Real, Dim> dummies(view, cluster);
  using Quad = RecordQuad<Real, Arch>;
  B position[Dim], normal[Dim], weight_sum(Real(0)), height_sum(Real(0));
  for (int a = 0; a < Dim; ++a) {
    position[a] = dummies.record(record_x + a);
    normal[a] = dummies.face(wall_normal_x + a);
  }
  dummies.each_pair([&](std::int32_t low, std::int32_t high) SCARP_LAMBDA {
    const DummyPair<Arch, Real, Dim> pair(
        position, Quad(view.records + std::int64_t{low} * record_size + record_x,
                       view.records + std::int64_t{high} * record_size + record_x));
    const B weight = smoothing_value(TruncatedPowers(xsimd::sqrt(pair.squared)), view.smoothing);
    weight_sum = weight_sum + weight;
    height_sum = xsimd::fnma(weight, pair.depth(normal), height_sum);
  });
  Real divisor[dummies.half];
  dummies.put_weight(weight_sum, divisor);
  dummies.put_average(view.height, height_sum, divisor);
}

/// Sweeps clusters [begin, end) of dummies. Errors: none, hot path.
template <class Arch, class Real, int Dim, WallSums What>
void wall_sweep(const WallSweepView<Real>& view, std::int64_t begin, std::int64_t end) {
  for (std::int64_t cluster = begin; cluster < end; ++cluster) {
    if constexpr (What == WallSums::extrapolation) {
      extrapolate_dummies<Arch, Real, Dim>(view, cluster);
    } else if constexpr (What == WallSums::gradient) {
      sum_dummy_gradients<Arch, Real, Dim>(view, cluster);
    } else if constexpr (What == WallSums::weight) {
      sum_dummy_weights<Arch, Real, Dim>(view, cluster);
    } else {
      average_corrected_stress<Arch, Real, Dim>(view, cluster);
    }
  }
}

}  // namespace scarp::kernels
