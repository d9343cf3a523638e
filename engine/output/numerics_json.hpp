// SPDX-License-Identifier: BSD-3-Clause
/// The numerics of a run as results.json has them.
#pragma once

#include <nlohmann/json.hpp>

#include "engine/scene/scene.hpp"

namespace scarp {

/// Every row by its key, with what the scene leaves open filled in.
nlohmann::ordered_json numerics_json(const Scene& scene);

}  // namespace scarp
