// SPDX-License-Identifier: BSD-3-Clause
/// When outputs fall due, and the loop of a run.

#include "engine/output/run_writer.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <limits>
#include <system_error>

#include "engine/checkpoint/finite_numbers.hpp"
#include "engine/errors.hpp"
#include "engine/output/result_files.hpp"
#include "engine/output/run_progress.hpp"
#include "engine/output/text_file.hpp"

namespace scarp {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

std::filesystem::path made(std::filesystem::path folder) {
  make_output_folder(folder);
  return folder;
}

/// Takes away what an earlier run has left: it would pass for this one's.
std::filesystem::path cleared(std::filesystem::path folder) {
  folder = made(std::move(folder));
  remove_outputs(folder);
  return folder;
}

/// From what was read, not from the file, which may have changed since. A scene that is itself in
/// the folder stays as it is.
void keep_scene(const Scene& scene, const std::filesystem::path& folder) {
  std::error_code ignored;
  const std::filesystem::path copy = folder / "scene.toml";
  if (scene.text.empty() || std::filesystem::equivalent(scene.file, copy, ignored)) return;
  replace_file(copy, scene.text);
}

/// The first multiple of `interval` after `time`.
double next_multiple(double time, double interval) {
  return interval == never ? never : (std::floor(time / interval * (1.0 + 1e-12)) + 1.0) * interval;
}

/// Steps that cost at least ten times as much as a row, which takes a force sweep of part of the
/// soil for each wall (`wall_reactions`); a step costs about three sweeps.
std::uint64_t steps_worth_ten_rows(const Scene& scene) { return 4 * (1 + scene.walls.size()); }

/// Adds the wall time of its life to a sum.
class Stopwatch {
 public:
  explicit Stopwatch(double& sum) : sum_(sum) {}
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;
  ~Stopwatch() {
    sum_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - began_).count();
  }

 private:
  double& sum_;
  std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
};

template <class Kind>
const Kind* as(const std::exception_ptr& thrown) {
  try {
    std::rethrow_exception(thrown);
  } catch (const Kind& kind) {
    return &kind;  // lives as long as `thrown`
  } catch (...) {
    return nullptr;
  }
}

std::string case_name(const Scene& scene, const std::filesystem::path& folder) {
  const std::filesystem::path named =
      scene.file.empty() ? folder : std::filesystem::path(scene.file);
  return named.stem().string();
}

}  // namespace

RunWriter::RunWriter(const Simulation& simulation, std::filesystem::path folder)
    : folder_(cleared(std::move(folder))), histories_(simulation, folder_) {
  keep_scene(simulation.scene(), folder_);
  if (simulation.scene().output.frames) frames_.emplace(simulation, folder_ / "frames");
  enter_stage(simulation);
  write_frame(simulation, "start");
  write_row(simulation);
}

RunWriter::RunWriter(const Simulation& simulation, std::filesystem::path folder,
                     const Snapshot& progress, OldTables tables)
    : folder_(made(std::move(folder))),
      histories_(simulation, folder_, progress, tables),
      results_(results_in(progress)) {
  keep_scene(simulation.scene(), folder_);
  remove_page(folder_);
  remove_file(folder_ / "results.json");
  if (simulation.scene().output.frames) frames_.emplace(simulation, folder_ / "frames", progress);
  enter_stage(simulation);
  const std::vector<double>& due = progress.numbers("outputs/next_frame_and_row", 2);
  next_frame_ = due[0];
  next_row_ = due[1];
  if (std::isnan(next_frame_) || std::isnan(next_row_))
    throw CheckpointError("'outputs/next_frame_and_row' holds no times.");
  const auto step_of = [&progress](const char* item) -> std::optional<std::uint64_t> {
    const std::int64_t step = progress.integers(item, 1).front();
    if (step < 0) return {};
    return static_cast<std::uint64_t>(step);
  };
  frame_step_ = step_of("outputs/frame_step");
  row_step_ = step_of("outputs/row_step");
  seconds_before_ = finite_numbers(progress, "outputs/wall_seconds", 1).front();
}

void RunWriter::add_progress(Snapshot& snapshot) {
  histories_.add_progress(snapshot);
  if (frames_) frames_->add_progress(snapshot);
  snapshot.add("outputs/next_frame_and_row", "s", {next_frame_, next_row_});
  const auto add_step = [&snapshot](const char* item, const std::optional<std::uint64_t>& step) {
    snapshot.add(item, std::vector<std::int64_t>{step ? static_cast<std::int64_t>(*step) : -1});
  };
  add_step("outputs/frame_step", frame_step_);
  add_step("outputs/row_step", row_step_);
  snapshot.add("outputs/wall_seconds", "s", {seconds_so_far()});
  add_results(snapshot, results_);
}

