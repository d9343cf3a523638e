// SPDX-License-Identifier: BSD-3-Clause
/// Parameters by name.
#include "engine/scene/soil_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "engine/errors.hpp"
#include "engine/scene/nearest_name.hpp"
#include "engine/scene/scene.hpp"

namespace scarp {

SoilModel::SoilModel(std::string name, std::vector<double> parameters)
    : name_(std::move(name)),
      info_(kernels::model_named(name_)),
      parameters_(std::move(parameters)) {}

SoilModel::SoilModel(const kernels::ModelInfo& info, std::vector<double> parameters)
    : name_(info.name), info_(&info), parameters_(std::move(parameters)) {}

const kernels::ModelInfo& SoilModel::info() const {
  if (info_ == nullptr) {
    std::vector<std::string> names;
    for (const auto& model : kernels::models) names.emplace_back(model.name);
    throw SceneError(fmt::format("there is no model '{}'. {}", name_, did_you_mean(name_, names)));
  }
  return *info_;
}

double SoilModel::parameter(std::string_view name) const { return parameters_.at(index(name)); }

void SoilModel::set(std::string_view name, double value) {
  double& parameter = parameters_.at(index(name));
  const double before = std::exchange(parameter, value);
  // What took its value from this one, and still has it, follows.
  for (std::size_t k = 0; k < parameters_.size(); ++k) {
    const char* like = info().parameters[k].like;
    if (like != nullptr && like == name && parameters_[k] == before) parameters_[k] = value;
  }
}

kernels::ElasticModuli SoilModel::moduli() const { return info().moduli(prepare({})); }

void SoilModel::require(std::string_view name) const {
  if (name != name_) throw SceneError(fmt::format("the model is '{}', not '{}'", name_, name));
}

std::size_t SoilModel::index(std::string_view name) const {
  const auto found = info().parameter(name);
  if (found) return *found;
  std::vector<std::string> names;
  for (const auto& spec : info().parameters) names.emplace_back(spec.name);
  throw SceneError(fmt::format("model '{}' has no parameter '{}'. {}", name_, name,
                               did_you_mean(std::string(name), names)));
}

std::vector<kernels::StateField> history_of(const Scene& scene) {
  std::vector<kernels::StateField> all;
  for (const Material& material : scene.materials) {
    for (const kernels::StateField& field : material.model.info().state_fields) {
      if (std::none_of(all.begin(), all.end(), [&](const kernels::StateField& other) {
            return std::string_view(other.name) == field.name;
          }))
        all.push_back(field);
    }
  }
  if (all.size() > kernels::most_state_fields)
    throw SceneError(fmt::format(
        "the models of the scene have {} history variables together. Try models with {} at most.",
        all.size(), kernels::most_state_fields));
  return all;
}

}  // namespace scarp
