// SPDX-License-Identifier: BSD-3-Clause
/// What a constitutive model declares of each parameter, so that reader, documents and tests
/// iterate.
#pragma once

#include <limits>

namespace scarp::kernels {

/// Physical dimension of a scene value; decides which unit strings are accepted. SI inside.
enum class Unit {
  none,
  length,
  time,
  velocity,
  acceleration,
  density,
  unit_weight,
  pressure,
  angle,
  choice
};

/// `default_value` NaN means required. A choice is stored as the index into `choices` ("a|b|c");
/// its `default_value_3d` may differ from the one in 2D. A parameter that is `like` an earlier one
/// takes that one's value where the scene says nothing.
struct ParameterSpec {
  const char* name;
  Unit unit;
  double minimum;
  double maximum;
  double default_value;
  double default_value_3d;
  const char* choices;
  const char* description;
  const char* like = nullptr;
};

inline constexpr double required = std::numeric_limits<double>::quiet_NaN();
inline constexpr double right_angle = 1.5707963267948966;

}  // namespace scarp::kernels
