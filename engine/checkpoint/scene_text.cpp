// SPDX-License-Identifier: BSD-3-Clause
/// Every value of a scene, line by line.
#include "engine/checkpoint/scene_text.hpp"

#include <algorithm>
#include <sstream>

#include <fmt/format.h>

#include "engine/scene/numerics_list.hpp"
#include "engine/scene/shape_list.hpp"
#include "engine/scene/smoothing_choice.hpp"
#include "engine/scene/text_lines.hpp"

namespace scarp {
namespace {

/// Stands for a value that is chosen from the others, as it does in files of older versions; 0
/// where 0 is no value.
constexpr double chosen = -1.0;

/// What the scene leaves open stands as the value it has: a run goes on if it has that still.
void add_numerics(TextLines& lines, const Scene& scene) {
  const Numerics numerics = filled_in(scene);
  lines.section("numerics.");
  for (const NumericsRow& row : numerics_list) {
    if (row.kind == NumericsRow::Kind::truth) {
      lines.add(row.key, row.get(numerics) != 0.0);
    } else {
      lines.add(row.key, row.get(numerics));
    }
  }
}

void add_walls(TextLines& lines, const std::vector<Wall>& walls) {
  for (std::size_t w = 0; w < walls.size(); ++w) {
    const Wall& wall = walls[w];
    lines.section(fmt::format("wall[{}].", w));
    lines.add("kind", wall.kind);
    lines.add("velocity", wall.velocity);
    lines.add("from", wall.moves_from);
    lines.add("until", wall.removed_at);
    for (const Facet& f : wall.facets) {
      lines.add("facet.origin", f.origin);
      lines.add("facet.u", f.tangent_u);
      lines.add("facet.v", f.tangent_v);
      lines.add("facet.length_u", f.length_u);
      lines.add("facet.length_v", f.length_v);
      lines.add("facet.normal", f.normal);
    }
  }
}

void add_stages(TextLines& lines, const std::vector<Stage>& stages) {
  for (std::size_t s = 0; s < stages.size(); ++s) {
    const Stage& stage = stages[s];
    lines.section(fmt::format("stage[{}].", s));
    lines.add("name", stage.name);
    lines.add("until", stage.until);
    lines.add("duration", stage.duration.value_or(0.0));
    lines.add("rest_velocity", stage.rest_velocity);
    lines.add("strength_reduction", stage.strength_reduction);
    lines.add("material_strength_reduction", stage.material_strength_reduction);
    lines.add("damping", stage.damping.value_or(chosen));
    lines.add("reset_after", stage.reset_after);
  }
}

}  // namespace

std::string scene_text(const Scene& scene) {
  TextLines lines;
  lines.add("dimension", scene.dimension);
  lines.add("gravity", scene.gravity);
  lines.add("spacing", scene.spacing);
  lines.add("output.energy", scene.output.energy);
  add_numerics(lines, scene);
  for (std::size_t m = 0; m < scene.materials.size(); ++m) {
    const Material& material = scene.materials[m];
    lines.section(fmt::format("material[{}].", m));
    lines.add("name", material.name);
    lines.add("model", material.model.name());
    lines.add("density", material.density);
    lines.add("parameters", material.model.parameters());
    lines.add("k0", material.k0.value_or(chosen));
    if (material.mass_scaling != 1.0) lines.add("mass_scaling", material.mass_scaling);
  }
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const Body& body = scene.bodies[b];
    lines.section(fmt::format("body[{}].", b));
    lines.add("material", material_of(scene, body));
    lines.add("velocity", body.velocity);
    lines.add("velocity_field", body.velocity_field);
    row_of(body.shape).write(body.shape, lines);
  }
  add_walls(lines, scene.walls);
  lines.section("initial.");
  lines.add("stress", scene.initial_stress);
  lines.add("k0", scene.initial_k0.value_or(chosen));
  lines.add("uniform", scene.uniform_stress);
  add_stages(lines, scene.stages);
  return lines.take();
}

std::string output_text(const Scene& scene) {
  TextLines lines;
  lines.section("output.");
  lines.add("frames", scene.output.frames);
  lines.add("every", scene.output.frame_interval.value_or(0.0));
  lines.add("probe_every", scene.output.probe_interval.value_or(0.0));
  for (std::size_t w = 0; w < scene.walls.size(); ++w) {
    lines.section(fmt::format("wall[{}].", w));
    lines.add("name", scene.walls[w].name);
  }
  for (std::size_t p = 0; p < scene.probes.size(); ++p) {
    lines.section(fmt::format("probe[{}].", p));
    lines.add("name", scene.probes[p].name);
    lines.add("at", scene.probes[p].at);
  }
  return lines.take();
}

bool only_adds_stages(const std::string& stored, const std::string& here) {
  if (!here.starts_with(stored)) return false;
  std::istringstream added(here.substr(stored.size()));
  std::string line;
  bool stages = true;
  for (bool first = true; stages && std::getline(added, line); first = false) {
    stages = line.starts_with("stage[") &&
             (!first || line.find("].name = ") != std::string::npos);  // a stage begins with it
  }
  return stages;
}

std::string first_difference(const std::string& stored, const std::string& here) {
  if (stored == here) return {};
  const auto same =
      std::mismatch(stored.begin(), stored.end(), here.begin(), here.end()).first - stored.begin();
  const auto line_at = [at = static_cast<std::size_t>(same)](const std::string& text) {
    const std::size_t before = at == 0 ? std::string::npos : text.rfind('\n', at - 1);
    const std::size_t first = before == std::string::npos ? 0 : before + 1;
    const std::string line = text.substr(first, text.find('\n', first) - first);
    return line.empty() ? std::string("nothing") : line;
  };
  return fmt::format("{}, here {}", line_at(stored), line_at(here));
}

}  // namespace scarp
