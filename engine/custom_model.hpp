// SPDX-License-Identifier: BSD-3-Clause
/// A constitutive model that a program brings: its header alone, as
/// `kernels/constitutive/model.hpp` describes it, makes it the equal of the models of the list.
#pragma once

#include "engine/scene/soil_model.hpp"
#include "kernels/constitutive/stress_pass.hpp"
#include "kernels/lanes.hpp"

namespace scarp {

/// Passes of the model, compiled where this is used and for the instructions that file is compiled
/// for.
template <class Model>
inline constexpr kernels::ModelPasses custom_passes{
    {&kernels::advance_stress<kernels::Lanes, 2, Model>,
     &kernels::advance_stress<kernels::Lanes, 3, Model>},
    {&kernels::advance_verlet<kernels::Lanes, 2, Model>,
     &kernels::advance_verlet<kernels::Lanes, 3, Model>}};
template <class Model>
inline constexpr kernels::ModelInfo custom_info = kernels::info_of<Model>(&custom_passes<Model>);

/// The model as a material holds it: `Material{.name = "clay", .model = custom_model(Mine{...})}`.
template <class Model>
SoilModel custom_model(const Model& model) {
  const auto values = kernels::values_of(model);
  return {custom_info<Model>, {values.begin(), values.end()}};
}

}  // namespace scarp
