// SPDX-License-Identifier: BSD-3-Clause
/// The one list of constitutive models: reader, validation, stress pass and tests iterate it.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

#include "kernels/constitutive/drucker_prager.hpp"
#include "kernels/constitutive/linear_elastic.hpp"

namespace scarp::kernels {

struct ModelInfo {
  std::string_view name;
  std::span<const ParameterSpec> parameters;
};

inline constexpr std::array<ModelInfo, 2> models{{
    {LinearElastic::name, LinearElastic::parameters},
    {DruckerPrager::name, DruckerPrager::parameters},
}};

/// Index of the model in `models`, or -1.
constexpr int model_index(std::string_view name) {
  for (std::size_t m = 0; m < models.size(); ++m) {
    if (models[m].name == name) return static_cast<int>(m);
  }
  return -1;
}

}  // namespace scarp::kernels
