// SPDX-License-Identifier: BSD-3-Clause
/// Trials of one strength each, stopped as soon as their outcome is certain.

#include "engine/fos/strength_reduction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "engine/fos/displacement.hpp"
#include "engine/fos/rate.hpp"
#include "engine/run/run.hpp"

namespace scarp {
namespace {

using Clock = std::chrono::steady_clock;

/// A step is short against everything here; gathering all displacements is not free.
constexpr std::uint64_t sample_steps = 10;

/// A slope stands if this many times the way that it still has to go does not bring it to the
/// limit.
constexpr double way_margin = 3.0;

}  // namespace

bool settle(Simulation& simulation, const Proceed& proceed) {
  const std::size_t last = simulation.scene().stages.size() - 2;
  const auto settled = [last](const Simulation& now) {
    return now.stage_index() >= last && now.stage_ended();
  };
  run(simulation, {.until = settled, .after_step = proceed});
  return settled(simulation);
}

StrengthReduction::StrengthReduction(Simulation settled, const Criterion& criterion)
    : settled_(std::move(settled)), criterion_(criterion), position_(settled_.field("position")) {}

double StrengthReduction::largest_displacement(const Simulation& simulation,
                                               std::size_t* where) const {
  return farthest(position_, simulation, where);
}

double StrengthReduction::displacement(const Simulation& simulation) const {
  if (criterion_.probe.empty()) return largest_displacement(simulation);
  const Vec3 now = simulation.probe(criterion_.probe).position;
  const Vec3 before = settled_.probe(criterion_.probe).position;
  return size_of({now[0] - before[0], now[1] - before[1], now[2] - before[2]});
}

double StrengthReduction::speed(const Simulation& simulation) const {
  if (!criterion_.probe.empty()) return size_of(simulation.probe(criterion_.probe).velocity);
  std::size_t i = 0;
  largest_displacement(simulation, &i);
  const std::vector<double> velocity = simulation.field("velocity");
  return std::hypot(velocity[i], velocity[i + 1], velocity[i + 2]);
}

StageStrength StrengthReduction::strength_before() const {
  return strength_of(settled_.scene().stages[settled_.stage_index()]);
}

StageStrength StrengthReduction::strength_after(double reduction) const {
  StageStrength strength = strength_of(settled_.scene().stages.back());
  if (strength.materials.empty()) strength.all = reduction;
  for (auto& [material, factor] : strength.materials) factor = reduction;
  return strength;
}

double StrengthReduction::level_time() const { return criterion_.ramp / (cut_unit_steps - 1); }

double StrengthReduction::cut_time(double reduction) const {
  const auto levels = cut_levels(strength_before(), strength_after(reduction)).size();
  return static_cast<double>(levels) * level_time();
}

/// What the cut by `wanted` has come to in this stage. Up to here a trial of that factor is the
/// same.
double StrengthReduction::reduction_reached(const Stage& stage, double wanted) const {
  const StageStrength now = strength_of(stage);
  const double reached = now.materials.empty() ? now.all : now.materials.begin()->second;
  return now == strength_after(reached) ? reached : wanted;
}

/// The levels of the cut, then what is held.
std::vector<Stage> StrengthReduction::stages_to(const StageStrength& end, double duration) const {
  Stage hold = settled_.scene().stages.back();
  hold.until = StageEnd::duration;
  hold.duration = duration;
  hold.reset_after = false;
  set_strength(hold, end);
  std::vector<Stage> stages;
  if (criterion_.ramp > 0.0) {
    for (const StageStrength& level : cut_levels(strength_before(), end)) {
      Stage step = hold;
      step.name = fmt::format("{:.50}~{}", hold.name, stages.size() + 1);
      step.duration = level_time();
      set_strength(step, level);
      stages.push_back(step);
    }
  }
  stages.push_back(hold);
  return stages;
}

Simulation StrengthReduction::reduced(double reduction, double duration) const {
  Simulation simulation = settled_.clone();
  simulation.set_following_stages(stages_to(strength_after(reduction), duration));
  return simulation;
}

std::vector<StageStrength> StrengthReduction::way_to(const Simulation& now) const {
  std::vector<StageStrength> way;
  for (std::size_t s = settled_.stage_index() + 1; s <= now.stage_index(); ++s)
    way.push_back(strength_of(now.scene().stages[s]));
  return way;
}

/// A copy of the state from which a cut by these stages has to go on, with the stages that are
/// left.
CutState StrengthReduction::begin(const std::vector<Stage>& stages,
                                  const RunOptions& options) const {
  const CutState* kept = levels_.deepest(stages);
  CutState begun = kept == nullptr
                       ? CutState{{}, settled_.clone(options)}
                       : CutState{kept->way, kept->state.clone(options), kept->displacement};
  begun.state.set_following_stages(
      {stages.begin() + static_cast<std::ptrdiff_t>(begun.way.size()), stages.end()});
  return begun;
}

BegunTrial StrengthReduction::begin(const StageStrength& end, double reduction,
                                    const RunOptions& options) const {
  return {end, reduction, begin(stages_to(end, criterion_.window), options)};
}

BegunTrial StrengthReduction::begin(double reduction, const RunOptions& options) const {
  return begin(strength_after(reduction), reduction, options);
}

std::optional<Simulation> StrengthReduction::before_last_cut(double reduction, double duration,
                                                             const Proceed& proceed) {
  Simulation simulation =
      begin(stages_to(strength_after(reduction), duration), settled_.options()).state;
  const std::size_t last = simulation.scene().stages.size() - 2;
  const auto there = [last](const Simulation& now) {
    return now.stage_index() == last && now.stage_ended();
  };
  if (!there(simulation)) scarp::run(simulation, {.until = there, .after_step = proceed});
  if (!there(simulation)) return {};
  return simulation;
}

std::optional<TrialResponse> StrengthReduction::run(BegunTrial begun,
                                                    const Proceed& proceed) const {
  const auto start = Clock::now();
  Simulation& simulation = begun.from.state;
  TrialResponse response;
  Trial& trial = response.trial;
  trial.reduction = begun.reduction;
  trial.displacement = begun.from.displacement;
  const std::size_t held = simulation.scene().stages.size() - 1;
  const std::uint64_t first_step = simulation.last_step().step,
                      settled_step = settled_.last_step().step;
  const double limit = criterion_.elastic + criterion_.limit;
  Rate rate(criterion_.span);
  bool over = false, goes_on = true;
  const auto keep = [&](const Simulation& now) {
    if (response.levels.size() >= most_cut_states(now))
      response.levels.erase(response.levels.begin());
    response.levels.push_back({way_to(now), now.clone(), trial.displacement});
  };
  const auto judge = [&](const Simulation& now) {
    const bool holds = now.stage_index() == held;
    const bool sampled =
        (now.last_step().step - settled_step) % sample_steps == 0 || now.stage_ended();
    if (sampled || !criterion_.probe.empty())
      trial.displacement = std::max(trial.displacement, displacement(now));
    std::optional<double> to_go;
    if (holds && sampled) {
      rate.sample(now.last_step().stage_time, largest_displacement(now));
      to_go = rate.still_to_go(criterion_.window - now.last_step().stage_time);
    }
    if (trial.displacement > limit) {
      trial.fails = over = true;
      trial.end = TrialEnd::limit_crossed;
      trial.reduction = reduction_reached(now.scene().stages[now.stage_index()], begun.reduction);
    } else if (now.finished()) {
      over = true;
      trial.end = TrialEnd::window_over;
    } else if (criterion_.early_stop && to_go && trial.displacement + way_margin * *to_go < limit) {
      over = true;
      trial.end = TrialEnd::came_to_rest;
    } else if (!holds && now.stage_ended()) {
      keep(now);
    }
    goes_on = !proceed || proceed(now);
    return goes_on;
  };
  scarp::run(simulation,
             {.until = [&over](const Simulation&) { return over; }, .after_step = judge});
  if (!goes_on) return {};
  trial.time = simulation.last_step().time - settled_.last_step().time;
  trial.steps = simulation.last_step().step - first_step;
  trial.speed = speed(simulation);
  trial.wall_s = std::chrono::duration<double>(Clock::now() - start).count();
  return response;
}

std::optional<Trial> StrengthReduction::measure_elastic(const Proceed& proceed) {
  const std::optional<double> own = settled_reduction(settled_.scene());
  std::optional<TrialResponse> response =
      run(begin(strength_before(), own.value_or(1.0), settled_.options()), proceed);
  if (!response) return {};
  if (!response->trial.fails) take_elastic(response->trial);
  return response->trial;
}

void StrengthReduction::take_elastic(const Trial& trial) {
  criterion_.elastic = trial.displacement;
  elastic_ = trial;
}

bool StrengthReduction::is_elastic(double reduction) const {
  return elastic_ && settled_reduction(settled_.scene()) == reduction &&
         settled_.scene().stages.back().material_strength_reduction.empty();
}

Trial StrengthReduction::take(TrialResponse response) {
  levels_.keep(std::move(response.levels));
  const Trial& trial = response.trial;
  levels_.forget(stages_to(strength_after(trial.reduction), criterion_.window), trial.fails);
  return trial;
}

std::optional<Trial> StrengthReduction::respond(double reduction, const Proceed& proceed) {
  if (is_elastic(reduction)) {  // has been run already
    Trial trial = *elastic_;
    trial.steps = 0;
    trial.wall_s = 0.0;
    return trial;
  }
  std::optional<TrialResponse> response = run(begin(reduction, settled_.options()), proceed);
  if (!response) return {};
  return take(std::move(*response));
}

}  // namespace scarp
