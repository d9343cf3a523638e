// SPDX-License-Identifier: BSD-3-Clause
/// Schedule and upkeep of a run's checkpoints.
#include "engine/run/checkpoint_writer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <regex>
#include <utility>

#include <fmt/format.h>

#include "engine/errors.hpp"
#include "engine/output/checkpoint_file.hpp"
#include "engine/output/result_files.hpp"
#include "engine/output/text_file.hpp"

namespace scarp {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t checkpoints_kept = 2;
constexpr const char* kept_pattern = R"(kept_\d{12}\.h5)";

fs::path folder_of(const fs::path& run) { return run / "checkpoints"; }

double next_after(double time, double interval) {
  return interval > 0.0 ? (std::floor(time / interval * (1.0 + 1e-12)) + 1.0) * interval
                        : std::numeric_limits<double>::infinity();
}

std::vector<fs::path> files_of(const fs::path& run, const std::regex& pattern) {
  std::vector<fs::path> found;
  try {
    if (!fs::exists(folder_of(run))) return found;
    for (const auto& entry : fs::directory_iterator(folder_of(run))) {
      if (std::regex_match(entry.path().filename().string(), pattern))
        found.push_back(entry.path());
    }
  } catch (const fs::filesystem_error& error) {
    throw FileError(
        fmt::format("'{}': cannot be read: {}.", folder_of(run).string(), error.code().message()));
  }
  std::sort(found.rbegin(), found.rend());
  return found;
}

}  // namespace

std::vector<fs::path> checkpoints_in(const fs::path& folder) {
  const std::regex complete(R"(step_\d{12}\.h5)");
  return files_of(folder, complete);
}

fs::path checkpoint_of(const fs::path& folder, std::uint64_t step) {
  return folder_of(folder) / fmt::format("step_{:012}.h5", step);
}

void make_checkpoint_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directory(folder_of(folder), error);
  if (error) {
    throw FileError(
        fmt::format("'{}': cannot be made: {}.", folder_of(folder).string(), error.message()));
  }
}

fs::path kept_state(const fs::path& folder, std::uint64_t step) {
  return folder_of(folder) / fmt::format("kept_{:012}.h5", step);
}

void remove_checkpoints_after(const fs::path& folder, std::uint64_t step) {
  for (const fs::path& path : checkpoints_in(folder)) {
    if (path.filename() > checkpoint_of(folder, step).filename()) remove_file(path);
  }
  for (const fs::path& path : files_of(folder, std::regex(kept_pattern))) {
    if (path.filename() > kept_state(folder, step).filename()) remove_file(path);
  }
}

void remove_checkpoints(const fs::path& folder) {
  const std::regex ours(R"((?:step|kept)_\d{12}\.h5(\.part)?)");
  for (const fs::path& path : files_of(folder, ours)) remove_file(path);
}

CheckpointWriter::CheckpointWriter(const Simulation& simulation, RunWriter& outputs,
                                   std::function<Clock::time_point()> now, Recovery* recovery)
    : outputs_(outputs),
      recovery_(recovery),
      kept_(recovery == nullptr ? std::vector<std::uint64_t>{} : recovery->steps()),
      wanted_(simulation.scene().checkpoints),
      now_(std::move(now)),
      next_(next_after(simulation.last_step().time, wanted_.interval)) {
  const std::regex half_written(R"((?:step|kept)_\d{12}\.h5\.part)");
  for (const fs::path& path : files_of(outputs_.folder(), half_written)) remove_file(path);
}

bool CheckpointWriter::due(const Simulation& simulation) {
  const bool any = wanted_.interval > 0.0 || wanted_.wall_interval > 0.0;
  if (simulation.last_step().time >= next_ || (any && simulation.finished())) return true;
  return wanted_.wall_interval > 0.0 &&
         std::chrono::duration<double>(now_() - last_).count() >= wanted_.wall_interval;
}

std::string CheckpointWriter::after_step(const Simulation& simulation) {
  if (!due(simulation)) return {};
  try {
    write(simulation);
  } catch (const FileError& error) {
    if (wanted_.stop_on_error) throw;
    last_ = now_();
    next_ = next_after(simulation.last_step().time, wanted_.interval);
    return fmt::format("no checkpoint at step {}: {} The run goes on.", simulation.last_step().step,
                       error.what());
  }
  return {};
}

void CheckpointWriter::write(const Simulation& simulation) {
  const auto began = Clock::now();
  simulation.require_sound();
  make_checkpoint_folder(outputs_.folder());
  flush_to_disk(outputs_.folder());
  Snapshot snapshot = simulation.snapshot();
  outputs_.add_progress(snapshot);
  std::vector<std::uint64_t> states;
  if (recovery_ != nullptr) {
    recovery_->write_states(outputs_.folder());
    states = recovery_->steps();
  }
  snapshot.add("retry/kept_steps", std::vector<std::int64_t>(states.begin(), states.end()));
  write_checkpoint(checkpoint_of(outputs_.folder(), simulation.last_step().step),
                   std::move(snapshot));
  kept_before_ = std::exchange(kept_, std::move(states));
  remove_old_files();
  outputs_.add_checkpoint_time(std::chrono::duration<double>(Clock::now() - began).count());
  last_ = now_();
  next_ = next_after(simulation.last_step().time, wanted_.interval);
}

void CheckpointWriter::remove_old_files() {
  const std::vector<fs::path> all = checkpoints_in(outputs_.folder());
  for (std::size_t k = checkpoints_kept; k < all.size(); ++k) remove_file(all[k]);
  std::vector<fs::path> old = files_of(outputs_.folder(), std::regex(kept_pattern));
  for (const auto* states : {&kept_, &kept_before_}) {
    for (const std::uint64_t step : *states) std::erase(old, kept_state(outputs_.folder(), step));
  }
  for (const fs::path& path : old) remove_file(path);
}

void CheckpointWriter::went_back(const Simulation& simulation) {
  next_ = next_after(simulation.last_step().time, wanted_.interval);
}

}  // namespace scarp
