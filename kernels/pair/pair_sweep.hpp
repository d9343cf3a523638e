// SPDX-License-Identifier: BSD-3-Clause
/// The pair sweep: all pair terms of a scene in one loop over the neighbours of clusters of
/// particles.
#pragma once

#include "kernels/neighbour_block.hpp"
#include "kernels/pair/artificial_stress.hpp"
#include "kernels/pair/cluster_lanes.hpp"
#include "kernels/pair/continuity.hpp"
#include "kernels/pair/momentum.hpp"
#include "kernels/pair/pair_geometry.hpp"
#include "kernels/pair/stress_diffusion.hpp"
#include "kernels/pair/velocity_gradient.hpp"
#include "kernels/pair/viscosity.hpp"

namespace scarp::kernels {

/// What a sweep is compiled for; what is off costs neither instructions nor memory.
template <int Dimension, Terms Which, bool UseViscosity, bool UseArtificialStress,
          bool UseCorrection, bool UseDiffusion, bool UseContinuity>
struct SweepTraits {
  static constexpr int dimension = Dimension;
  static constexpr bool gradient = Which != Terms::force;
  static constexpr bool continuity = gradient && UseContinuity;
  static constexpr bool force = Which != Terms::gradient;
  static constexpr bool viscosity = force && UseViscosity;
  static constexpr bool artificial_stress = force && UseArtificialStress;
  static constexpr bool correction = gradient && UseCorrection;
  static constexpr bool diffusion = gradient && UseDiffusion;
};

/// One cluster of particles in the lanes of a vector, twice: the lower half meets the even, the
/// upper half the odd entries of the list. Blocks of eight entries are staged, first geometry, then
/// accumulation, so that four independent chains hide the latency of each other.
template <class Arch, class Real, class Traits>
class ClusterSweep {
  static constexpr int dim = Traits::dimension;
  static constexpr int half = cluster_size<Real, Arch>;
  static constexpr int stages = entry_block / 2;
  static constexpr int prefetch_distance = 2;  ///< blocks
  static constexpr int density_place = record_density - record_velocity_x;
  using B = Batch<Real, Arch>;
  using Quad = RecordQuad<Real, Arch>;
  using Pair = PairGeometry<B, dim>;

 public:
  SCARP_INLINE ClusterSweep(const PairSweepView<Real>& view, std::int64_t cluster)
      : view_(view), cluster_{cluster * half} {
    i_.density = own(record_density);
    i_.sound_speed = own(record_sound_speed);
    i_.diffusivity = own(record_diffusivity);
    for (int a = 0; a < dim; ++a) {
      i_.position[a] = own(record_x + a);
      i_.velocity[a] = own(record_velocity_x + a);
    }
    if constexpr (Traits::artificial_stress) {
      for (int l = 0; l < half; ++l)
        cluster_in_tension_ |= view.tension != nullptr && view.tension[cluster_.first + l] != 0;
    }
  }

  template <bool Wall>
  SCARP_INLINE void add_blocks(std::int64_t begin, std::int64_t end) {
    for (std::int64_t block = begin; block < end; ++block) {
      prefetch(block + prefetch_distance);  // lists end in empty blocks: this one exists
      const NeighbourBlock j(view_.neighbours, block);
      if constexpr (Traits::artificial_stress) {
        if (block_has_tension(j)) {
          add_block<Wall, true>(j);
          continue;
        }
      }
      add_block<Wall, false>(j);
    }
  }

  SCARP_INLINE void store() {
    if constexpr (Traits::continuity) put(view_.density_rate, continuity_.density_rate);
    if constexpr (Traits::gradient) {
      for (int a = 0; a < dim; ++a) {
        for (int b = 0; b < dim; ++b) {
          put(view_.velocity_gradient[3 * a + b], -gradient_.minus_gradient[a * dim + b]);
        }
      }
    }
    if constexpr (Traits::correction) {
      constexpr int component[2][6] = {{xx, xy, yy}, {xx, xy, zx, yy, yz, zz}};
      for (int k = 0; k < dim * (dim + 1) / 2; ++k) {
        put(view_.moment[component[dim - 2][k]],
            -moment_.minus_moment[k] * B(Real(view_.smoothing_length)));
      }
    }
    if constexpr (Traits::diffusion) {
      for (int c = 0; c < StressDiffusion<B, dim>::components; ++c) {
        cluster_.put(view_.diffusion_rate[c],
                     xsimd::fms(own(record_stress + c), cluster_.fold(diffusion_.weight_sum),
                                cluster_.fold(diffusion_.weighted_stress[c])));
      }
      put(view_.diffusion_slope, diffusion_.slope);
    }
    if constexpr (Traits::force) store_acceleration();
    if constexpr (Traits::viscosity)
      cluster_.put(view_.approach_rate, cluster_.fold(-viscosity_.lowest_mu, true));
  }

