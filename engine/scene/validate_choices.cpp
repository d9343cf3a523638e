// SPDX-License-Identifier: BSD-3-Clause
/// Rules about choices that are enumerators.
#include <fmt/format.h>

#include "engine/scene/validate_parts.hpp"

namespace scarp::checks {
namespace {

/// `last`: the enumerator with the highest number.
template <class Choice>
void choice(Choice value, Choice last, const std::string& path) {
  const auto number = static_cast<long>(value);
  rule(number >= 0 && number <= static_cast<long>(last), path, fmt::format("{}", number),
       "it is no value of this choice. Try one of its enumerators.");
}

}  // namespace

void choices(const Scene& scene) {
  const Numerics& n = scene.numerics;
  choice(n.smoothing, SmoothingFunction::wendland_c2, "numerics.smoothing");
  choice(n.stress_rotation, StressRotation::hughes_winget, "numerics.stress_rotation");
  choice(n.integrator, Integrator::kick_drift_kick, "numerics.integrator");
  choice(n.precision, Precision::mixed, "numerics.precision");
  choice(scene.initial_stress, InitialStress::uniform, "initial.stress");
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const std::string path = fmt::format("body[{}]", b);
    rule(!scene.bodies[b].shape.valueless_by_exception(), path, "...",
         "its shape was lost when an assignment failed. Try to set it again.");
    if (const auto* field = std::get_if<HeightField>(&scene.bodies[b].shape))
      choice(field->kind, HeightField::Kind::expression, path + ".height_field");
  }
  for (std::size_t w = 0; w < scene.walls.size(); ++w)
    choice(scene.walls[w].kind, WallKind::free_slip, fmt::format("wall[{}].kind", w));
  for (std::size_t s = 0; s < scene.stages.size(); ++s)
    choice(scene.stages[s].until, StageEnd::rest, fmt::format("stage[{}].until", s));
}

}  // namespace scarp::checks
