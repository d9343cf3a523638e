// SPDX-License-Identifier: BSD-3-Clause
/// The schedule: a first run of everything, neighbours of the front, then the repeats.

#include "validation/error_time/study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <set>

#include "engine/errors.hpp"
#include "engine/plain_text.hpp"
#include "engine/scene/smoothing_choice.hpp"
#include "validation/error_time/forecast.hpp"

namespace scarp::validation {
namespace {

using Clock = std::chrono::steady_clock;

double since_s(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

std::string read_text(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Of the shortest runs.
int most_repeats(int usual) { return 3 * usual; }

class Runner {
 public:
  Runner(const CaseRow& row, const StudyOptions& options)
      : row_(row),
        options_(options),
        problem_(*row.problem),
        plan_{options.axes, options.short_form, problem_.against_finest},
        spacings_(problem_.spacings.begin(), problem_.spacings.end()),
        cases_(std::string(row.name), case_options(options)),
        log_(cases_.folder() / "runs.jsonl"),
        forecast_(spacings_, 2) {
    for (const std::string& preset : cases_.presets()) {
      const Scene scene = cases_.scene_at(spacings_.front(), preset);
      presets_[preset] = filled_in(scene);
      if (scene.numerics.lattice_normalisation) continue;
      moments_[preset] = Simulation(scene, options.run).lattice_moment();
    }
    const Scene coarsest = cases_.scene_at(spacings_.front(), "modern");
    const Simulation probe(coarsest, options.run);
    bench_ = {program_version(), probe.isa(), processor_name(), probe.threads(),
              hash_of(read_text("/proc/self/exe"))};
    scene_text_ = read_text(coarsest.file);
    title_ = coarsest.title;
    forecast_ = Forecast(spacings_, coarsest.dimension);
  }

  ErrorStudy run() {
    trials_ = first_round(presets_, plan_);
    pass(0, trials_);
    for (int round = 0; round < (options_.short_form ? 0 : 2); ++round) {
      const std::vector<Trial> next = neighbour_round(tried(), plan_);
      if (next.empty()) break;
      trials_.insert(trials_.end(), next.begin(), next.end());
      pass(0, next);
    }
    for (int repeat = 1; repeat < most_repeats(options_.repeats); ++repeat) pass(repeat, trials_);
    return summary();
  }

 private:
  static CaseOptions case_options(const StudyOptions& options) {
    CaseOptions of_case;
    of_case.out = options.out;
    of_case.run = options.run;
    of_case.quiet = options.quiet;
    of_case.names_runs = false;  // `announce` does
    of_case.stop_when_supersonic = true;
    return of_case;
  }

  std::string key(const Trial& trial, int repeat) const {
    return run_key(bench_, std::string(row_.name), scene_text_, spacings_[trial.level],
                   numerics_of(trial.setting, presets_.at(trial.setting.preset)), repeat);
  }

  /// Whether a setting is run this often; unstable ones are not run again.
  bool wanted(const Trial& trial, int repeat) const {
    if (repeat == 0) return true;
    const RunRecord* first = log_.find(key(trial, 0));
    return first != nullptr && first->status == RunStatus::ok &&
           repeat < repeats_for(first->wall_s, options_.repeats);
  }

  bool is_reference(const Trial& trial) const { return trial == reference_trial(plan_); }

  void pass(int repeat, const std::vector<Trial>& trials) {
    for (std::size_t k = 0; k < trials.size(); ++k) {
      const Trial& trial = trials[k];
      if (!wanted(trial, repeat)) continue;
      const RunRecord* record = log_.find(key(trial, repeat));
      if (record == nullptr) {
        const double expected = forecast_.of(trial).value_or(0.0);
        // Without the reference nothing has an error, so it is run whatever it costs.
        const bool in_time = !options_.budget_s || since_s(start_) + expected <= *options_.budget_s;
        if (!in_time && !is_reference(trial)) {
          ++left_out_;
          continue;
        }
        announce(trial, repeat, k + 1, trials);
        log_.append(execute(trial, repeat, part_of(repeat, k + 1, trials)));
        record = log_.find(key(trial, repeat));
        tell(*record);
      }
      if (record->status == RunStatus::ok) forecast_.note(trial, record->wall_s);
    }
  }

  /// What is expected of the runs from the `next` one on, where it is known of all of them.
  cli::WholeWork part_of(int repeat, std::size_t next, const std::vector<Trial>& trials) const {
    cli::WholeWork whole{fmt::format("{} {} of {}", row_.name, next, trials.size())};
    if (const std::optional<double> ahead = left(repeat, next, trials))
      whole.ahead = [ahead](double) { return *ahead; };
    return whole;
  }

  RunRecord execute(const Trial& trial, int repeat, cli::WholeWork whole) {
    RunRecord record;
    record.key = key(trial, repeat);
    record.setting = name_of(trial.setting);
    record.spacing = spacings_[trial.level];
    record.repeat = repeat;
    record.outcome = std::nan("");
    CaseRun run(std::string(row_.name), cases_.options());
    run.set_whole(std::move(whole));
    try {
      Scene scene = run.scene_at(record.spacing, trial.setting.preset);
      scene.numerics = numerics_of(trial.setting, scene.numerics);
      record.outcome = problem_.outcome(run, scene);
      if (!std::isfinite(record.outcome)) {
        record.status = RunStatus::unstable;
        record.reason = "the error is not a number";
      }
    } catch (const SimulationInstability& instability) {
      record.status = RunStatus::unstable;
      record.reason = instability.what();
    } catch (const SceneError& error) {
      record.status = RunStatus::refused;
      record.reason = error.what();
    }
    for (const RunCost& cost : run.result().runs) {
      record.wall_s += cost.wall_s;
      record.cpu_s += cost.cpu_s;
      record.steps += static_cast<double>(cost.steps);
      record.particle_steps += cost.particle_steps;
      record.memory_bytes = std::max(record.memory_bytes, cost.memory_bytes);
    }
    if (record.steps > 0.0) record.particles = std::round(record.particle_steps / record.steps);
    return record;
  }

  void announce(const Trial& trial, int repeat, std::size_t number,
                const std::vector<Trial>& trials) const {
    if (options_.quiet) return;
    const auto words = [](std::optional<double> s) {
      return s ? readable_duration(*s) : std::string("unknown");
    };
    fmt::print(stderr, "{} {}/{}, run {}: {}, dx = {:g} m; expected {}, about {} left\n", row_.name,
               number, trials.size(), repeat + 1, name_of(trial.setting), spacings_[trial.level],
               words(forecast_.of(trial)), words(left(repeat, number - 1, trials)));
    std::fflush(stderr);
  }

  void tell(const RunRecord& record) const {
    if (options_.quiet) return;
    if (record.status == RunStatus::ok) {
      fmt::print(stderr, "    {} {:.5g}, {}\n", problem_.against_finest ? "value" : "error",
                 record.outcome, readable_duration(record.wall_s));
    } else {
      fmt::print(stderr, "    {}: {}\n", word(record.status), record.reason);
    }
  }

  /// Of this pass and of the repeats that are still to come; neighbours not yet known do not count.
  std::optional<double> left(int repeat, std::size_t from, const std::vector<Trial>& trials) const {
    double total = 0.0;
    const auto count = [&](const Trial& trial, int which) {
      if (log_.find(key(trial, which)) != nullptr) return true;
      const std::optional<double> expected = forecast_.of(trial);
      if (expected && which < repeats_for(*expected, options_.repeats)) {
        total += *expected;
      }
      return expected.has_value();
    };
    for (std::size_t k = from; k < trials.size(); ++k) {
      if (!count(trials[k], repeat)) return {};
    }
    for (int later = repeat + 1; later < most_repeats(options_.repeats); ++later) {
      for (const Trial& trial : trials_) count(trial, later);
    }
    return total;
  }

  /// By first runs alone, so that a later call with more repeats chooses the same neighbours.
  std::vector<TrialOutcome> tried() const {
    std::vector<TrialOutcome> outcomes;
    for (const Point& point : summary().points) {
      outcomes.push_back({point.trial, {point.error, log_.find(key(point.trial, 0))->wall_s}});
    }
    return outcomes;
  }

  ErrorStudy summary() const {
    ErrorStudy study;
    study.case_name = row_.name;
    study.title = title_;
    study.error = problem_.error;
    study.spacings = spacings_;
    study.axes = options_.axes;
    study.short_form = options_.short_form;
    study.bench = bench_;
    study.lattice_moments = moments_;
    study.left_out = left_out_;
    std::vector<std::pair<Point, std::vector<RunRecord>>> runs;
    for (const Trial& trial : trials_) {
      Point point;
      point.trial = trial;
      point.setting = name_of(trial.setting);
      point.spacing = spacings_[trial.level];
      point.numerics = numerics_of(trial.setting, presets_.at(trial.setting.preset));
      point.reference = is_reference(trial);
      std::vector<RunRecord> records;
      for (int repeat = 0; repeat < most_repeats(options_.repeats); ++repeat) {
        if (const RunRecord* record = log_.find(key(trial, repeat))) records.push_back(*record);
      }
      if (log_.find(key(trial, 0)) != nullptr)
        runs.emplace_back(std::move(point), std::move(records));
    }
    sum_up(study, runs);
    return study;
  }

  const CaseRow& row_;
  const StudyOptions& options_;
  const ErrorProblem& problem_;
  PlanOptions plan_;
  std::vector<double> spacings_;
  CaseRun cases_;
  RunLog log_;
  Forecast forecast_;
  PresetNumerics presets_;
  std::map<std::string, double> moments_;
  Bench bench_;
  std::string scene_text_, title_;
  std::vector<Trial> trials_;
  std::size_t left_out_ = 0;
  Clock::time_point start_ = Clock::now();
};

}  // namespace

int repeats_for(double wall_s, int usual) {
  return wall_s < 0.2 ? most_repeats(usual)
                      : std::min(usual, wall_s > 60.0   ? 1
                                        : wall_s > 20.0 ? 2
                                                        : usual);
}

ErrorStudy run_study(const CaseRow& row, const StudyOptions& options) {
  require_problem(row);
  return Runner(row, options).run();
}

}  // namespace scarp::validation