void RunWriter::enter_stage(const Simulation& simulation) {
  const Scene& scene = simulation.scene();
  stage_ = simulation.stage_index();
  frame_interval_ = scene.output.frame_interval.value_or(never);
  row_interval_ = scene.output.probe_interval.value_or(never);
  steps_between_rows_ = 1;
  if (!scene.output.probe_interval) {
    steps_between_rows_ = steps_worth_ten_rows(scene);
    if (stage_ < scene.stages.size())
      row_interval_ = scene.stages[stage_].duration.value_or(never) / 100.0;
  }
  const double time = simulation.last_step().stage_time;
  next_frame_ = next_multiple(time, frame_interval_);
  next_row_ = next_multiple(time, row_interval_);
}

void RunWriter::after_step(const Simulation& simulation) {
  const double time = simulation.last_step().stage_time;
  const bool entered = simulation.stage_index() != stage_;
  if (entered) enter_stage(simulation);
  const bool ended = simulation.stage_ended();
  if (entered || ended || time >= next_frame_) {
    write_frame(simulation, ended ? "stage_end" : entered ? "stage_start" : "interval");
    next_frame_ = next_multiple(time, frame_interval_);
  }
  const bool paid = !row_step_ || simulation.last_step().step >= *row_step_ + steps_between_rows_;
  if (entered || ended || (time >= next_row_ && paid)) {
    write_row(simulation);
    next_row_ = next_multiple(time, row_interval_);
  }
  if (ended && stage_ < simulation.scene().stages.size()) {
    results_.stages.push_back({simulation.scene().stages[stage_].name, simulation.last_step().time,
                               simulation.last_step().step, simulation.stage_reached_rest()});
  }
}

void RunWriter::finish(const Simulation& simulation, double wall_seconds,
                       const std::string& failure) {
  write_frame(simulation, failure.empty() ? "last" : "stopped");
  if (frames_) frames_->write_lists();
  write_row(simulation);
  results_.failure = failure;
  take_measures(simulation);
  write_results(simulation, wall_seconds);
}

void RunWriter::take_measures(const Simulation& simulation) {
  if (!has_own_measures_) results_.measures = basic_measures(simulation);
}

void RunWriter::write_results(const Simulation& simulation, double wall_seconds) {
  const LostSoil& lost = simulation.lost_soil();
  results_.case_name = case_name(simulation.scene(), folder_);
  results_.wall_seconds = seconds_before_ + wall_seconds;
  if (results_.failure.empty() && lost.particles > 0)
    results_.failure = lost.message(simulation.soil_count());
  results_.outputs = {{"write_frames", frame_seconds_},
                      {"write_rows", row_seconds_},
                      {"write_checkpoints", checkpoint_seconds_}};
  scarp::write_results(folder_ / "results.json", simulation, results_);
}

void RunWriter::go_back(const Simulation& simulation, const Snapshot& progress, Retry retry) {
  RunWriter back(simulation, folder_, progress);
  back.results_.retries = std::move(results_.retries);
  back.results_.retries.push_back(std::move(retry));
  back.results_.measures = std::move(results_.measures);
  back.has_own_measures_ = has_own_measures_;
  back.seconds_before_ = seconds_so_far();
  back.frame_seconds_ += frame_seconds_;
  back.row_seconds_ += row_seconds_;
  back.checkpoint_seconds_ += checkpoint_seconds_;
  *this = std::move(back);
}

double RunWriter::seconds_so_far() const {
  return seconds_before_ +
         std::chrono::duration<double>(std::chrono::steady_clock::now() - began_).count();
}

std::string RunWriter::end_early(const Simulation& simulation, double wall_seconds,
                                 const std::exception_ptr& why) noexcept {
  std::string missing;
  // Each for itself: on a full disk or without memory some of it still goes through.
  const auto attempt = [&missing](const char* part, const auto& write) {
    try {
      write();
    } catch (...) {
      if (missing.empty())
        missing = fmt::format("The {} could not be written: {}", part,
                              reason_of(std::current_exception()));
    }
  };
  try {
    const std::string reason = reason_of(why);
    if (const auto* unstable = as<SimulationInstability>(why))
      results_.instability = unstable->what_happened();
    if (as<FileError>(why) ==
        nullptr) {  // a full disk takes no more, and the state is not to blame
      attempt("last frame", [&] { write_frame(simulation, "stopped"); });
      attempt("last row", [&] { write_row(simulation); });
    }
    results_.failure = reason;
    attempt("measures", [&] { take_measures(simulation); });
    attempt("results", [&] { write_results(simulation, wall_seconds); });
  } catch (...) {  // without memory even for the words
  }
  return missing;
}

void RunWriter::write_frame(const Simulation& simulation, std::string_view event) {
  const std::uint64_t step = simulation.last_step().step;
  if (!frames_ || frame_step_ == step) return;
  const Stopwatch stopwatch(frame_seconds_);
  frames_->write(simulation, event);
  frame_step_ = step;
}

void RunWriter::write_row(const Simulation& simulation) {
  const std::uint64_t step = simulation.last_step().step;
  if (row_step_ == step) return;
  const Stopwatch stopwatch(row_seconds_);
  histories_.write(simulation);
  row_step_ = step;
}

}  // namespace scarp
