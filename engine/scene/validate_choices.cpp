// SPDX-License-Identifier: BSD-3-Clause
/// Rules about choices that are enumerators.
#include <fmt/format.h>

#include "engine/scene/numerics_list.hpp"
#include "engine/scene/validate_parts.hpp"

namespace scarp::checks {

void choice(double number, double last, const std::string& path) {
  rule(number >= 0.0 && number <= last, path, fmt::format("{}", number),
       "it is no value of this choice. Try one of its enumerators.");
}

void choices(const Scene& scene) {
  for (const NumericsRow& row : numerics_list) {
    if (row.kind == NumericsRow::Kind::choice)
      choice(row.get(scene.numerics), row.maximum, fmt::format("numerics.{}", row.key));
  }
  choice(scene.initial_stress, InitialStress::uniform, "initial.stress");
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    rule(!scene.bodies[b].shape.valueless_by_exception(), fmt::format("body[{}]", b), "...",
         "its shape was lost when an assignment failed. Try to set it again.");
  for (std::size_t w = 0; w < scene.walls.size(); ++w)
    choice(scene.walls[w].kind, WallKind::free_slip, fmt::format("wall[{}].kind", w));
  for (std::size_t s = 0; s < scene.stages.size(); ++s)
    choice(scene.stages[s].until, StageEnd::rest, fmt::format("stage[{}].until", s));
}

}  // namespace scarp::checks
