// SPDX-License-Identifier: GPL-2.0-only
/// What all processes but the first do.
#pragma once

#include <functional>
#include <memory>

#include "engine/distributed/soil_parts.hpp"
#include "engine/run_options.hpp"
#include "engine/scene/scene.hpp"

namespace scarp::distributed {

/// Makes the calls that the first process makes until that lets go, and returns its exit code.
/// `load` reads the scene that the first process reads; `options` hold `parts` as their reduction.
int follow(const std::shared_ptr<SoilParts>& parts, const std::function<Scene()>& load,
           const RunOptions& options);

}  // namespace scarp::distributed
