// SPDX-License-Identifier: BSD-3-Clause
/// Findings about soil that is too soft or cannot yield, and numerics known not to work together.
#include "engine/check/warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/check/lattice_warning.hpp"
#include "engine/check/magnitudes.hpp"
#include "engine/check/thin_places.hpp"
#include "engine/check/thin_walls.hpp"
#include "engine/check/wall_gaps.hpp"

namespace scarp {
namespace {

/// Soil without strength runs out into files of grains; pressed against a smooth wall by half a
/// spacing these are twice as stiff as the lattice where forces are corrected (THEORY, section 10).
const char* spreads_thin(const Numerics& n) {
  const bool stiff = n.corrects_force() && n.cfl > 0.4;
  return stiff
             ? ", and spreads until it is one grain thin, which needs shorter steps. Try cfl = 0.4"
             : "";
}

void check_strength(const Scene& scene, const Material& material, std::vector<std::string>& found) {
  const SoilModel& model = material.model;
  if (const auto doubt = model.info().doubt(model.parameters(), scene.dimension)) {
    found.push_back(fmt::format("material '{}': {}: {}", material.name,
                                model.info().parameters[doubt->parameter].name, doubt->why));
  }
  const auto strength = model.strength();
  if (strength && strength->cohesion == 0.0 && strength->friction_angle == 0.0) {
    found.push_back(fmt::format(
        "material '{}': cohesion and friction angle are 0, so it has no strength at all{}.",
        material.name, spreads_thin(scene.numerics)));
  }
}

/// The material with the fastest sound sets the step for all. Where it hardly moves, more inertia
/// will do, without a change at rest. Where it only carries, a hundred times the stiffness of the
/// softest will: under the same stress it strains a hundredth as much.
void check_contrast(const Scene& scene, std::vector<std::string>& found) {
  constexpr double several = 10.0, much = 1000.0, enough = 100.0;
  const Material *soft = nullptr, *fast = nullptr, *next = nullptr;
  const auto stiffness = [](const Material& m) { return m.model.moduli().wave_modulus(); };
  const auto faster = [](const Material& a, const Material* b) {
    return b == nullptr || a.sound_speed() > b->sound_speed();
  };
  for (std::size_t m = 0; m < scene.materials.size(); ++m) {
    if (!is_used(scene, m)) continue;
    const Material& material = scene.materials[m];
    if (soft == nullptr || stiffness(material) < stiffness(*soft)) soft = &material;
    if (faster(material, fast))
      next = std::exchange(fast, &material);
    else if (faster(material, next))
      next = &material;
  }
  if (next == nullptr) return;
  const double times = fast->sound_speed() / next->sound_speed();
  if (times < several) return;
  std::string text = fmt::format(
      "material '{}' makes the time step {:.3g} times shorter than '{}' needs. Where it hardly "
      "moves "
      "and does not lie on soft soil (bedrock), try mass_scaling = {:.3g}: a step {:.3g} times "
      "longer, with the "
      "same weight and the same stress at rest; what moves of it falls and swings {:.3g} times "
      "more slowly.",
      fast->name, times, next->name, fast->mass_scaling * times * times, times,
      times * std::sqrt(fast->mass_scaling));
  const double contrast = stiffness(*fast) / stiffness(*soft);
  if (contrast >= much) {
    text += fmt::format(
        " Or, where it only carries, a Young's modulus of {:.3g} times its own: {:.2g} times fewer "
        "steps; under the same stress it then strains {:.0f} % as much as '{}', instead of {:.2g} "
        "%.",
        enough / contrast, std::sqrt(contrast / enough), 100.0 / enough, soft->name,
        100.0 / contrast);
  }
  found.push_back(std::move(text));
}

/// Soil that yields may come to move.
void check_scaling(const Material& material, std::vector<std::string>& found) {
  if (material.mass_scaling == 1.0 || !material.model.yields()) return;
  found.push_back(
      fmt::format("material '{}': it yields, and mass_scaling = {:.3g} lets it slide and fall "
                  "{:.3g} times more "
                  "slowly than soil does. That is right only where it does not fail. Try model = "
                  "\"linear_elastic\" for what only carries, or without mass_scaling.",
                  material.name, material.mass_scaling, std::sqrt(material.mass_scaling)));
}

}  // namespace

std::vector<std::string> warnings(const Scene& scene) {
  std::vector<std::string> found;
  for (const Material& material : scene.materials) {
    check_strength(scene, material, found);
    check_scaling(material, found);
  }
  check_magnitudes(scene, found);
  for (std::size_t m = 0; m < scene.materials.size(); ++m) {
    if (!is_used(scene, m)) {
      found.push_back(
          fmt::format("material '{}': no body is made of it.", scene.materials[m].name));
    }
  }
  check_contrast(scene, found);
  check_lattice(scene, found);
  for (std::string& gap : wall_gaps(scene)) found.push_back(std::move(gap));
  for (std::string& twice : doubled_walls(scene)) found.push_back(std::move(twice));
  for (std::string& place : thin_places(scene)) found.push_back(std::move(place));
  // With corrected gradients a slope still creeps after its slide at 0.6 (THEORY, section 3).
  const double highest = scene.numerics.gradient_correction ? 0.3 : 0.8;
  if (scene.numerics.integrator == Integrator::verlet && scene.numerics.cfl > highest) {
    found.push_back(
        fmt::format("numerics: cfl = {} is near or above what Verlet, which leaps over two steps, "
                    "bears. Try {}, "
                    "or integrator = \"kick_drift_kick\".",
                    scene.numerics.cfl, scene.numerics.gradient_correction ? 0.3 : 0.6));
  }
  for (const Wall& wall : scene.walls) {
    if (!wall.removed_at.empty() && wall.removed_at == scene.stages.front().name) {
      found.push_back(fmt::format(
          "wall '{}': it is removed when the first stage begins, so it never acts.", wall.name));
    }
  }
  return found;
}

}  // namespace scarp
