// SPDX-License-Identifier: BSD-3-Clause
/// `scarp element`: one material point of a scene along the path of a laboratory test.

#include "engine/element/element_path.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <system_error>

#include "engine/cli/commands.hpp"
#include "engine/errors.hpp"
#include "engine/output/text_file.hpp"
#include "engine/plain_text.hpp"
#include "engine/scene/scene_problem.hpp"

namespace scarp::cli {
namespace {

using Json = nlohmann::ordered_json;
constexpr std::array<const char*, 6> components{"xx", "yy", "zz", "xy", "yz", "zx"};

/// The option, if it names a material or the scene has only one. Errors: UsageError.
std::string known_material(const Scene& scene, const std::string& name) {
  try {
    static_cast<void>(material_named(scene, name));
  } catch (const SceneProblem& problem) {
    throw UsageError(fmt::format("--material {}: {}", problem.value(), problem.why()));
  }
  return name;
}

const Material& tested(const Scene& scene, const ElementTest& test) {
  return scene.materials[material_named(scene, test.material)];
}

/// In the plane, the components that cannot differ from 0 are left out.
std::size_t component_count(const ElementResult& result) { return result.dimension == 2 ? 4 : 6; }

void write_table(const std::filesystem::path& path, const ElementResult& result) {
  std::vector<std::string> titles{"step"};
  for (const auto& [quantity, unit] : {std::pair{"strain", "-"}, {"stress", "Pa"}}) {
    for (std::size_t c = 0; c < component_count(result); ++c) {
      titles.push_back(fmt::format("{}_{} [{}]", quantity, components[c], unit));
    }
  }
  titles.insert(titles.end(), {"I1 [Pa]", "sqrt_J2 [Pa]", "volumetric_strain [-]"});
  if (result.plastic) {
    titles.emplace_back("yield_function [Pa]");
    for (const auto& field : result.history)
      titles.push_back(fmt::format("{} [{}]", field.name, field.unit));
    titles.emplace_back("plastic_volumetric_strain [-]");
  }
  CsvFile table(path, titles);
  for (std::size_t n = 0; n < result.samples.size(); ++n) {
    const ElementSample& sample = result.samples[n];
    table << static_cast<double>(n);
    for (const auto* tensor : {&sample.strain, &sample.stress}) {
      for (std::size_t c = 0; c < component_count(result); ++c) table << (*tensor)[c];
    }
    table << sample.first_invariant << sample.root_j2 << sample.volumetric_strain;
    if (result.plastic) {
      table << sample.yield_function;
      for (std::size_t h = 0; h < result.history.size(); ++h) table << sample.history[h];
      table << sample.plastic_volumetric_strain;
    }
    table.end_row();
  }
}

Json json_of(const ElementSample& sample, const ElementResult& result) {
  Json json{{"strain", sample.strain},
            {"stress", sample.stress},
            {"I1", sample.first_invariant},
            {"sqrt_J2", sample.root_j2},
            {"volumetric_strain", sample.volumetric_strain}};
  if (result.plastic) {
    json["yield_function"] = sample.yield_function;
    for (std::size_t h = 0; h < result.history.size(); ++h)
      json[result.history[h].name] = sample.history[h];
    json["plastic_volumetric_strain"] = sample.plastic_volumetric_strain;
  }
  return json;
}

/// "at the end the deviator is ...", of the same test with one parameter changed.
std::string changed_end(Scene scene, const ElementTest& test, const RunOptions& options,
                        std::string_view parameter, double value) {
  scene.materials[material_named(scene, test.material)].model.set(parameter, value);
  const ElementSample end = run_element(scene, test, options).samples.back();
  return fmt::format("q = {:.4g} kPa and a volumetric strain of {:.3g}", 1e-3 * deviator(end),
                     end.volumetric_strain);
}

/// What the material is without having been asked to be, with the numbers of the alternative.
std::vector<std::string> notes(const Scene& scene, const ElementTest& test,
                               const RunOptions& options) {
  std::vector<std::string> found;
  const SoilModel& model = tested(scene, test).model;
  const auto strength = model.strength();
  if (!strength || strength->friction_angle == 0.0 || test.path == ElementPath::isotropic)
    return found;
  const bool triaxial = test.path == ElementPath::triaxial;
  const auto fitting = static_cast<double>(triaxial ? Cone::outer : Cone::plane_strain);
  constexpr std::array<const char*, 3> cones{"plane_strain", "outer", "inner"};
  if (model.has("cone") && model.parameter("cone") != fitting) {
    const double cone = model.parameter("cone");
    found.push_back(fmt::format(
        "the cone is \"{}\"{}, which does not match Coulomb's strength in {}; with \"{}\", which "
        "does, the test ends at {}.",
        cones[static_cast<std::size_t>(cone)],
        cone == (scene.dimension == 2 ? 0.0 : 1.0)
            ? fmt::format(", the default in {}D", scene.dimension)
            : "",
        triaxial ? "triaxial compression" : "plane strain",
        cones[static_cast<std::size_t>(fitting)],
        changed_end(scene, test, options, "cone", fitting)));
  }
  if (model.has("dilation_angle") && strength->dilation_angle == 0.0) {
    found.push_back(
        fmt::format("dilation_angle is 0, the default; with psi = phi the test ends at {}.",
                    changed_end(scene, test, options, "dilation_angle", strength->friction_angle)));
  }
  return found;
}

Json summary(const Scene& scene, const ElementTest& test, const ElementResult& result,
             const std::string& table, const std::vector<std::string>& notes) {
  const Material& material = tested(scene, test);
  Json json{{"format", "scarp element"},
            {"version", 1},
            {"scene", scene.file},
            {"material", material.name},
            {"model", material.model.name()},
            {"path", element_path_names[static_cast<std::size_t>(test.path)]},
            {"preset", scene.numerics.preset},
            {"stress_rotation", word(scene.numerics.stress_rotation)},
            {"dimension", result.dimension},
            {"isa", result.isa},
            {"confining_pressure", test.confining_pressure},
            {"strain", test.strain},
            {"steps", test.steps},
            {"bulk_modulus", result.bulk_modulus},
            {"shear_modulus", result.shear_modulus},
            {"control_error", result.control_error},
            {"table", table},
            {"deviator", deviator(result.samples.back())},
            {"notes", notes}};
  if (result.plastic) {
    for (const auto& shown : material.model.info().shown)
      json[shown.name] = result.constants.at(shown.name);
    json["first_yield"] =
        result.first_yield > 0 ? json_of(result.samples[result.first_yield], result) : Json();
  }
  json["end"] = json_of(result.samples.back(), result);
  return json;
}

void print(const Scene& scene, const ElementTest& test, const ElementResult& result,
           const std::string& table, const std::vector<std::string>& notes) {
  const ElementSample& end = result.samples.back();
  const auto line = [](std::string_view name, const std::string& value) {
    fmt::print("{:<18}{}\n", name, value);
  };
  const auto kilopascal = [](double pascal) { return fmt::format("{:.6g} kPa", 1e-3 * pascal); };
  line("material", tested(scene, test).name);
  line("path", fmt::format("{}, from {} isotropic, strain {:g} in {} steps",
                           element_path_names[static_cast<std::size_t>(test.path)],
                           kilopascal(test.confining_pressure), test.strain, test.steps));
  if (result.plastic) {
    if (result.first_yield > 0) {
      const double share = static_cast<double>(result.first_yield) / test.steps;
      line("yields", fmt::format("from strain {:.4g}", share * test.strain));
    } else {
      line("yields", "no");
    }
  }
  fmt::print("at the end\n");
  for (std::size_t c = 0; c < component_count(result); ++c) {
    line(fmt::format("  stress {}", components[c]), kilopascal(end.stress[c]));
  }
  line("  q", kilopascal(deviator(end)));
  line("  I1, sqrt J2", kilopascal(end.first_invariant) + ", " + kilopascal(end.root_j2));
  line("  vol. strain", fmt::format("{:.6g}", end.volumetric_strain));
  if (result.plastic) {
    line("  plastic strain",
         fmt::format("{}volumetric {:.6g}",
                     result.history.empty() ? "" : fmt::format("{:.6g}, ", end.history[0]),
                     end.plastic_volumetric_strain));
  }
  line("table", plain_text(table));
  for (const std::string& note : notes) fmt::print("note: {}\n", note);
}

}  // namespace

int element_command(const ElementArguments& arguments) {
  ElementTest test;
  const auto name = std::find(element_path_names.begin(), element_path_names.end(), arguments.path);
  test.path = static_cast<ElementPath>(name - element_path_names.begin());
  test.confining_pressure =
      option_value("--confining", arguments.confining, "Pa", kernels::Unit::pressure);
  test.strain = arguments.strain;
  test.steps = arguments.steps;
  const Scene scene = load_scene(arguments.scene);
  require_target("--out", arguments.table, arguments.scene.file);
  test.material = known_material(scene, arguments.material);
  const ElementResult result = run_element(scene, test, arguments.scene.options);

  std::filesystem::path table = arguments.table;
  if (table.empty()) {
    table = std::filesystem::path("out") / std::filesystem::path(scene.file).stem() /
            fmt::format("element_{}.csv", arguments.path);
    std::error_code error;
    std::filesystem::create_directories(table.parent_path(), error);  // else the writer says so
  }
  write_table(table, result);
  const std::vector<std::string> said = notes(scene, test, arguments.scene.options);
  if (arguments.scene.json != "-") print(scene, test, result, table.string(), said);
  if (!arguments.scene.json.empty()) {
    write_text(arguments.scene.json, summary(scene, test, result, table.string(), said)
                                             .dump(2, ' ', false, Json::error_handler_t::replace) +
                                         "\n");
  }
  return ok;
}

}  // namespace scarp::cli
