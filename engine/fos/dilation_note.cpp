// SPDX-License-Identifier: BSD-3-Clause
/// The bound by shear at constant volume, and the sentence around it.
#include "engine/fos/dilation_note.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/errors.hpp"
#include "engine/fos/strength_reduction.hpp"

namespace scarp {

bool looks_reducible(const Scene& scene) {
  const Stage& last = scene.stages.back();
  if (std::any_of(scene.materials.begin(), scene.materials.end(),
                  [&](const Material& material) { return reduction_of(last, material) > 1.0; }))
    return true;
  try {
    check_reducible(scene);
  } catch (const SceneError&) {
    return false;
  }
  return true;
}

std::optional<std::string> dilation_note(const Scene& scene, std::optional<double> factor) {
  std::string names;
  double steepest = 0.0;
  bool all_in_plane_strain = scene.dimension == 2;
  for (std::size_t m = 0; m < scene.materials.size(); ++m) {
    const Material& material = scene.materials[m];
    const auto strength = material.model.strength();
    if (!is_used(scene, m) || !strength) continue;
    all_in_plane_strain &=
        !material.model.has("cone") ||
        material.model.parameter("cone") == static_cast<double>(Cone::plane_strain);
    if (strength->dilation_angle > 0.0 || strength->friction_angle == 0.0) continue;
    names += fmt::format("{}'{}'", names.empty() ? "" : ", ", material.name);
    steepest = std::max(steepest, std::tan(strength->friction_angle));
  }
  if (names.empty()) return {};
  std::string text = fmt::format(
      "dilation_angle is 0, the default, in {}: published tables and methods of slices take psi = "
      "phi, and their factors of safety are 5 to 11 % above those found with psi = 0.",
      names);
  if (factor && all_in_plane_strain) {
    const double tangent = steepest / *factor;
    text += fmt::format(" Here psi = phi could give up to {:.3f}.",
                        *factor * std::sqrt(1.0 + 4.0 / 3.0 * tangent * tangent));
  }
  return text + " To compare with them, try dilation_angle = friction_angle.";
}

}  // namespace scarp
