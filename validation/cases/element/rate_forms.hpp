// SPDX-License-Identifier: BSD-3-Clause
/// The paper's rate form of plasticity, alone and with Bui's corrections, at one point. No run of
/// the engine uses it.
#pragma once

#include <string_view>
#include <vector>

#include "engine/element/element_path.hpp"
#include "kernels/tensor.hpp"
#include "validation/cases/element/closed_forms.hpp"

namespace scarp::validation {

enum class RateForm { rate, rate_corrected };
constexpr std::string_view name_of(RateForm form) {
  return form == RateForm::rate ? "rate" : "rate_corrected";
}

/// f = sqrt(J2) + alpha_phi I1 - k_c [Pa]. Equation: E9.
double yield_function(const PlasticSoil& soil, const kernels::SymTensor<double>& stress);

/// The stress one increment of strain without rotation later: Hooke's law, less the plastic part
/// where `stress` is outside the yield surface, then the corrections if the form has them.
/// Equation: E13, E22, P2; the multiplier is held >= 0, since Eq. 22 turns negative on unloading.
kernels::SymTensor<double> rate_step(const PlasticSoil& soil, RateForm form,
                                     const kernels::SymTensor<double>& strain_increment,
                                     kernels::SymTensor<double> stress);

/// Triaxial compression to the axial strain `strain` in equal steps under the lateral pressure `b`
/// [Pa]: the start, then one sample for each step. Errors: Error where no lateral strain holds the
/// pressure.
std::vector<ElementSample> triaxial_by_rate(const PlasticSoil& soil, RateForm form, double b,
                                            double strain, int steps);

}  // namespace scarp::validation
