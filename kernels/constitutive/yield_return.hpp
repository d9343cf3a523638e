// SPDX-License-Identifier: BSD-3-Clause
/// Drucker-Prager plasticity at one point: yield function and return.
#pragma once

#include "kernels/particle_view.hpp"
#include "kernels/point_math.hpp"
#include "kernels/tensor.hpp"

namespace scarp::kernels {

/// f = sqrt(J2) + alpha_phi I1 - k_c. Equation: E9.
template <class T>
SCARP_INLINE T yield_function(const StressPassConstants& c, const T& root_j2, const T& i1) {
  return root_j2 + T(c.alpha_phi) * i1 - T(c.k_c);
}

template <class T>
SCARP_INLINE T root_j2(const SymTensor<T>& deviatoric_stress) {
  return root(T(0.5) * contract(deviatoric_stress, deviatoric_stress));
}

/// Puts a trial stress back on the yield surface along the plastic potential, cone or apex, in
/// closed form, and returns the increment of the equivalent deviatoric plastic strain sqrt(2/3 de_p
/// : de_p). Equation: P1; dlambda = f/(G + 9 K alpha_phi alpha_psi), sqrt(J2) -= G dlambda, I1 -= 9
/// K alpha_psi dlambda; if sqrt(J2) would turn negative: I1 = k_c/alpha_phi, s = 0. Limits: exact
/// for one step of any size.
template <class T>
SCARP_INLINE T return_to_yield_surface(const StressPassConstants& c, SymTensor<T>& stress) {
  const T zero(0.0), one(1.0);
  const T i1 = trace(stress);
  SymTensor<T> s = deviator(stress);
  const T j = root_j2(s);
  const T f = yield_function(c, j, i1);
  const auto yields = f > zero;
  if (none_of(yields)) return zero;
  const T multiplier =
      f * T(1.0 / (c.shear_modulus + 9.0 * c.bulk_modulus * c.alpha_phi * c.alpha_psi));
  const T j_returned = j - T(c.shear_modulus) * multiplier;
  const auto to_cone = j_returned >= zero;
  // Without friction there is no apex: j_returned = k_c, which without cohesion too is 0 but for
  // its sign.
  const T apex = c.alpha_phi > 0.0 ? T(c.k_c / c.alpha_phi) : i1;
  const T i1_new = choose(to_cone, i1 - T(9.0 * c.bulk_modulus * c.alpha_psi) * multiplier, apex);
  // j = 0 cannot reach the cone except at the apex, where s = 0 anyway.
  const T shrink = choose(to_cone, j_returned / larger(j, T(1e-300)), zero);
  const T scale = choose(yields, shrink, one);
  const T mean = choose(yields, i1_new, i1) * T(1.0 / 3.0);
  stress = {scale * s.xx + mean, scale * s.yy + mean, scale * s.zz + mean,
            scale * s.xy,        scale * s.yz,        scale * s.zx};
  const T increment =
      choose(to_cone, multiplier, j * T(1.0 / c.shear_modulus)) * T(0.57735026918962576);
  return choose(yields, increment, zero);
}

}  // namespace scarp::kernels
