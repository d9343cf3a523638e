// SPDX-License-Identifier: BSD-3-Clause
/// Numbers of a snapshot that must be numbers.
#pragma once

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "engine/checkpoint/snapshot.hpp"
#include "engine/errors.hpp"

namespace scarp {

/// As `Snapshot::numbers`. Errors: CheckpointError, too, if one of them is not finite.
inline const std::vector<double>& finite_numbers(const Snapshot& snapshot, std::string_view name,
                                                 std::size_t count) {
  const std::vector<double>& values = snapshot.numbers(name, count);
  const auto bad = std::find_if(values.begin(), values.end(),
                                [](double value) { return !std::isfinite(value); });
  if (bad == values.end()) return values;
  throw CheckpointError(fmt::format("'{}' holds {} at place {}, which no run leaves.", name, *bad,
                                    bad - values.begin()));
}

}  // namespace scarp
