// SPDX-License-Identifier: BSD-3-Clause
/// Distance and smoothing-function gradient of a pair, shared by all pair terms.
#pragma once

#include "kernels/pair/term.hpp"
#include "kernels/particle_view.hpp"
#include "kernels/simd.hpp"

namespace scarp::kernels {

/// Particle i in every lane: what the pair terms need of it, loaded once per cluster.
template <class B>
struct ParticleLanes {
  B position[3], velocity[3], density, sound_speed, diffusivity;
  B strain_rate[6];       ///< times h/2; where the hourglass viscosity is summed
  std::int32_t material;  ///< of all; where the soil has several
};

/// What the first stage of a pair leaves for the second: as little as possible, since it is kept
/// for a whole block of entries.
template <class B, int Dim>
struct PairGeometry {
  B offset[Dim];       ///< (x_i - x_j)/h
  B gradient;          ///< times `offset` it is V_j grad_i W [1/m]
  B distance_squared;  ///< (r/h)^2
  /// 1/(((r/h)^2 + 0.01)(rho_i + rho_j)), the denominators of Eq. 26, where a term needs the
  /// densities; else 1/((r/h)^2 + 0.01).
  B inverse_regularised;
  B tension_factor;   ///< F^n of the artificial stress
  B smoothing_value;  ///< W in the scaling of SmoothingView::value
};

/// What the second stage adds to it.
template <class B, int Dim>
struct PairMotion {
  B velocity[Dim];         ///< v_i - v_j
  B density;               ///< rho_j
  B approach;              ///< velocity . offset
  B volume_gradient[Dim];  ///< V_j grad_i W [1/m]
};

/// Position of component (a, b) among xx, yy, zz, xy, yz, zx.
inline constexpr int tensor_index[3][3] = {{xx, xy, zx}, {xy, yy, yz}, {zx, yz, zz}};

/// The same for indices of a loop. A table of its own: one that several objects share would be
/// taken from any of them.
SCARP_INLINE constexpr int tensor_place(int a, int b) {
  constexpr int places[3][3] = {{xx, xy, zx}, {xy, yy, yz}, {zx, yz, zz}};
  return places[a][b];
}

/// The stored components of a tensor whose first four are in one quad.
template <int Dim, class Quad, class B>
SCARP_INLINE void take_tensor(const Quad& first, const Quad& second, B (&out)[6]) {
  unrolled<4>([&](auto c) SCARP_LAMBDA { out[c] = first(c); });
  if constexpr (Dim == 3) unrolled<2>([&](auto c) SCARP_LAMBDA { out[4 + c] = second(c); });
}

/// Added to (r/h)^2: keeps the self-pair and coincident particles finite (their offset makes them
/// 0), and is so small that no other pair feels it, not by one rounding.
template <class Real>
inline constexpr Real closest = Real(1e-30);

/// b = max(2-q, 0) and a = max(1-q, 0), which all functions of distance are written in.
template <class B>
struct TruncatedPowers {
  B outer, outer_squared, inner, inner_squared;

  SCARP_INLINE explicit TruncatedPowers(const B& q)
      : outer(above_zero(B(Real(2)) - q)),
        outer_squared(outer * outer),
        inner(above_zero(B(Real(1)) - q)),
        inner_squared(inner * inner) {}

 private:
  using Real = typename B::value_type;
  static SCARP_INLINE B above_zero(const B& x) { return max(x, B(Real(0))); }
};

/// c[0] + c[1] x + ... in Horner's scheme.
template <class B, class Real, std::size_t Count>
SCARP_INLINE B polynomial(const B& x, const Real (&c)[Count]) {
  B sum(c[Count - 1]);
  unrolled<static_cast<int>(Count) - 1>(
      [&](auto k) SCARP_LAMBDA { sum = fma(sum, x, B(c[Count - 2 - k])); });
  return sum;
}

/// dW/dq in truncated powers. Equation: E25, S1, S2.
template <class B, class Real>
SCARP_INLINE B smoothing_slope(const TruncatedPowers<B>& at, const SmoothingView<Real>& s) {
  return fma(polynomial(at.outer, s.derivative), at.outer_squared,
             B(s.derivative_inner) * at.inner_squared);
}

/// W h^d / alpha_D in the scaling of `s.value`.
template <class B, class Real>
SCARP_INLINE B smoothing_value(const TruncatedPowers<B>& at, const SmoothingView<Real>& s) {
  return fma(polynomial(at.outer, s.value), at.outer_squared * at.outer,
             B(s.value_inner) * (at.inner_squared * at.inner));
}

/// F^n with F = W(r)/W(dx), fitted in the truncated powers of W itself: `pow` would cost more than
/// the rest of the pair. Error over the greater of F^n and F^n(dx) = 1 (tested): 2e-7, 7e-6 and
/// 1.5e-4 for Yang & Liu, the cubic spline and Wendland C2 with n = 2.55 at h = 1.2 dx;
/// `fit_tension_factor` returns it.
template <class B, class Real>
SCARP_INLINE B tension_factor(const TruncatedPowers<B>& at, const TensionFactorView<Real>& c) {
  return fma(polynomial(at.inner, c.inner), at.inner_squared * at.inner,
             polynomial(at.outer, c.outer) * at.outer_squared);
}

/// First stage of a pair with `offset` set: all else of its geometry that is needed. `densities` is
/// called for rho_i + rho_j where a term wants it.
template <PairNeeds Needs, class B, int Dim, class Real, class Densities>
SCARP_INLINE void complete_geometry(PairGeometry<B, Dim>& pair, const B& volume_j,
                                    [[maybe_unused]] Densities&& densities,
                                    const PairConstants<Real>& constants) {
  B squared(closest<Real>);
  unrolled<Dim>([&](auto a)
                    SCARP_LAMBDA { squared = fma(pair.offset[a], pair.offset[a], squared); });
  pair.distance_squared = squared;
  const B inverse_distance = inverse_sqrt(squared);
  const TruncatedPowers<B> powers(squared * inverse_distance);
  pair.gradient = volume_j * smoothing_slope(powers, constants.smoothing) * inverse_distance;
  if constexpr (Needs.tension_factor)
    pair.tension_factor = tension_factor(powers, constants.tension_factor);
  if constexpr (Needs.smoothing_value)
    pair.smoothing_value = kernels::smoothing_value(powers, constants.smoothing);
  if constexpr (Needs.densities) {
    pair.inverse_regularised = inverse((squared + B(Real(0.01))) * densities());
  } else if constexpr (Needs.regularised) {
    pair.inverse_regularised = inverse(squared + B(Real(0.01)));
  }
}

/// Second stage of a pair with velocity v_i - v_j and density set: the gradient and the approach.
template <class B, int Dim>
SCARP_INLINE void complete_motion(const PairGeometry<B, Dim>& pair, PairMotion<B, Dim>& motion) {
  unrolled<Dim>([&](auto a)
                    SCARP_LAMBDA { motion.volume_gradient[a] = pair.gradient * pair.offset[a]; });
  motion.approach = motion.velocity[0] * pair.offset[0];
  unrolled<Dim - 1>([&](auto a) SCARP_LAMBDA {
    motion.approach = fma(motion.velocity[a + 1], pair.offset[a + 1], motion.approach);
  });
}

}  // namespace scarp::kernels
