// SPDX-License-Identifier: BSD-3-Clause
/// How `scarp fos` settles a slope, from where it was left.
#pragma once

#include <filesystem>
#include <optional>

#include "engine/cli/commands.hpp"
#include "engine/cli/fos_output.hpp"
#include "engine/cli/fos_record.hpp"
#include "engine/cli/search_progress.hpp"
#include "engine/fos/strength_reduction.hpp"

namespace scarp::cli {

/// Settles, with as much strength as the slope needs for it, and with the cost of all attempts;
/// what has been found is kept in the folder now and then. Empty: told to stop.
std::optional<StrengthReduction> settle_in(const std::filesystem::path& folder, const Scene& scene,
                                           const FosArguments& arguments, FosReport& report,
                                           SearchRecord& record, SearchProgress& progress);

}  // namespace scarp::cli
