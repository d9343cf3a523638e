// SPDX-License-Identifier: BSD-3-Clause
/// One material point, advanced by the stress pass of the engine with no particles around it.
#pragma once

#include <array>
#include <map>
#include <string>
#include <string_view>

#include "engine/simulation.hpp"
#include "kernels/isa/kernel_table.hpp"

namespace scarp {

/// State of a material point; tensors in the order xx, yy, zz, xy, yz, zx, tension positive.
struct PointState {
  std::array<double, 6> stress{};  ///< [Pa]
  std::array<double, 6> strain{};  ///< sum of the strain increments along fixed axes [-]
  double density = 0.0;            ///< [kg/m3]
  std::array<double, kernels::most_state_fields> history{};  ///< variables of the model
};

/// Velocity gradient times the step, L_ab dt, row-major 3 x 3 [-].
using GradientIncrement = std::array<double, 9>;

/// The stress pass of a scene for one of its materials: the kernel a run with kick-drift-kick would
/// use, with the scene's rotation and density bounds, without stress diffusion, which
/// needs neighbours. Owns no state.
class MaterialPoint {
 public:
  /// Of the material with this name, of the only one without; `dimension` 2 takes the pass of plane
  /// strain. Errors: SceneError.
  MaterialPoint(const Scene& scene, std::string_view material, int dimension,
                const RunOptions& options = {}, double strength_reduction = 1.0);

  /// At rest under this stress, without strain.
  PointState at(const std::array<double, 6>& stress) const;

  /// The state one step later. Equation: E18, over a step of any length, as its rates are given
  /// times the step. Pre: in 2D the third row and column of `increment` are 0.
  PointState advance(const PointState& from, const GradientIncrement& increment) const;

  double first_invariant(const PointState& state) const;  ///< I1 [Pa]
  double root_j2(const PointState& state) const;          ///< sqrt(J2) [Pa]
  /// f of the model [Pa], > 0 outside its yield surface; NaN if it has none.
  double yield_function(const PointState& state) const;
  /// Total less elastic volumetric strain since a start under `start` [-].
  double plastic_volumetric_strain(const PointState& state, const PointState& start) const;

  const kernels::ModelInfo& model() const { return model_.info(); }
  const kernels::ModelConstants& constants() const { return constants_.model; }
  kernels::ElasticModuli moduli() const { return model_.moduli(); }
  /// Constants that the model shows, by name.
  std::map<std::string, double> shown() const;
  int dimension() const { return dimension_; }
  std::string isa() const { return table_->name; }

 private:
  kernels::StressPassConstants constants_;
  const kernels::KernelTable* table_;
  SoilModel model_;
  int dimension_;
};

}  // namespace scarp
