// SPDX-License-Identifier: BSD-3-Clause
/// Plain scalar steps of the rate forms.
#include "validation/cases/element/rate_forms.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/errors.hpp"

namespace scarp::validation {
namespace {

using Stress = kernels::SymTensor<double>;

double root_j2(const Stress& deviatoric) {
  return std::sqrt(0.5 * contract(deviatoric, deviatoric));
}

Stress hooke(const PlasticSoil& soil, const Stress& strain) {
  return 2.0 * soil.shear_modulus * deviator(strain) +
         kernels::isotropic(soil.bulk_modulus * trace(strain));
}

/// What the flow takes from the stress. The test of the corrected form is widened by 1e-6 of the
/// strength, for stresses that a correction has just put on the surface.
Stress plastic_part(const PlasticSoil& soil, RateForm form, const Stress& strain,
                    const Stress& stress) {
  const Stress s = deviator(stress);
  const double j = std::fmax(root_j2(s), 1e-30);  // so that G/j stays finite
  const double margin =
      form == RateForm::rate_corrected ? 1e-6 * soil.strength(trace(stress)) : 0.0;
  if (!(j - soil.strength(trace(stress)) > -margin)) return {};
  const double a = soil.alpha_phi, b = soil.alpha_psi, k = soil.bulk_modulus,
               g = soil.shear_modulus;
  const double full =
      (3.0 * a * k * trace(strain) + g / j * contract(s, strain)) / (9.0 * a * b * k + g);
  const double multiplier = std::fmax(full, 0.0);
  return kernels::isotropic(multiplier * 3.0 * b * k) + multiplier * g / j * s;
}

/// Normal stresses are shifted back to the apex, then the deviator is scaled back to the surface at
/// constant I1. Equation: P2; Bui et al. (2008).
Stress corrected(const PlasticSoil& soil, Stress stress) {
  if (soil.alpha_phi > 0.0) {
    const double excess = std::fmax(trace(stress) - soil.k_c / soil.alpha_phi, 0.0);
    stress = stress - kernels::isotropic(excess / 3.0);
  }
  const double i1 = trace(stress), strength = std::fmax(soil.strength(i1), 0.0);
  const Stress s = deviator(stress);
  const double j = root_j2(s);
  return j > strength ? kernels::isotropic(i1 / 3.0) + strength / j * s : stress;
}

ElementSample sample_of(const PlasticSoil& soil, const Stress& stress, const Stress& strain) {
  ElementSample sample;
  sample.strain = {strain.xx, strain.yy, strain.zz, 0.0, 0.0, 0.0};
  sample.stress = {stress.xx, stress.yy, stress.zz, 0.0, 0.0, 0.0};
  sample.first_invariant = trace(stress);
  sample.root_j2 = root_j2(deviator(stress));
  sample.yield_function = yield_function(soil, stress);
  sample.volumetric_strain = trace(strain);
  return sample;
}

}  // namespace

double yield_function(const PlasticSoil& soil, const Stress& stress) {
  return root_j2(deviator(stress)) - soil.strength(trace(stress));
}

Stress rate_step(const PlasticSoil& soil, RateForm form, const Stress& strain_increment,
                 Stress stress) {
  stress =
      stress + hooke(soil, strain_increment) - plastic_part(soil, form, strain_increment, stress);
  return form == RateForm::rate_corrected ? corrected(soil, stress) : stress;
}

std::vector<ElementSample> triaxial_by_rate(const PlasticSoil& soil, RateForm form, double b,
                                            double strain, int steps) {
  const double axial = -strain / steps;
  const auto increment = [axial](double lateral) {
    return Stress{lateral, axial, lateral, 0.0, 0.0, 0.0};
  };
  Stress stress = kernels::isotropic(-b), total{};
  std::vector<ElementSample> samples{sample_of(soil, stress, total)};
  for (int n = 1; n <= steps; ++n) {
    double low = -3.0 * std::fabs(axial), high = -low;
    for (int halving = 0; halving < 60; ++halving) {
      const double middle = 0.5 * (low + high);
      (rate_step(soil, form, increment(middle), stress).xx > -b ? high : low) = middle;
    }
    const Stress step = increment(0.5 * (low + high));
    stress = rate_step(soil, form, step, stress);
    total = total + step;
    if (!(std::fabs(stress.xx + b) <= 1e-6 * b)) {
      throw Error(fmt::format("step {} of {}: no lateral strain holds the stress at {:g} Pa", n,
                              steps, -b));
    }
    samples.push_back(sample_of(soil, stress, total));
  }
  return samples;
}

}  // namespace scarp::validation
