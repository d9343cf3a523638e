// SPDX-License-Identifier: BSD-3-Clause
/// How long a search for a factor of safety takes, before and while it goes on.
#pragma once

#include <string>

#include "engine/fos/strength_reduction.hpp"

namespace scarp::cli {

/// A sentence, from half a second of steps on a copy and a rehearsal of the settling on a coarse
/// lattice: what is expected, and settling and trials at their longest.
std::string search_forecast(const Simulation& start, const Criterion& criterion,
                            const SearchOptions& search);

/// "at most 4 more trials, 12 min", from those that are done; empty at the end.
std::string time_left(const SearchOptions& search, const FactorOfSafety& found);

}  // namespace scarp::cli
