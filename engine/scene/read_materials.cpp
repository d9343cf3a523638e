// SPDX-License-Identifier: BSD-3-Clause
/// [[material]]: read by the parameter table of its model, so that a new model needs nothing here.
#include <fmt/format.h>

#include <cmath>

#include "engine/scene/read_parts.hpp"
#include "engine/scene/units.hpp"
#include "kernels/constitutive/list.hpp"

namespace scarp::input {
namespace {

const kernels::ModelInfo& read_model(const Value& item) {
  // A first look without a list of keys: which keys are known depends on the model.
  const std::optional<Value> model = item.peek("model");
  if (!model) return kernels::models[kernels::model_index("drucker_prager")];
  const int index = kernels::model_index(model->text());
  if (index >= 0) return kernels::models[static_cast<std::size_t>(index)];
  std::vector<std::string> names;
  for (const auto& info : kernels::models) names.emplace_back(info.name);
  model->fail(fmt::format("there is no such model. {}", did_you_mean(model->text(), names)));
}

std::string example_of(const kernels::ParameterSpec& spec) {
  if (spec.unit == kernels::Unit::choice) return fmt::format("\"{}\"", spec.choices);
  if (spec.unit == kernels::Unit::none) return "0.3";
  const std::string units = accepted_units(spec.unit);
  return fmt::format("\"... {}\"", units.substr(0, units.find(',')));
}

}  // namespace

Material read_material(const Value& item, int dimension) {
  if (!item.is_table()) item.table({"name"});
  const kernels::ModelInfo& model = read_model(item);
  Keys known = {"name", "model", "density"};
  for (const auto& spec : model.parameters) known.push_back(spec.name);
  const Table table = item.table(known);

  Material material;
  material.name = table.require("name", "\"clay\"").text();
  material.model = model.name;
  material.density = table.require("density", "2000.0").number(kernels::Unit::density);
  for (const auto& spec : model.parameters) {
    const double fallback = dimension == 3 ? spec.default_value_3d : spec.default_value;
    const auto value = table.find(spec.name);
    if (!value && std::isfinite(fallback)) {
      material.parameters.push_back(fallback);
    } else if (!value) {
      table.require(spec.name, fmt::format("{} ({})", example_of(spec), spec.description));
    } else if (spec.unit == kernels::Unit::choice) {
      material.parameters.push_back(static_cast<double>(value->choice(spec.choices)));
    } else {
      material.parameters.push_back(value->number(spec.unit));
    }
  }
  return material;
}

}  // namespace scarp::input
