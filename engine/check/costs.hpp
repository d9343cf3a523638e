// SPDX-License-Identifier: BSD-3-Clause
/// `scarp check --costs`: what each part of the physics costs in a scene.
#pragma once

#include <nlohmann/json.hpp>

#include "engine/simulation.hpp"

namespace scarp::check {

/// The start of the scene beside the same without one of the parts it uses, in short trials that
/// take turns. A list of feature, share_of_step (the median over the turns of one less the ratio of
/// the times), bytes_per_particle (both can be negative: mixed precision keeps more and takes
/// less); null where one of the two becomes unstable.
nlohmann::ordered_json costs(const Scene& scene, const RunOptions& options);

}  // namespace scarp::check