 private:
  /// One value of each of the cluster's own records.
  SCARP_INLINE B own(int slot) const { return cluster_.load(view_.records, record_size, slot); }
  SCARP_INLINE void put(double* out, const B& sum) const { cluster_.put(out, cluster_.fold(sum)); }

  /// Fetches the records of a block. Padding asks for one past the page, which is harmless and
  /// cheaper than telling it from neighbours.
  SCARP_INLINE void prefetch(std::int64_t block) const {
    constexpr int line = 64 / sizeof(Real);
    const std::uint16_t* place = view_.neighbours.place + block * entry_block;
    const std::int64_t page = view_.neighbours.page[block];
    for (int entry = 0; entry < entry_block; ++entry) {
      const std::int64_t k = page + place[entry];
      for (int value = 0; value < record_size; value += line)
        __builtin_prefetch(view_.records + k * record_size + value);
      if constexpr (Traits::artificial_stress) {
        if (view_.tension != nullptr)
          __builtin_prefetch(view_.tension_records + k * tension_record_size);
      }
    }
  }

  /// Four values of two records from slot `First` on.
  template <int First>
  SCARP_INLINE Quad quad(std::int32_t low, std::int32_t high) const {
    return Quad(view_.records + std::int64_t{low} * record_size + First,
                view_.records + std::int64_t{high} * record_size + First);
  }

  template <bool Wall, bool Tension>
  SCARP_INLINE void add_block(const NeighbourBlock& j) {
    Pair pairs[stages];
    B factor[stages];  // of the artificial stress
    unrolled<stages>([&](auto s) SCARP_LAMBDA {
      pairs[s] = geometry<Tension>(j.record[2 * s], j.record[2 * s + 1], factor[s]);
    });
    unrolled<stages>([&](auto s) SCARP_LAMBDA {
      accumulate<Wall, Tension>(pairs[s], j.record[2 * s], j.record[2 * s + 1], factor[s]);
    });
  }

  template <bool Tension>
  SCARP_INLINE Pair geometry(std::int32_t low, std::int32_t high,
                             [[maybe_unused]] B& factor) const {
    const Quad where = quad<record_x>(low, high);
    Pair pair;
    B squared(closest<Real>);
    unrolled<dim>([&](auto a) SCARP_LAMBDA {
      pair.offset[a] = position_difference<Arch>(i_.position[a], where(a));
      squared = xsimd::fma(pair.offset[a], pair.offset[a], squared);
    });
    pair.distance_squared = squared;
    const B inverse_distance = inverse_sqrt(squared);
    const TruncatedPowers<B> powers(squared * inverse_distance);
    pair.gradient = where(constant<record_volume - record_x>) *
                    smoothing_slope(powers, view_.constants.smoothing) * inverse_distance;
    if constexpr (Tension) factor = tension_factor(powers, view_.constants.tension_factor);
    if constexpr (Traits::viscosity) {
      const B density = quad<record_velocity_x>(low, high)(constant<density_place>);
      pair.inverse_regularised = inverse((squared + B(Real(0.01))) * (i_.density + density));
    } else if constexpr (Traits::diffusion) {
      pair.inverse_regularised = inverse(squared + B(Real(0.01)));
    }
    return pair;
  }

  SCARP_INLINE PairMotion<B, dim> motion(const Pair& pair, std::int32_t low,
                                         std::int32_t high) const {
    const Quad moving = quad<record_velocity_x>(low, high);
    PairMotion<B, dim> m;
    m.density = moving(constant<density_place>);
    unrolled<dim>([&](auto a) SCARP_LAMBDA {
      m.volume_gradient[a] = pair.gradient * pair.offset[a];
      m.velocity[a] = i_.velocity[a] - moving(a);
    });
    m.approach = m.velocity[0] * pair.offset[0];
    unrolled<dim - 1>([&](auto a) SCARP_LAMBDA {
      m.approach = xsimd::fma(m.velocity[a + 1], pair.offset[a + 1], m.approach);
    });
    return m;
  }

  template <bool Wall, bool Tension>
  SCARP_INLINE void accumulate(const Pair& pair, std::int32_t low, std::int32_t high,
                               [[maybe_unused]] const B& factor) {
    const PairMotion<B, dim> m = motion(pair, low, high);
    const Quad stresses = quad<record_stress>(low, high), more = quad<record_stress + 4>(low, high);
    B stress[6];
    if constexpr (Traits::force || (Traits::diffusion && !Wall))
      take_tensor<dim>(stresses, more, stress);
    if constexpr (Traits::continuity) continuity_.add(pair, m);
    if constexpr (Traits::gradient) gradient_.add(m);
    if constexpr (Traits::correction) moment_.add(pair, m);
    if constexpr (Traits::diffusion && !Wall) {
      B regularised = pair.inverse_regularised;
      if constexpr (Traits::viscosity) regularised *= i_.density + m.density;
      diffusion_.add(pair, i_, more(constant<record_diffusivity - record_stress - 4>), regularised,
                     stress, view_.constants.gravity);
    }
    if constexpr (Tension) add_tension(m, low, high, factor, stress);
    if constexpr (Traits::force) momentum_.add(stress, m.volume_gradient);
    if constexpr (Traits::viscosity) {
      viscosity_.add(pair, m, i_, more(constant<record_sound_speed - record_stress - 4>),
                     view_.constants.viscosity_alpha, view_.constants.viscosity_beta,
                     momentum_.force);
    }
  }

