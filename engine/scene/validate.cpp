// SPDX-License-Identifier: BSD-3-Clause
/// The rules every scene keeps, from a file or made in code; each names the key it is about.
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "engine/plain_text.hpp"
#include "engine/scene/nearest_name.hpp"
#include "engine/scene/numerics_list.hpp"
#include "engine/scene/scene.hpp"
#include "engine/scene/scene_problem.hpp"
#include "engine/scene/smoothing_choice.hpp"
#include "engine/scene/validate_parts.hpp"

namespace scarp {
namespace {

using checks::inside;
using checks::positive;
using checks::rule;

void check_numerics(const Scene& scene) {
  const Numerics& n = scene.numerics;
  rule(n.preset == "modern" || n.preset == "paper", "preset", '"' + n.preset + '"',
       "there is no such preset. Try \"modern\" or \"paper\".");
  for (const NumericsRow& row : numerics_list) {
    const bool open = row.kind == NumericsRow::Kind::number && !row.words.empty();
    if (open && row.get(n) == 0.0) continue;
    inside(row.get(n), row.minimum, row.maximum, fmt::format("numerics.{}", row.key));
  }
  if (n.smoothing_ratio) positive(*n.smoothing_ratio, 3.0, "numerics.smoothing_ratio");
  const std::string key = "numerics.artificial_stress_exponent";
  if (n.artificial_stress_exponent) positive(*n.artificial_stress_exponent, 20.0, key);
  if (n.artificial_stress > 0.0) {
    const double error = tension_factor_of(scene).error;
    const bool fits = error < 0.01;
    rule(fits, key,
         n.artificial_stress_exponent ? fmt::format("{}", *n.artificial_stress_exponent)
                                      : "\"auto\"",
         fmt::format("the sweep's polynomials miss F^n by {:.1f} %, more than 1 %. Try an exponent "
                     "between 0.5 and 4.",
                     100.0 * error));
  }
}

/// Names stand in tables and file names of the results.
template <class Named>
void check_names(const std::vector<Named>& list, const char* section) {
  std::set<std::string> seen;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const std::string& name = list[i].name;
    const std::string path = fmt::format("{}[{}].name", section, i), quoted = '"' + name + '"';
    rule(!name.empty() && name.size() <= 64, path, quoted,
         "a name has 1 to 64 letters. Try a short one.");
    rule(name.find_first_of("/\\\",.[]") == std::string::npos && !has_control(name), path, quoted,
         "it holds one of / \\ \" , . [ ] or a control character. Try letters and _.");
    // In a table such a cell is run as a formula by spreadsheets.
    rule(std::string_view("=+-@ ").find(name.front()) == std::string_view::npos, path, quoted,
         "it begins with one of = + - @ or a blank. Try a letter first.");
    rule(seen.insert(name).second, path, quoted,
         fmt::format("another {} has the same name. Try a different one.", section));
  }
}

void check_material(const Material& material, const std::string& path) {
  inside(material.density, 1e-6, 1e6, path + ".density");
  const SoilModel& model = material.model;
  rule(model.known(), path + ".model", '"' + model.name() + '"',
       "there is no such model. Try \"drucker_prager\".");
  const auto specs = model.info().parameters;
  rule(model.parameters().size() == specs.size(), path + ".parameters",
       fmt::format("{} values", model.parameters().size()),
       fmt::format("model {} has {} parameters. Try to give each of them.", model.name(),
                   specs.size()));
  if (material.k0) inside(*material.k0, 0.0, 10.0, path + ".k0");
  inside(material.mass_scaling, 1.0, 1e6, path + ".mass_scaling");
  const auto key = [&](std::size_t p) { return fmt::format("{}.{}", path, specs[p].name); };
  for (std::size_t p = 0; p < specs.size(); ++p) {
    const auto& spec = specs[p];
    const double value = model.parameters()[p];
    if (spec.unit == kernels::Unit::angle) {
      checks::inside_degrees(value, spec.minimum, spec.maximum, key(p));
    } else {
      inside(value, spec.minimum, spec.maximum, key(p));
    }
    rule(spec.unit != kernels::Unit::choice || value == std::floor(value), key(p),
         fmt::format("{}", value), "a choice is the index of a word. Try a whole number.");
  }
  if (const auto complaint = model.info().complaint(model.parameters())) {
    throw SceneProblem(key(complaint->parameter),
                       fmt::format("{}", model.parameters()[complaint->parameter]), complaint->why);
  }
}

void check_stage(const Scene& scene, const Stage& stage, const std::string& path) {
  rule(stage.duration != 0.0 && (stage.duration || stage.until == StageEnd::rest),
       path + ".duration", stage.duration ? "0" : "none",
       "the stage would take no time. Try \"10 s\", or until = \"rest\".");
  if (stage.duration) positive(*stage.duration, 1e9, path + ".duration");
  inside(stage.rest_velocity, 1e-12, 1e3, path + ".rest_velocity");
  inside(stage.strength_reduction, 1e-3, 1e3, path + ".strength_reduction");
  if (stage.damping) inside(*stage.damping, 0.0, 1e9, path + ".damping");
  std::vector<std::string> names;
  for (const Material& material : scene.materials) names.push_back(material.name);
  for (const auto& [name, factor] : stage.material_strength_reduction) {
    const std::string key = fmt::format("{}.strength_reduction.{}", path, name);
    rule(std::find(names.begin(), names.end(), name) != names.end(), key, fmt::format("{}", factor),
         fmt::format("no material has this name. {}", did_you_mean(name, names)));
    inside(factor, 1e-3, 1e3, key);
  }
}

void check_stage_name(const Scene& scene, const std::string& name, const std::string& path) {
  if (name.empty()) return;
  std::vector<std::string> names;
  for (const Stage& stage : scene.stages) names.push_back(stage.name);
  rule(std::find(names.begin(), names.end(), name) != names.end(), path, '"' + name + '"',
       fmt::format("no stage has this name. {}", did_you_mean(name, names)));
}

void check_initial(const Scene& scene) {
  for (const double value : scene.uniform_stress) inside(value, -1e15, 1e15, "initial.uniform");
  if (scene.initial_stress != InitialStress::geostatic) return;
  rule(scene.gravity != Vec3{}, "initial.stress", "\"geostatic\"",
       "gravity is 0, so nothing has weight. Try \"zero\", or gravity = [0, -9.81].");
  if (scene.initial_k0) inside(*scene.initial_k0, 0.0, 10.0, "initial.k0");
}

}  // namespace

