// SPDX-License-Identifier: BSD-3-Clause
/// What `scarp check --costs` and `--probe` print.
#pragma once

#include <nlohmann/json.hpp>

namespace scarp::cli {

/// `costs`: as from `check::costs`.
void print_costs(const nlohmann::ordered_json& costs);

/// `probed`: as from `check::probe`.
void print_probe(const nlohmann::ordered_json& probed);

}  // namespace scarp::cli
