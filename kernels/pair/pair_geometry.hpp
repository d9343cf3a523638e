// SPDX-License-Identifier: BSD-3-Clause
/// Distance and smoothing-function gradient of a pair, shared by all pair terms.
#pragma once

#include "kernels/particle_view.hpp"
#include "kernels/simd.hpp"

namespace scarp::kernels {

/// Particle i in every lane: what the pair terms need of it, loaded once per cluster.
template <class B>
struct ParticleLanes {
  B position[3], velocity[3], density, sound_speed, diffusivity;
};

/// What the first stage of a pair leaves for the second: as little as possible, since it is kept
/// for a whole block of entries.
template <class B, int Dim>
struct PairGeometry {
  B offset[Dim];       ///< (x_i - x_j)/h
  B gradient;          ///< times `offset` it is V_j grad_i W [1/m]
  B distance_squared;  ///< (r/h)^2
  /// 1/(((r/h)^2 + 0.01)(rho_i + rho_j)), the denominators of Eq. 26; without viscosity
  /// 1/((r/h)^2 + 0.01).
  B inverse_regularised;
};

/// What the second stage adds to it.
template <class B, int Dim>
struct PairMotion {
  B velocity[Dim];         ///< v_i - v_j
  B density;               ///< rho_j
  B approach;              ///< velocity . offset
  B volume_gradient[Dim];  ///< V_j grad_i W [1/m]
};

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
  static SCARP_INLINE B above_zero(const B& x) { return xsimd::max(x, B(Real(0))); }
};

/// c[0] + c[1] x + ... in Horner's scheme.
template <class B, class Real, std::size_t Count>
SCARP_INLINE B polynomial(const B& x, const Real (&c)[Count]) {
  B sum(c[Count - 1]);
  unrolled<static_cast<int>(Count) - 1>(
      [&](auto k) SCARP_LAMBDA { sum = xsimd::fma(sum, x, B(c[Count - 2 - k])); });
  return sum;
}

/// dW/dq in truncated powers. Equation: E25, S1, S2.
template <class B, class Real>
SCARP_INLINE B smoothing_slope(const TruncatedPowers<B>& at, const SmoothingView<Real>& s) {
  return xsimd::fma(polynomial(at.outer, s.derivative), at.outer_squared,
                    B(s.derivative_inner) * at.inner_squared);
}

/// W h^d / alpha_D in the scaling of `s.value`.
template <class B, class Real>
SCARP_INLINE B smoothing_value(const TruncatedPowers<B>& at, const SmoothingView<Real>& s) {
  return xsimd::fma(polynomial(at.outer, s.value), at.outer_squared * at.outer,
                    B(s.value_inner) * (at.inner_squared * at.inner));
}

}  // namespace scarp::kernels
