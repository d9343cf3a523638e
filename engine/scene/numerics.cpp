// SPDX-License-Identifier: BSD-3-Clause
/// The named sets of numerics, and their values as a scene has them.
#include <cmath>

#include <fmt/format.h>

#include "engine/errors.hpp"
#include "engine/scene/numerics_list.hpp"

namespace scarp {

std::string NumericsRow::written(const Numerics& numerics) const {
  const double value = get(numerics);
  if (kind == Kind::truth) return value != 0.0 ? "true" : "false";
  if (kind == Kind::choice) {
    std::string_view rest = words;
    for (double before = value; before > 0.0 && !rest.empty(); --before)
      rest.remove_prefix(std::min(rest.find('|'), rest.size() - 1) + 1);
    return std::string(rest.substr(0, rest.find('|')));
  }
  return value == 0.0 && !words.empty() ? std::string(words) : fmt::format("{}", value);
}

Numerics preset(const std::string& name) {
  Numerics numerics;  // "modern"
  if (name != "modern" && name != "paper") {
    throw SceneError(fmt::format(
        "key 'preset' = \"{}\": there is no such preset. Try \"modern\" or \"paper\".", name));
  }
  if (name == "modern") return numerics;
  numerics.preset = name;
  for (const NumericsRow& row : numerics_list) row.set(numerics, row.paper);
  return numerics;
}

bool soil_may_sleep(const Scene& scene) {
  return scene.numerics.sleep > 0.0 && scene.gravity != Vec3{};
}

std::string preset_and_changes(const Numerics& numerics) {
  const Numerics unchanged = preset(numerics.preset);
  std::string text = numerics.preset;
  std::string_view link = ", with ";
  for (const NumericsRow& row : numerics_list) {
    if (row.get(numerics) == row.get(unchanged)) continue;
    text += fmt::format("{}{} = {}", link, row.key, row.written(numerics));
    link = ", ";
  }
  return text;
}

}  // namespace scarp
