// SPDX-License-Identifier: BSD-3-Clause
/// Softer soil under the same viscosity.
#include "engine/check/softer_soil.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/check/body_range.hpp"

namespace scarp::check {
namespace {

/// Strain of a column as high as all soil together at its foot, rho g H/M, of the softest material.
double strain_by_weight(const Scene& scene) {
  const std::size_t axis = gravity_axis(scene);
  const auto ranges = body_ranges(scene, axis);
  double low = ranges.front().low, high = ranges.front().high, largest = 0.0;
  for (std::size_t body = 0; body < ranges.size(); ++body) {
    const Material& soil = scene.materials[material_of(scene, scene.bodies[body])];
    low = std::min(low, ranges[body].low);
    high = std::max(high, ranges[body].high);
    largest = std::max(largest, soil.density / soil.model.moduli().wave_modulus());
  }
  return largest * std::abs(scene.gravity[axis]) * (high - low);
}

}  // namespace

std::optional<std::string> softer_soil_note(const Scene& scene, double wall_s) {
  constexpr double long_run = 600.0, highest_strain = 2e-3, share = 0.25;
  constexpr double highest_alpha = 1.0;  // from there on it would set the time step
  const double alpha = scene.numerics.viscosity_alpha / std::sqrt(share);
  if (!(wall_s > long_run) || scene.bodies.empty() || alpha > highest_alpha) return {};
  const bool all_yield =
      std::all_of(scene.bodies.begin(), scene.bodies.end(), [&scene](const Body& body) {
        return scene.materials[material_of(scene, body)].model.yields();
      });
  const double strain = strain_by_weight(scene);
  if (!all_yield || strain == 0.0 || strain > share * highest_strain) return {};
  return fmt::format(
      "the stiffness of the soil sets the time step, and its weight strains it by {:.2g} % only. "
      "Where what counts is how far soil runs out, try a quarter of youngs_modulus with "
      "viscosity_alpha = {:g}, which is the same viscosity: half of the steps, and run-outs that "
      "differ by some per cent (THEORY.md, section 3). Settlements and slopes near their limit "
      "need the stiffness that they have.",
      100.0 * strain, alpha);
}

}  // namespace scarp::check
