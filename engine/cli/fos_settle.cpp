// SPDX-License-Identifier: BSD-3-Clause
/// Attempts to settle a slope, and what is kept of them.
#include "engine/cli/fos_settle.hpp"

#include <fmt/format.h>

#include <chrono>

#include "engine/cli/interrupt.hpp"
#include "engine/errors.hpp"

namespace scarp::cli {
namespace {

/// Keeps what has been found while a slope settles: now and then, at its end, when told to stop.
class SettlingKeeper {
 public:
  SettlingKeeper(const Scene& scene, const std::filesystem::path& folder, SearchRecord& record)
      : folder_(folder),
        record_(record),
        stages_(scene.stages.size()),
        interval_(scene.checkpoints.wall_interval),
        before_(record.settle_wall_s) {}
  void after_step(const Simulation& now) {
    if (now.stage_index() + 1 >= stages_) return;  // a trial
    const bool settled = now.stage_ended() && now.stage_index() + 2 == stages_;
    const bool due = interval_ > 0.0 && since(last_) >= interval_;
    if (settled || due || stop_requested()) keep(now);
  }
  void begin_again(double strengthening) {
    forget_state(folder_);
    record_.strengthening = strengthening;
    record_.settle_wall_s = seconds();
    write_search(folder_, record_);
  }
  double seconds() const { return before_ + since(start_); }

 private:
  using Clock = std::chrono::steady_clock;
  static double since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
  }
  void keep(const Simulation& now) {
    last_ = Clock::now();
    record_.settle_wall_s = seconds();
    try {
      keep_state(folder_, now);
    } catch (const FileError& error) {
      fmt::print(stderr, "warning: the state is not kept: {}\n", error.what());
    }
    write_search(folder_, record_);
  }

  const std::filesystem::path& folder_;
  SearchRecord& record_;
  std::size_t stages_;
  double interval_, before_;  ///< [s]
  Clock::time_point start_ = Clock::now(), last_ = start_;
};

}  // namespace

std::optional<StrengthReduction> settle_in(const std::filesystem::path& folder, const Scene& scene,
                                           const FosArguments& arguments, FosReport& report,
                                           SearchRecord& record, SearchProgress& progress) {
  SettlingKeeper keeper(scene, folder, record);
  const auto told = [&](double strengthening) {
    progress.end();
    keeper.begin_again(strengthening);
    if (arguments.quiet) return;
    fmt::print(stderr,
               "the slope fails with the strength it settles with: once more from the start, with "
               "{:g} times the scene's\n",
               strengthening);
  };
  const auto each_step = [&](const Simulation& now) {
    const bool goes_on = progress(now);
    keeper.after_step(now);
    return goes_on;
  };
  SettleStart start{record.strengthening, kept_settling(folder), record.elastic};
  if (start.state && !arguments.quiet) {
    fmt::print(stderr, "goes on with the state at {:.4g} s\n",
               start.state->numbers("clock/time", 1).front());
  }
  const auto attempt = [&] {
    return settle_standing(scene, arguments.scene.options, report.criterion, each_step, told,
                           start);
  };
  std::optional<StandingSlope> standing;
  try {
    standing = attempt();
  } catch (const CheckpointError& error) {
    fmt::print(stderr, "warning: settles from the start: {}\n", error.what());
    start.state.reset();
    standing = attempt();
  }
  progress.end();
  if (!standing) return {};
  report.strengthening = standing->strengthening;
  report.settle_time = standing->settle_time;
  report.settled_at_rest = standing->slope.settled().stage_reached_rest();
  report.settle_wall_s = record.settle_wall_s;
  return std::move(standing->slope);
}

}  // namespace scarp::cli