namespace {

template <class Part>
std::string start_of(const Scene& scene, const std::vector<Part>& list, const Part& part,
                     std::string_view section) {
  const std::string place =
      part.line > 0 ? fmt::format("{}:{}: ", plain_text(scene.file), part.line) : "";
  return fmt::format("{}key '{}[{}]' = ", place, section, &part - list.data());
}

}  // namespace

std::string message_start(const Scene& scene, const Body& body) {
  return start_of(scene, scene.bodies, body, "body");
}
std::string message_start(const Scene& scene, const Wall& wall) {
  return start_of(scene, scene.walls, wall, "wall");
}
std::string message_start(const Scene& scene, const Probe& probe) {
  return start_of(scene, scene.probes, probe, "probe");
}

namespace {

/// `asking` is the key of the name.
std::size_t find_material(const Scene& scene, std::string_view name, const std::string& asking) {
  if (name.empty() && scene.materials.size() == 1) return 0;
  std::vector<std::string> names;
  for (const Material& material : scene.materials) {
    if (material.name == name) return names.size();
    names.push_back(material.name);
  }
  throw SceneProblem(asking, fmt::format("\"{}\"", name),
                     name.empty()
                         ? fmt::format("the scene has {} materials. Try the name of one: {}.",
                                       names.size(), fmt::join(names, ", "))
                         : "no material has this name. " + did_you_mean(name, names));
}

}  // namespace

std::size_t material_of(const Scene& scene, const Body& body) {
  return find_material(scene, body.material,
                       fmt::format("body[{}].material", &body - scene.bodies.data()));
}
std::size_t material_named(const Scene& scene, std::string_view name) {
  return find_material(scene, name, "material");
}