  SCARP_INLINE void add_tension(const PairMotion<B, dim>& m, std::int32_t low, std::int32_t high,
                                const B& factor, B (&stress)[6]) {
    const Real* p = view_.tension_records + std::int64_t{low} * tension_record_size;
    const Real* r = view_.tension_records + std::int64_t{high} * tension_record_size;
    B tension_j[6];
    take_tensor<dim>(Quad(p, r), Quad(p + 4, r + 4), tension_j);
    artificial_stress_.add(m, i_, factor, tension_j, stress);
  }

  /// True if any entry of the block or any particle of the cluster is in tension.
  SCARP_INLINE bool block_has_tension(const NeighbourBlock& j) const {
    if (view_.tension == nullptr || cluster_in_tension_) return cluster_in_tension_;
    unsigned any = 0;
    for (const std::int32_t k : j.record) any |= view_.tension[k];
    return any != 0;
  }

  SCARP_INLINE void store_acceleration() const {
    B stress_i[6], tension_i[6];
    for (int c = 0; c < (dim == 2 ? 4 : 6); ++c) stress_i[c] = own(record_stress + c);
    const bool tension = Traits::artificial_stress && view_.tension != nullptr;
    if (tension) {
      for (int c = 0; c < (dim == 2 ? 4 : 6); ++c)
        tension_i[c] = cluster_.load(view_.tension_records, tension_record_size, c);
    }
    // Lanes of padding have density 1, so the quotient is finite.
    const B scale = B(Real(1)) / i_.density;
    B sums[dim], weighted[dim];
    for (int a = 0; a < dim; ++a) sums[a] = cluster_.fold(momentum_.gradient_sum[a]);
    if constexpr (Traits::artificial_stress) {
      for (int a = 0; a < dim; ++a)
        weighted[a] = cluster_.fold(artificial_stress_.weighted_gradient_sum[a]);
    }
    for (int a = 0; a < dim; ++a) {
      B total = cluster_.fold(momentum_.force[a]);
      for (int b = 0; b < dim; ++b) {
        total = xsimd::fma(stress_i[tensor_index[a][b]], sums[b], total);
        if constexpr (Traits::artificial_stress) {
          // The record holds rho_i R_i, which is what E20 times rho_i asks for.
          if (tension) total = xsimd::fma(tension_i[tensor_index[a][b]], weighted[b], total);
        }
      }
      cluster_.put(view_.acceleration[a], total * scale);
    }
  }

  struct Nothing {};
  template <bool Used, class T>
  using If = std::conditional_t<Used, T, Nothing>;

  const PairSweepView<Real>& view_;
  ClusterLanes<Real, Arch> cluster_;
  bool cluster_in_tension_ = false;
  ParticleLanes<B> i_;
  If<Traits::continuity, Continuity<B>> continuity_;
  If<Traits::gradient, VelocityGradient<B, dim>> gradient_;
  If<Traits::correction, GradientMoment<B, dim>> moment_;
  If<Traits::diffusion, StressDiffusion<B, dim>> diffusion_;
  If<Traits::force, Momentum<B, dim>> momentum_;
  If<Traits::viscosity, Viscosity<B>> viscosity_;
  If<Traits::artificial_stress, ArtificialStress<B, dim>> artificial_stress_;
};

/// Sweeps clusters [begin, end): reads records and lists, writes the rates of their particles.
/// Pre: lists are followed by two empty blocks, records by the far record. Errors: none, hot path.
/// Accuracy: 64 eps x neighbours of the largest term (tested).
template <class Arch, class Real, class Traits>
void pair_sweep(const PairSweepView<Real>& view, std::int64_t begin, std::int64_t end) {
  const NeighbourView& lists = view.neighbours;
  for (std::int64_t cluster = begin; cluster < end; ++cluster) {
    ClusterSweep<Arch, Real, Traits> sweep(view, cluster);
    sweep.template add_blocks<false>(lists.soil_begin[cluster], lists.wall_begin[cluster]);
    if (lists.wall_begin[cluster] != lists.soil_begin[cluster + 1]) {
      sweep.template add_blocks<true>(lists.wall_begin[cluster], lists.soil_begin[cluster + 1]);
    }
    sweep.store();
  }
}

}  // namespace scarp::kernels
