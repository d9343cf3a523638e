// SPDX-License-Identifier: BSD-3-Clause
/// How `scarp fos` settles a slope, from where it was left.
#pragma once

#include <filesystem>
#include <optional>

#include "engine/cli/commands.hpp"
#include "engine/cli/fos_output.hpp"
#include "engine/cli/fos_record.hpp"
#include "engine/cli/progress.hpp"
#include "engine/fos/strength_reduction.hpp"
#include "engine/run/run.hpp"

namespace scarp::cli {

/// A progress bar for each trial, begun at its first step.
class TrialProgress {
 public:
  explicit TrialProgress(bool quiet) : quiet_(quiet) {}
  bool operator()(const Simulation& now) {
    if (!bar_) bar_.emplace(total_duration(now.scene()), quiet_);
    bar_->update(now);
    return true;
  }
  void end() {
    if (bar_) bar_->end();
    bar_.reset();
  }

 private:
  bool quiet_;
  std::optional<Progress> bar_;
};

/// Settles, with as much strength as the slope needs for it, and with the cost of all attempts;
/// what has been found is kept in the folder now and then. Empty: told to stop.
std::optional<StrengthReduction> settle_in(const std::filesystem::path& folder, const Scene& scene,
                                           const FosArguments& arguments, FosReport& report,
                                           SearchRecord& record, TrialProgress& progress);

}  // namespace scarp::cli