bool is_used(const Scene& scene, std::size_t material) {
  return std::any_of(scene.bodies.begin(), scene.bodies.end(),
                     [&](const Body& body) { return material_of(scene, body) == material; });
}

double Material::sound_speed() const {
  return std::sqrt(model.moduli().wave_modulus() / (mass_scaling * density));
}

bool scales_mass(const Scene& scene) {
  return std::any_of(scene.materials.begin(), scene.materials.end(),
                     [](const Material& material) { return material.mass_scaling != 1.0; });
}

double k0_of(const Scene& scene, const Material& material) {
  if (material.k0) return *material.k0;
  if (scene.initial_k0) return *scene.initial_k0;
  if (material.model.has("poisson_ratio")) {  // as given, not by way of the moduli
    const double poisson = material.model.parameter("poisson_ratio");
    return poisson / (1.0 - poisson);
  }
  const kernels::ElasticModuli moduli = material.model.moduli();
  return 1.0 - 2.0 * moduli.shear_modulus / moduli.wave_modulus();
}

double reduction_of(const Stage& stage, const Material& material) {
  const auto own = stage.material_strength_reduction.find(material.name);
  return own != stage.material_strength_reduction.end() ? own->second : stage.strength_reduction;
}

void validate(const Scene& scene, bool needs_bodies) {
  checks::choices(scene);
  inside(scene.dimension, 2, 3, "dimension");
  inside(scene.spacing, 1e-9, 1e9, "spacing");
  rule(!has_control(scene.title), "title", '"' + scene.title + '"',
       "it holds a control character or a line end. Try plain text.");
  checks::vector(scene.gravity, scene.dimension, 1e6, "gravity");
  check_numerics(scene);
  rule(!scene.materials.empty(), "material", "none", "nothing is made of it. Try a [[material]].");
  rule(!needs_bodies || !scene.bodies.empty(), "body", "none", "there is no soil. Try a [[body]].");
  rule(!scene.stages.empty(), "stage", "none", "nothing would be run. Try a [[stage]].");
  check_names(scene.materials, "material");
  check_names(scene.walls, "wall");
  check_names(scene.stages, "stage");
  check_names(scene.probes, "probe");
  const auto item = [](const char* section, std::size_t i) {
    return fmt::format("{}[{}]", section, i);
  };
  for (std::size_t m = 0; m < scene.materials.size(); ++m) {
    check_material(scene.materials[m], item("material", m));
    rule(scene.materials[m].mass_scaling == 1.0 || scene.numerics.artificial_stress == 0.0,
         item("material", m) + ".mass_scaling", fmt::format("{}", scene.materials[m].mass_scaling),
         "the artificial stress goes by the densities of a pair, and would follow the scaled "
         "inertia. Try artificial_stress = 0, or without mass_scaling.");
  }
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) checks::body(scene, b, item("body", b));
  for (std::size_t w = 0; w < scene.walls.size(); ++w) {
    const Wall& wall = scene.walls[w];
    checks::wall(wall, scene.dimension, item("wall", w));
    check_stage_name(scene, wall.moves_from, item("wall", w) + ".motion.from");
    check_stage_name(scene, wall.removed_at, item("wall", w) + ".until");
  }
  check_initial(scene);
  for (std::size_t s = 0; s < scene.stages.size(); ++s) {
    check_stage(scene, scene.stages[s], item("stage", s));
  }
  for (std::size_t p = 0; p < scene.probes.size(); ++p) {
    checks::vector(scene.probes[p].at, scene.dimension, 1e9, item("probe", p) + ".at");
  }
  if (scene.output.frame_interval) positive(*scene.output.frame_interval, 1e9, "output.every");
  if (scene.output.probe_interval) {
    positive(*scene.output.probe_interval, 1e9, "output.probes_every");
  }
  inside(scene.checkpoints.interval, 0.0, 1e9, "checkpoint.every");
  inside(scene.checkpoints.wall_interval, 0.0, 1e9, "checkpoint.wall_every");
  inside(scene.retries, 0, 20, "run.retry");
}

}  // namespace scarp
