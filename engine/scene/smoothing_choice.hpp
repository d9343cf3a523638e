// SPDX-License-Identifier: BSD-3-Clause
/// Smoothing function of a scene, and the weight of the artificial stress that is made of it.
#pragma once

#include "engine/scene/scene.hpp"
#include "engine/scene/tension_factor_fit.hpp"
#include "kernels/smoothing/list.hpp"

namespace scarp {

// In 3D the cubic spline stands under pressure at no h/dx that is worth its neighbours, and Yang
// and Liu's function does at 1.3 (T2); in 2D the cubic spline does at 1.2, with the least noise.

/// W, by the dimension where the scene leaves it open.
inline SmoothingFunction smoothing_function_of(const Numerics& numerics, int dimension) {
  if (numerics.smoothing != SmoothingFunction::by_dimension) return numerics.smoothing;
  return dimension == 2 ? SmoothingFunction::cubic_spline : SmoothingFunction::yang_liu;
}
/// h/dx, by the dimension where the scene leaves it open.
inline double smoothing_ratio_of(const Numerics& numerics, int dimension) {
  return numerics.smoothing_ratio.value_or(dimension == 2 ? 1.2 : 1.3);
}

inline const kernels::SmoothingForm& smoothing_of(const Numerics& numerics, int dimension) {
  const SmoothingFunction function = smoothing_function_of(numerics, dimension);
  return kernels::smoothing_functions[static_cast<std::size_t>(function)];
}
inline const kernels::SmoothingForm& smoothing_of(const Scene& scene) {
  return smoothing_of(scene.numerics, scene.dimension);
}
inline double smoothing_ratio_of(const Scene& scene) {
  return smoothing_ratio_of(scene.numerics, scene.dimension);
}

/// The numerics with what the scene leaves open filled in.
inline Numerics filled_in(const Scene& scene) {
  Numerics numerics = scene.numerics;
  numerics.smoothing = smoothing_function_of(numerics, scene.dimension);
  numerics.smoothing_ratio = smoothing_ratio_of(scene);
  return numerics;
}

/// h [m].
inline double smoothing_length_of(const Scene& scene) {
  return smoothing_ratio_of(scene) * scene.spacing;
}

/// F^n of Eq. 20, where no exponent stands for W(0)/W(dx).
inline TensionFactorFit tension_factor_of(const Scene& scene) {
  const kernels::SmoothingForm& form = smoothing_of(scene);
  const double q = 1.0 / smoothing_ratio_of(scene);
  return fit_tension_factor(
      form, q, scene.numerics.artificial_stress_exponent.value_or(form.shape(0.0) / form.shape(q)));
}

}  // namespace scarp
