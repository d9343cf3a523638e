// SPDX-License-Identifier: BSD-3-Clause
/// The JSON form of a measure, in the results of runs and of validation cases.
#pragma once

#include <nlohmann/json.hpp>

#include "engine/output/results.hpp"

namespace scarp {

/// name, value, unit, reference, band, source, pass; null where there is none.
nlohmann::ordered_json json_of(const Measure& measure);

}  // namespace scarp
