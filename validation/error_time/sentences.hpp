// SPDX-License-Identifier: BSD-3-Clause
/// What a study says to someone who has to choose.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "validation/error_time/study.hpp"

namespace scarp::validation {

/// Errors that a user may want.
inline constexpr std::array targets{0.10, 0.05, 0.02, 0.01};

/// The cheapest point whose error is at most `target`, of one preset or of any if it is empty. Run
/// times within `near_factor` of the least count as equal: of those the one with the least error.
std::optional<std::size_t> cheapest(const ErrorStudy& study, double target,
                                    const std::string& preset = {});

/// What to take for each target, how the error of each preset as it stands falls or does not, the
/// least error its variants reach, what was unstable, and what limits all of it.
std::vector<std::string> sentences(const ErrorStudy& study);

}  // namespace scarp::validation
