// SPDX-License-Identifier: BSD-3-Clause
/// [[material]]: read by the parameter table of its model, so that a new model needs nothing here.
#include <fmt/format.h>

#include <cmath>

#include "engine/scene/not_supported.hpp"
#include "engine/scene/read_parts.hpp"
#include "engine/scene/units.hpp"

namespace scarp::input {
namespace {

const kernels::ModelInfo& read_model(const Value& item) {
  // A first look without a list of keys: which keys are known depends on the model.
  const std::optional<Value> model = item.peek("model");
  if (!model) return SoilModel().info();
  if (const kernels::ModelInfo* info = kernels::model_named(model->text())) return *info;
  std::vector<std::string> names;
  for (const auto& info : kernels::models) names.emplace_back(info.name);
  const std::string_view missing = not_supported("model", model->text());
  model->fail(fmt::format("there is no such model. {}", missing.empty()
                                                            ? did_you_mean(model->text(), names)
                                                            : std::string(missing)));
}

std::string example_of(const kernels::ParameterSpec& spec) {
  if (spec.unit == kernels::Unit::choice) return fmt::format("\"{}\"", spec.choices);
  if (spec.unit == kernels::Unit::none) return "0.3";
  const std::string units = accepted_units(spec.unit);
  return fmt::format("\"... {}\"", units.substr(0, units.find(',')));
}

/// The density of soil that weighs this much on Earth; elsewhere the weight is not what is known of
/// a soil.
double density_of(const Value& unit_weight, const Vec3& gravity) {
  constexpr double standard_gravity = 9.80665, least = 9.7, most = 10.0;  // [m/s2]
  const double weight = unit_weight.number(kernels::Unit::unit_weight);
  if (!(weight > 0.0)) unit_weight.fail("it is not positive. Try \"18 kN/m3\".");
  const double g = std::hypot(gravity[0], gravity[1], gravity[2]);
  if (g < least || g > most) {
    unit_weight.fail(
        fmt::format("the scene's gravity is {:.4g} m/s2, not that of the Earth, so a weight is no "
                    "density. Try density = \"{:.4g} kg/m3\", which weighs this on Earth.",
                    g, weight / standard_gravity));
  }
  return weight / g;
}

double read_density(const Table& material, const Vec3& gravity) {
  const auto unit_weight = material.find("unit_weight");
  if (!unit_weight) {
    return material.require("density", "\"2000 kg/m3\" (or unit_weight = \"18 kN/m3\")")
        .number(kernels::Unit::density);
  }
  material.require_one_of({"density", "unit_weight"});
  return density_of(*unit_weight, gravity);
}

}  // namespace

Material read_material(const Value& item, const Scene& scene) {
  if (!item.is_table()) item.table({"name"});
  const kernels::ModelInfo& model = read_model(item);
  Keys known = {"name", "model", "density", "unit_weight", "k0", "mass_scaling"};
  for (const auto& spec : model.parameters) known.push_back(spec.name);
  const Table table = item.table(known);

  Material material;
  material.name = table.require("name", "\"clay\"").text();
  material.density = read_density(table, scene.gravity);
  if (const auto k0 = table.find("k0")) {
    material.k0 = k0->number(kernels::Unit::none);
    if (!(*material.k0 >= 0.0)) k0->fail("it is negative. Try 0.5, or without it.");
  }
  if (const auto scaling = table.find("mass_scaling")) {
    material.mass_scaling = scaling->number(kernels::Unit::none);
    if (!(material.mass_scaling >= 1.0)) {
      scaling->fail(
          "it is below 1, which would make the inertia less than that of the mass and the time "
          "step shorter. Try 100, or without it.");
    }
  }
  std::vector<double> parameters;
  for (const auto& spec : model.parameters) {
    double fallback = scene.dimension == 3 ? spec.default_value_3d : spec.default_value;
    if (spec.like != nullptr) fallback = parameters[*model.parameter(spec.like)];
    const auto value = table.find(spec.name);
    if (!value && std::isfinite(fallback)) {
      parameters.push_back(fallback);
    } else if (!value) {
      table.require(spec.name, fmt::format("{} ({})", example_of(spec), spec.description));
    } else if (spec.unit == kernels::Unit::choice) {
      parameters.push_back(static_cast<double>(value->choice(spec.choices)));
    } else {
      parameters.push_back(value->number(spec.unit));
    }
  }
  material.model = SoilModel(model, std::move(parameters));
  return material;
}

}  // namespace scarp::input
