// SPDX-License-Identifier: BSD-3-Clause
/// Smoothing function of a scene, and the weight of the artificial stress that is made of it.
#pragma once

#include "engine/scene/scene.hpp"
#include "engine/scene/tension_factor_fit.hpp"
#include "kernels/smoothing/list.hpp"

namespace scarp {

inline const kernels::SmoothingForm& smoothing_of(const Numerics& numerics) {
  return kernels::smoothing_functions[static_cast<std::size_t>(numerics.smoothing)];
}

/// F^n of Eq. 20, where no exponent stands for W(0)/W(dx).
inline TensionFactorFit tension_factor_of(const Numerics& numerics) {
  const kernels::SmoothingForm& form = smoothing_of(numerics);
  const double q = 1.0 / numerics.smoothing_ratio;
  return fit_tension_factor(
      form, q, numerics.artificial_stress_exponent.value_or(form.shape(0.0) / form.shape(q)));
}

}  // namespace scarp
