// SPDX-License-Identifier: BSD-3-Clause
/// Numbers with units as a scene writes them ("100 MPa", "20 deg", 0.25) into SI.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

#include "kernels/constitutive/parameter_spec.hpp"

namespace scarp {

/// Why a text is no value of the wanted dimension, and what is accepted; the reader adds file,
/// line, key.
class UnitError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// "100 MPa" in SI. Errors: UnitError for a missing, unknown or wrong unit and for a non-finite
/// number.
double parse_quantity(std::string_view text, kernels::Unit unit);

/// A bare number, taken as SI. Errors: UnitError if it is not finite, or an angle that is not 0
/// (which must say deg or rad, because either would be plausible).
double check_bare_number(double value, kernels::Unit unit);

/// What a unit measures, with its article: "a length".
std::string_view quantity_name(kernels::Unit unit);

/// The units accepted, for messages: "Pa, kPa, MPa, GPa".
std::string accepted_units(kernels::Unit unit);

}  // namespace scarp
