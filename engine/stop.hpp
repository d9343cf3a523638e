// SPDX-License-Identifier: BSD-3-Clause
/// Where long work asks whether it is still wanted.
#pragma once

#include <functional>

#include "engine/errors.hpp"

namespace scarp {

/// Errors: Stopped if `stop` is there and says so.
inline void stop_if_asked(const std::function<bool()>& stop) {
  if (stop && stop()) throw Stopped();
}

}  // namespace scarp
