// SPDX-License-Identifier: BSD-3-Clause
/// Rules about choices that are enumerators.
#include <fmt/format.h>

#include "engine/scene/numerics_list.hpp"
#include "engine/scene/validate_parts.hpp"

namespace scarp::checks {
namespace {

void known(double number, double last, const std::string& path) {
  rule(number >= 0.0 && number <= last, path, fmt::format("{}", number),
       "it is no value of this choice. Try one of its enumerators.");
}

/// `last`: the enumerator with the highest number.
template <class Choice>
void choice(Choice value, Choice last, const std::string& path) {
  known(static_cast<double>(value), static_cast<double>(last), path);
}

}  // namespace

void choices(const Scene& scene) {
  for (const NumericsRow& row : numerics_list) {
    if (row.kind == NumericsRow::Kind::choice)
      known(row.get(scene.numerics), row.maximum, fmt::format("numerics.{}", row.key));
  }
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
