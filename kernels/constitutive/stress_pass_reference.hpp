// SPDX-License-Identifier: BSD-3-Clause
/// Plain scalar form of the stress pass with full 3 x 3 matrices, derived from the flow rule rather
/// than from its closed forms. The oracle of the passes, never part of a run.
#pragma once

#include <array>
#include <string_view>

#include "kernels/particle_view.hpp"

namespace scarp::kernels {

using ReferenceMatrix = std::array<std::array<double, 3>, 3>;

/// State of one particle, as in ParticleView; SI.
struct ReferencePoint {
  std::array<double, 3> position{}, velocity{}, previous_velocity{};
  double density = 0.0, previous_density = 0.0;
  ReferenceMatrix stress{}, previous_stress{};
  std::array<double, 4> history{};
  double plastic_work = 0.0, diffusion_work = 0.0, stress_work = 0.0;
  double diffusivity = 0.0;
};

/// Rates of one particle from the pair sweep.
struct ReferencePointRates {
  double density_rate = 0.0;
  ReferenceMatrix velocity_gradient{}, moment{};
  std::array<double, 3> acceleration{};
  ReferenceMatrix diffusion_rate{};
  double diffusion_slope = 0.0;
};

/// What a model is checked by: its return from a trial stress, derived from the flow rule, and how
/// much its history changes. Null: elastic.
using ReferenceReturn = ReferenceMatrix (*)(const ModelConstants&, const ReferenceMatrix& trial,
                                            const ReferencePoint& point,
                                            std::array<double, 4>& change);
struct ReferenceModel {
  double bulk_modulus, shear_modulus;  ///< [Pa]
  ReferenceReturn come_back;
};
/// The oracle of the model with this name. Pre: it has one.
ReferenceModel reference_model(std::string_view name, const ModelConstants& constants);

/// One Verlet step; returns whether a density bound acted. Equation: E28, E29 with the rates of
/// E18, E19, E21.
bool advance_verlet_reference(const ReferencePointRates& rates,
                              const StressPassConstants& constants, const VerletConstants& verlet,
                              int dimension, const ReferenceModel& model, ReferencePoint& point);

/// Stress and density over one leap (kick-drift-kick); returns whether a density bound acted.
/// Equation: E18.
bool advance_stress_reference(const ReferencePointRates& rates,
                              const StressPassConstants& constants, int dimension,
                              const ReferenceModel& model, ReferencePoint& point);

}  // namespace scarp::kernels
