// SPDX-License-Identifier: BSD-3-Clause
/// A model as data and functions at run time, made from its header.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string_view>

#include "kernels/constitutive/list.hpp"
#include "kernels/constitutive/model_passes.hpp"

namespace scarp::kernels {

/// A model of the list, or one that a program brings. `values`: its parameters in order.
struct ModelInfo {
  using Values = std::span<const double>;

  std::string_view name;
  std::span<const ParameterSpec> parameters;
  std::span<const StateField> state_fields;
  std::span<const ShownConstant> shown;
  bool yields;
  ModelConstants (*prepare)(Values, const MaterialSetting&);
  ElasticModuli (*moduli)(const ModelConstants&);
  std::optional<CoulombStrength> (*strength)(Values);
  bool (*softens)(Values);
  std::optional<ParameterComplaint> (*complaint)(Values);
  std::optional<ParameterComplaint> (*doubt)(Values, int dimension);
  /// NaN where the model does not say.
  double (*yield_function)(const ModelConstants&, const SymTensor<double>&, Values history);
  void (*show)(const ModelConstants&, std::span<double> out);  ///< as many as `shown`
  const ModelPasses* passes;  ///< of a model that a program brings; null: the kernel table's

  std::optional<std::size_t> parameter(std::string_view wanted) const {
    for (std::size_t p = 0; p < parameters.size(); ++p) {
      if (parameters[p].name == wanted) return p;
    }
    return {};
  }
};

template <class Model>
inline constexpr ModelInfo info_of(const ModelPasses* passes = nullptr) {
  using Constants = typename Model::Constants;
  using Values = ModelInfo::Values;
  static_assert(Model::state_fields.size() <= most_state_fields);
  ModelInfo info{};
  info.name = Model::name;
  info.parameters = Model::parameters;
  info.state_fields = Model::state_fields;
  info.yields = Model::yields;
  info.prepare = [](Values values, const MaterialSetting& setting) {
    return packed(model_of<Model>(values).prepare(setting));
  };
  info.moduli = [](const ModelConstants& c) { return Model::moduli(unpacked<Constants>(c)); };
  info.strength = [](Values values) -> std::optional<CoulombStrength> {
    if constexpr (requires(const Model& m) { m.strength(); }) {
      return model_of<Model>(values).strength();
    } else {
      return {};
    }
  };
  info.softens = []([[maybe_unused]] Values values) {
    if constexpr (requires(const Model& m) { m.softens(); }) {
      return model_of<Model>(values).softens();
    } else {
      return !Model::state_fields.empty();
    }
  };
  info.complaint = [](Values values) -> std::optional<ParameterComplaint> {
    if constexpr (requires(const Model& m) { m.complaint(); }) {
      return model_of<Model>(values).complaint();
    } else {
      return {};
    }
  };
  info.doubt = [](Values values, int dimension) -> std::optional<ParameterComplaint> {
    if constexpr (requires(const Model& m) { m.doubt(dimension); }) {
      return model_of<Model>(values).doubt(dimension);
    } else {
      return {};
    }
  };
  info.yield_function = [](const ModelConstants& c, const SymTensor<double>& stress,
                           Values history) {
    if constexpr (requires { &Model::yield_function; }) {
      return Model::yield_function(unpacked<Constants>(c), stress, history);
    } else {
      return std::numeric_limits<double>::quiet_NaN();
    }
  };
  info.show = [](const ModelConstants& c, std::span<double> out) {
    if constexpr (requires { Model::shown; }) {
      const auto values = Model::show(unpacked<Constants>(c));
      for (std::size_t k = 0; k < values.size(); ++k) out[k] = values[k];
    }
  };
  if constexpr (requires { Model::shown; }) info.shown = Model::shown;
  info.passes = passes;
  return info;
}

template <class... Model>
constexpr std::array<ModelInfo, sizeof...(Model)> infos_of(ModelList<Model...>) {
  return {info_of<Model>()...};
}
/// The models of the list, in its order.
inline constexpr std::array<ModelInfo, Models::size> models = infos_of(Models{});

/// The model of the list with this name, or null.
constexpr const ModelInfo* model_named(std::string_view name) {
  for (const ModelInfo& info : models) {
    if (info.name == name) return &info;
  }
  return nullptr;
}

}  // namespace scarp::kernels
