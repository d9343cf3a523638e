// SPDX-License-Identifier: BSD-3-Clause
/// The scalar of the slope for error against run time: how far the crest gives way while it stands.

#include <cmath>
#include <numbers>

#include "validation/case_list.hpp"

namespace scarp::validation {
namespace {

constexpr double reduction = 1.2;     ///< 13 % below the limit: plastic zones, but no band
constexpr double at_rest = 1e-4;      ///< [m/s]; moves 4e-6 m, 0.2 % of the answer, in the time 1/c
constexpr double column_height = 15;  ///< [m]

/// pi c_p/(2H), as an `until = "rest"` stage that resets would take it [1/s].
double critical_damping(const Material& soil) {
  const double youngs = soil.model.parameter("youngs_modulus"),
               poisson = soil.model.parameter("poisson_ratio");
  const double modulus = youngs * (1.0 - poisson) / ((1.0 + poisson) * (1.0 - 2.0 * poisson));
  return std::numbers::pi * std::sqrt(modulus / soil.density) / (2.0 * column_height);
}

double crest_displacement(CaseRun& run, const Scene& given) {
  Scene scene = given;
  Stage& cut = scene.stages.back();
  cut.strength_reduction = reduction;
  cut.rest_velocity = at_rest;
  cut.damping = critical_damping(scene.materials.front());
  cut.duration = 4.0;
  scene.output.energy = false;
  const Vec3 u = run.solve("standing", scene).probe(0).displacement;
  return std::hypot(u[0], u[1]);
}

}  // namespace

const ErrorProblem slope_2d_problem{
    "displacement of the crest when the strength is cut by 1.2 and the slope still stands",
    {1.0, 0.5, 0.25, 0.125},
    crest_displacement,
    true};

}  // namespace scarp::validation
