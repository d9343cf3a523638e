// SPDX-License-Identifier: BSD-3-Clause
/// A TOML document into a valid `Scene`, section by section.
#include "engine/scene/scene_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "engine/scene/read_parts.hpp"
#include "engine/scene/scene_problem.hpp"
#include "engine/scene/text_limits.hpp"

namespace scarp {
namespace {

using input::Table;
using input::Value;
using kernels::Unit;

/// "cohesion = 7,5": what the parser says about it names no comma.
bool has_decimal_comma(std::string_view line) {
  const auto digit = [&line](std::size_t at) {
    return at < line.size() && line[at] >= '0' && line[at] <= '9';
  };
  const std::size_t equals = line.find('='), comma = line.find(',');
  if (equals == std::string_view::npos || comma == std::string_view::npos || comma < equals)
    return false;
  const bool in_table = line.substr(equals).find_first_of("[{\"'#") < comma - equals;
  return !in_table && digit(comma - 1) && digit(comma + 1);
}

std::string_view line_of_text(std::string_view text, std::size_t number) {
  for (std::size_t line = 1; line < number && !text.empty(); ++line)
    text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
  return text.substr(0, text.find('\n'));
}

toml::table parse(std::string_view text, const std::string& name) {
  input::check_text(text, name);
  try {
    return toml::parse(text, name);
  } catch (const toml::parse_error& error) {
    const std::size_t line = std::max<std::size_t>(1, error.source().begin.line);
    if (has_decimal_comma(line_of_text(text, line))) {
      throw SceneError(
          fmt::format("{}:{}: a comma stands in a number. Try a decimal point: 1.5 instead of 1,5.",
                      name, line));
    }
    const std::string why = input::one_line(error.description(), 300);
    throw SceneError(fmt::format(
        "{}:{}: this is not TOML: {}. Try to compare the line with SCENE.md.", name, line, why));
  }
}

/// Items of [[key]]; none if it is absent. What each of them costs depends on how many others there
/// are, so more than any scene needs are refused.
std::vector<Value> list_of(const Table& root, std::string_view key, std::size_t most = 10'000) {
  const auto value = root.find(key);
  if (!value) return {};
  if (value->is_table()) {
    value->fail(fmt::format("there can be several. Try [[{}]] with double brackets.", key));
  }
  std::vector<Value> items = value->items();
  if (items.size() > most) {
    items[most].fail(fmt::format("there are {}, more than {}. Try fewer.", items.size(), most));
  }
  return items;
}

Scene read_document(const Value& document, const std::string& name,
                    const SceneOverrides& overrides) {
  const Table root =
      document.table({"title", "dimension", "gravity", "spacing", "preset", "numerics", "material",
                      "body", "wall", "initial", "stage", "probe", "output", "checkpoint", "run"});
  Scene scene;
  scene.file = name;
  if (const auto title = root.find("title")) scene.title = title->text();
  const Value dimension = root.require("dimension", "2 or dimension = 3");
  scene.dimension = dimension.integer();
  const int d = scene.dimension;
  if (d != 2 && d != 3) dimension.fail("only plane strain and 3D exist. Try 2 or 3.");
  scene.gravity = d == 2 ? Vec3{0.0, -9.81, 0.0} : Vec3{0.0, 0.0, -9.81};
  if (const auto gravity = root.find("gravity")) {
    scene.gravity = input::read_vector(*gravity, Unit::acceleration, d);
  }
  scene.spacing = root.require("spacing", "\"0.25 m\"").number(Unit::length);
  if (overrides.spacing) scene.spacing = *overrides.spacing;
  if (!(scene.spacing > 0.0)) {
    root.require("spacing", "").fail("the particle spacing is not positive. Try \"0.25 m\".");
  }

  std::string preset_name = "modern";
  if (const auto chosen = root.find("preset")) {
    preset_name = chosen->choice("modern|paper") == 0 ? "modern" : "paper";
  }
  scene.numerics = preset(overrides.preset.empty() ? preset_name : overrides.preset);
  if (const auto numerics = root.find("numerics")) {
    input::read_numerics(*numerics, scene.numerics);
  }

  constexpr std::size_t most_kinds = 1000;
  std::vector<std::string> names;
  for (const Value& item : list_of(root, "material", most_kinds)) {
    scene.materials.push_back(input::read_material(item, scene));
    names.push_back(scene.materials.back().name);
  }
  for (const Value& item : list_of(root, "body")) {
    scene.bodies.push_back(input::read_body(item, d, names));
  }
  for (const Value& item : list_of(root, "wall")) scene.walls.push_back(input::read_wall(item, d));
  if (const auto initial = root.find("initial")) input::read_initial(*initial, scene);
  scene.stages = input::read_stages(list_of(root, "stage", most_kinds));
  for (const Value& item : list_of(root, "probe")) {
    scene.probes.push_back(input::read_probe(item, d));
  }
  if (const auto output = root.find("output")) scene.output = input::read_output(*output);
  if (const auto checkpoint = root.find("checkpoint")) {
    scene.checkpoints = input::read_checkpoints(*checkpoint);
  }
  if (const auto run = root.find("run")) scene.retries = input::read_retries(*run);
  return scene;
}

/// A wall in a file has no facets, but one of the shapes they are made from.
void locate_facet(const SceneProblem& problem, const toml::table& document,
                  const std::string& name) {
  const std::string& path = problem.path();
  const std::size_t facets = path.find(".facets[");
  if (facets == std::string::npos) return;
  const std::string member = path.substr(path.rfind('.') + 1);
  for (const std::string_view shape : input::wall_shapes) {
    const std::string key = path.substr(0, facets + 1) + std::string(shape);
    if (const auto view = toml::at_path(document, key)) {
      input::fail(
          name, *view.node(), key,
          fmt::format("{} of one of its faces is {}: {}", member, problem.value(), problem.why()));
    }
  }
}

/// Rethrows a broken rule with the line of its key, or of the nearest table around it.
[[noreturn]] void locate(const SceneProblem& problem, const toml::table& document,
                         const std::string& name) {
  locate_facet(problem, document, name);
  std::string path = problem.path();
  if (const auto view = toml::at_path(document, path)) {
    input::fail(name, *view.node(), path, problem.why());
  }
  int line = 1;
  for (auto cut = path.find_last_of(".["); cut != std::string::npos;
       cut = path.find_last_of(".[")) {
    path.resize(cut);
    const auto view = toml::at_path(document, path);
    if (!view) continue;
    line = input::line_of(*view.node());
    break;
  }
  throw SceneError(
      fmt::format("{}:{}: key '{}' = {}: {}", name, line, input::one_line(problem.path(), 100),
                  input::one_line(problem.value(), 100), input::one_line(problem.why(), 1000)));
}

}  // namespace

Scene read_scene_text(std::string_view text, const std::string& name,
                      const SceneOverrides& overrides) {
  const std::string shown_name = input::one_line(name, name.size() * 4);
  if (text.size() > input::largest_file) {
    throw SceneError(fmt::format("{}:1: the text is larger than {} MiB. Try a scene.", shown_name,
                                 input::largest_file >> 20));
  }
  const toml::table document = parse(text, shown_name);
  Scene scene = read_document(Value(document, "", shown_name), name, overrides);
  scene.text = text;
  try {
    validate(scene);
  } catch (const SceneProblem& problem) {
    locate(problem, document, shown_name);
  }
  return scene;
}

Scene read_scene(const std::filesystem::path& path, const SceneOverrides& overrides) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) {
    throw FileError(fmt::format("{}: this is a folder. Try a scene file in it.", path.string()));
  }
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    throw FileError(fmt::format("{}: the file cannot be opened. Try to check its name and rights.",
                                path.string()));
  }
  std::string text(input::largest_file + 1, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (file.bad()) throw FileError(fmt::format("{}: reading failed.", path.string()));
  text.resize(static_cast<std::size_t>(file.gcount()));
  return read_scene_text(text, path.string(), overrides);
}

}  // namespace scarp
