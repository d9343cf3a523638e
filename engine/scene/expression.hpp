// SPDX-License-Identifier: BSD-3-Clause
/// Formulas of a scene, as muParser understands them; the only place that knows muParser.
#pragma once

#include <memory>
#include <stdexcept>
#include <string>

#include "engine/scene/scene.hpp"

namespace scarp {

/// Why a formula is none; the message begins with the letter's number.
struct ExpressionError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A number that depends on the place: arithmetic and muParser's functions of x, y, z [m] and pi.
/// One object must not be evaluated by two threads at once.
class Expression {
 public:
  /// `variables`: the names allowed, "xy" or "xyz". Errors: ExpressionError.
  Expression(const std::string& text, const std::string& variables);
  /// Errors: ExpressionError.
  double operator()(const Vec3& place) const;

 private:
  struct Parser;
  std::shared_ptr<Parser> parser_;
};

}  // namespace scarp
