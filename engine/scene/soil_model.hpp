// SPDX-License-Identifier: BSD-3-Clause
/// A constitutive model with its parameters, as a material holds it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "kernels/constitutive/model_info.hpp"

namespace scarp {

using kernels::Cone;
using kernels::DruckerPrager;
using kernels::LinearElastic;
using kernels::MohrCoulomb;
using kernels::SofteningLaw;

/// Made of a typed model, `DruckerPrager{.youngs_modulus = 10e6, ...}`, or of a name and numbers.
class SoilModel {
 public:
  /// Drucker-Prager soil whose parameters are still to be given.
  SoilModel() : SoilModel(DruckerPrager{}) {}
  /// A model of the list. One that a program brings: `custom_model` of `engine/custom_model.hpp`.
  template <class Model>
  requires(kernels::Models::holds<Model>) SoilModel(const Model& model)
      : SoilModel(*kernels::model_named(Model::name), numbers(model)) {}
  /// Parameters in the order of the model's table, SI, choices as their index. A name that no model
  /// has is an error when the scene is checked.
  SoilModel(std::string name, std::vector<double> parameters);
  /// Pre: `info` lives as long as the scene.
  SoilModel(const kernels::ModelInfo& info, std::vector<double> parameters);

  const std::string& name() const { return name_; }
  bool known() const { return info_ != nullptr; }
  const kernels::ModelInfo& info() const;  ///< Errors: SceneError for an unknown name
  const std::vector<double>& parameters() const { return parameters_; }

  /// One parameter by its name, SI. Errors: SceneError where the model has none of this name.
  double parameter(std::string_view name) const;
  /// A parameter that is `like` this one (a residual strength), and equal to it, is set with it.
  void set(std::string_view name, double value);
  bool has(std::string_view name) const { return known() && info_->parameter(name).has_value(); }
  /// The typed model. Errors: SceneError if it is another one.
  template <class Model>
  Model as() const {
    require(Model::name);
    return kernels::model_of<Model>(parameters_);
  }

  /// Pre of all below: the parameters are valid.
  bool yields() const { return info().yields; }
  /// Whether the strength can fall as the soil deforms.
  bool softens() const { return info().softens(parameters_); }
  kernels::ElasticModuli moduli() const;
  std::optional<kernels::CoulombStrength> strength() const { return info().strength(parameters_); }
  kernels::ModelConstants prepare(const kernels::MaterialSetting& setting) const {
    return info().prepare(parameters_, setting);
  }

 private:
  template <class Model>
  static std::vector<double> numbers(const Model& model) {
    const auto values = kernels::values_of(model);
    return {values.begin(), values.end()};
  }
  void require(std::string_view name) const;
  std::size_t index(std::string_view name) const;

  std::string name_;
  const kernels::ModelInfo* info_ = nullptr;
  std::vector<double> parameters_;
};

}  // namespace scarp
