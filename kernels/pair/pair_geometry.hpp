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
  B density;           ///< rho_j
  B distance_squared;  ///< (r/h)^2
  /// 1/(((r/h)^2 + 0.01)(rho_i + rho_j)), the denominators of Eq. 26; without viscosity
  /// 1/((r/h)^2 + 0.01).
  B inverse_regularised;
};

/// What the second stage adds to it.
template <class B, int Dim>
struct PairMotion {
  B velocity[Dim];         ///< v_i - v_j
  B approach;              ///< velocity . offset
  B volume_gradient[Dim];  ///< V_j grad_i W [1/m]
};

/// Added to (r/h)^2: keeps the self-pair and coincident particles finite (their offset makes them
/// 0), and is so small that no other pair feels it, not by one rounding.
template <class Real>
inline constexpr Real closest = Real(1e-30);

/// dW/dq in truncated powers. Equation: E25, S1, S2.
template <class B, class Real>
SCARP_INLINE B smoothing_slope(const B& q, const SmoothingView<Real>& s) {
  const B zero(Real(0));
  const B b = xsimd::max(B(Real(2)) - q, zero), a = xsimd::max(B(Real(1)) - q, zero);
  const B outer =
      xsimd::fma(b, xsimd::fma(b, B(s.derivative[2]), B(s.derivative[1])), B(s.derivative[0]));
  return xsimd::fma(outer, b * b, B(s.derivative_inner) * (a * a));
}

/// W h^d / alpha_D in the scaling of `s.value`.
template <class B, class Real>
SCARP_INLINE B smoothing_value(const B& q, const SmoothingView<Real>& s) {
  const B zero(Real(0));
  const B b = xsimd::max(B(Real(2)) - q, zero), a = xsimd::max(B(Real(1)) - q, zero);
  const B outer = xsimd::fma(b, xsimd::fma(b, B(s.value[2]), B(s.value[1])), B(s.value[0]));
  return xsimd::fma(outer, b * b * b, B(s.value_inner) * (a * a * a));
}

}  // namespace scarp::kernels
