// SPDX-License-Identifier: BSD-3-Clause
/// The sentence that says what a run did.
#include <cmath>

#include <fmt/format.h>

#include "engine/errors.hpp"

namespace scarp {

std::string Instability::message() const {
  const std::string who = particle < 0
                              ? std::string("the soil")
                              : fmt::format("particle {} at ({:.6g}, {:.6g}, {:.6g}) m", particle,
                                            position[0], position[1], position[2]);
  const std::string bound = std::isnan(limit) ? std::string("is not finite")
                                              : fmt::format("is beyond {:.4g} {}", limit, unit);
  return fmt::format(
      "step {} at {:.6g} s (stage '{}'): {}: {} = {:.4g} {} {}. Likely cause: {}. "
      "Try {}.",
      step, time, stage, who, field, value, unit, bound, cause, advice);
}

}  // namespace scarp
