// SPDX-License-Identifier: BSD-3-Clause
/// The one list of constitutive models; everything else about them follows from their headers.
#pragma once

#include "kernels/constitutive/drucker_prager.hpp"
#include "kernels/constitutive/linear_elastic.hpp"
#include "kernels/constitutive/mohr_coulomb.hpp"

namespace scarp::kernels {

template <class... Model>
struct ModelList {
  static constexpr std::size_t size = sizeof...(Model);
  template <class Other>
  static constexpr bool holds = (std::is_same_v<Model, Other> || ...);
};

using Models = ModelList<LinearElastic, DruckerPrager, MohrCoulomb>;

}  // namespace scarp::kernels
