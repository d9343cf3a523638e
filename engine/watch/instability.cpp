// SPDX-License-Identifier: BSD-3-Clause
/// The sentence that says what a run did.
#include <cmath>

#include <fmt/format.h>

#include "engine/errors.hpp"

namespace scarp {

std::string Instability::message() const {
  const std::string bound = std::isnan(limit) ? std::string("is not finite")
                                              : fmt::format("is beyond {:.4g} {}", limit, unit);
  return fmt::format(
      "step {} at {:.6g} s (stage '{}'): particle {} at ({:.6g}, {:.6g}, {:.6g}) m: {} = {:.4g} {} "
      "{}. Possible causes: {}. Try {}.",
      step, time, stage, particle, position[0], position[1], position[2], field, value, unit, bound,
      cause, advice);
}

}  // namespace scarp
