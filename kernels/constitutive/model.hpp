// SPDX-License-Identifier: BSD-3-Clause
/// What the header of a constitutive model is written with: elasticity, the increment of a step,
/// history variables.
///
/// A model is an aggregate of its parameters that declares
///   name, parameters   the name and one ParameterSpec for each member, in their order
///   members(self)      the same members as a tuple of references
///   state_fields       its history variables; an empty array: none
///   yields             whether it has plastic strain
///   Constants          what its `update` needs, trivially copyable
///   prepare(setting)   makes them of the parameters
///   moduli(constants)  of the elastic waves, which bound the time step
///   update(...)        stress and history of a point over one step, for double and for vectors
/// and may declare
///   strength()         Coulomb's cohesion and angles, if it has them
///   softens()          whether its strength can fall as its history changes; where it does not
///                      say, it does if it has history variables
///   yield_function     > 0 outside the yield surface [Pa]
///   shown, show        constants worth printing
///   complaint()        what is wrong with parameters that are each within their bounds
///   doubt(dimension)   what a scene of this dimension hardly means; a warning
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <tuple>
#include <type_traits>

#include "kernels/constitutive/parameter_spec.hpp"
#include "kernels/point_math.hpp"
#include "kernels/tensor.hpp"

namespace scarp::kernels {

/// Elastic moduli of a material. Equation: E14.
struct ElasticModuli {
  double bulk_modulus;   ///< K [Pa]
  double shear_modulus;  ///< G [Pa]

  /// K + 4/3 G, stress over strain of a plane wave [Pa].
  constexpr double wave_modulus() const { return bulk_modulus + 4.0 / 3.0 * shear_modulus; }
};

/// Equation: E14; K = E/(3(1-2 nu)), G = E/(2(1+nu)). Pre: 0 <= nu < 0.5.
constexpr ElasticModuli elastic_moduli(double youngs_modulus, double poisson_ratio) {
  return {youngs_modulus / (3.0 * (1.0 - 2.0 * poisson_ratio)),
          youngs_modulus / (2.0 * (1.0 + poisson_ratio))};
}

/// A history variable of a model.
struct StateField {
  const char* name;
  const char* unit;
  double initial_value;
  bool reset_at_stage;  ///< back to the initial value where a stage resets
  bool output;          ///< written to frames and probes
  const char* description;
};

/// The plastic strain that cones and Coulomb's surface share.
inline constexpr StateField accumulated_plastic_strain{
    "accumulated_plastic_strain",
    "-",
    0.0,
    true,
    true,
    "accumulated equivalent deviatoric plastic strain"};

/// A model has at most so many.
inline constexpr std::size_t most_state_fields = 4;

/// History variables of a point: the model reads `now` and writes how much they change over the
/// step. The pass adds the change, with Verlet the share of it that is new.
template <class T, std::size_t Count>
struct History {
  T now[Count > 0 ? Count : 1];
  T change[Count > 0 ? Count : 1];
};

/// What happens to a point in one step; the stress has been turned with the material before.
template <class T>
struct StrainIncrement {
  SymTensor<T> strain;     ///< [-]
  SymTensor<T> diffusion;  ///< stress from the stress diffusion, part of the trial stress [Pa]
  T density;               ///< at the start [kg/m3]
  double time;             ///< length of the step [s]
};

/// What `prepare` knows of a material besides its parameters.
struct MaterialSetting {
  double strength_reduction = 1.0;  ///< SRF of Eq. 31
  double spacing = 1.0;             ///< of the particles [m]
  double reference_density = 1.0;   ///< [kg/m3]
};

/// Coulomb's constants. Equation: E31 for the reduced ones.
struct CoulombStrength {
  double cohesion;        ///< c [Pa]
  double friction_angle;  ///< phi [rad]
  double dilation_angle;  ///< psi [rad]

  /// c/SRF and atan(tan phi / SRF); the dilation angle is kept but never above phi.
  CoulombStrength reduced(double reduction) const {
    const double phi = __builtin_atan(__builtin_tan(friction_angle) / reduction);
    return {cohesion / reduction, phi, __builtin_fmin(dilation_angle, phi)};
  }
};

/// A constant that `scarp element` prints.
struct ShownConstant {
  const char* name;
  const char* unit;
};

/// A parameter that does not go with the others.
struct ParameterComplaint {
  std::size_t parameter;  ///< index into the model's parameters
  const char* why;        ///< why it is wrong and what to try
};

/// Of the dilation angle, the parameter with this index.
constexpr std::optional<ParameterComplaint> dilation_complaint(const CoulombStrength& strength,
                                                               std::size_t parameter) {
  if (!(strength.dilation_angle > strength.friction_angle)) return {};
  return ParameterComplaint{parameter,
                            "dilation above the friction angle would create energy. Try at most "
                            "the friction angle."};
}

/// The stress after an elastic step: Hooke's law and what the diffusion adds. Equation: E4, E21.
template <class T>
SCARP_INLINE SymTensor<T> elastic_trial(const ElasticModuli& moduli, const StrainIncrement<T>& step,
                                        const SymTensor<T>& stress) {
  return stress + T(2.0 * moduli.shear_modulus) * deviator(step.strain) +
         isotropic(T(moduli.bulk_modulus) * trace(step.strain)) + step.diffusion;
}

/// Elastic strain of a stress, C^-1 : sigma.
template <class T>
SCARP_INLINE SymTensor<T> elastic_strain(const ElasticModuli& moduli, const SymTensor<T>& s) {
  return T(0.5 / moduli.shear_modulus) * deviator(s) +
         isotropic(trace(s) * T(1.0 / (9.0 * moduli.bulk_modulus)));
}

template <class T>
SCARP_INLINE T root_j2(const SymTensor<T>& deviatoric_stress) {
  return root(T(0.5) * contract(deviatoric_stress, deviatoric_stress));
}

/// Parameters as numbers in the order of the model's table, choices as their index.
template <class Model>
std::array<double, Model::parameters.size()> values_of(const Model& model) {
  return std::apply(
      [](const auto&... member) {
        return std::array<double, sizeof...(member)>{static_cast<double>(member)...};
      },
      Model::members(model));
}

/// The model with these parameters. Pre: one value for each.
template <class Model>
Model model_of(std::span<const double> values) {
  Model model;
  std::size_t next = 0;
  std::apply(
      [&](auto&... member) {
        ((member = static_cast<std::remove_reference_t<decltype(member)>>(values[next++])), ...);
      },
      Model::members(model));
  return model;
}

}  // namespace scarp::kernels
