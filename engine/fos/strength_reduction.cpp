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

/// Levels of a cut are kept as long as they take no more memory [bytes]; one always.
constexpr std::size_t memory_of_levels = std::size_t{1} << 30;

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

/// The longest way kept with which a cut by these stages begins; null: there is none.
const StrengthReduction::Level* StrengthReduction::deepest_level(
    const std::vector<Stage>& stages) const {
  const Level* deepest = nullptr;
  for (const Level& level : levels_) {
    const bool begins = level.way.size() < stages.size() &&
                        std::equal(level.way.begin(), level.way.end(), stages.begin(),
                                   [](const StageStrength& strength, const Stage& stage) {
                                     return strength == strength_of(stage);
                                   });
    if (begins && (deepest == nullptr || level.way.size() > deepest->way.size())) deepest = &level;
  }
  return deepest;
}

void StrengthReduction::keep_level(const Simulation& now, double displacement) {
  std::vector<StageStrength> way;
  for (std::size_t s = settled_.stage_index() + 1; s <= now.stage_index(); ++s)
    way.push_back(strength_of(now.scene().stages[s]));
  const auto kept = [&way](const Level& level) { return level.way == way; };
  if (std::any_of(levels_.begin(), levels_.end(), kept)) return;
  const std::size_t most = std::max<std::size_t>(1, memory_of_levels / now.memory_bytes());
  if (levels_.size() >= most) levels_.erase(levels_.begin());
  levels_.push_back({std::move(way), now.clone(), displacement});
}

/// Away with levels that no trial will begin from after this one: those beyond a factor that fails,
/// those before the last on the way to one that stands.
void StrengthReduction::forget_levels(const Trial& trial) {
  const std::vector<Stage> stages = stages_to(strength_after(trial.reduction), 1.0);
  const auto shared = [&stages](const Level& level) {
    return level.way.size() < stages.size() &&
           level.way.back() == strength_of(stages[level.way.size() - 1]);
  };
  const Level* last = trial.fails ? nullptr : deepest_level(stages);
  const std::size_t length = last == nullptr ? 0 : last->way.size();
  std::erase_if(levels_, [&](const Level& level) {
    return trial.fails ? !shared(level) : shared(level) && level.way.size() < length;
  });
}

/// A copy of the state from which a cut by these stages has to go on, with the stages that are
/// left.
StrengthReduction::Begun StrengthReduction::begin(const std::vector<Stage>& stages) const {
  const Level* level = deepest_level(stages);
  const std::size_t done = level == nullptr ? 0 : level->way.size();
  Begun begun{level == nullptr ? settled_.clone() : level->state.clone(),
              level == nullptr ? 0.0 : level->displacement};
  begun.state.set_following_stages(
      {stages.begin() + static_cast<std::ptrdiff_t>(done), stages.end()});
  return begun;
}

std::optional<Simulation> StrengthReduction::before_last_cut(double reduction, double duration,
                                                             const Proceed& proceed) {
  Simulation simulation = begin(stages_to(strength_after(reduction), duration)).state;
  const std::size_t last = simulation.scene().stages.size() - 2;
  const auto there = [last](const Simulation& now) {
    return now.stage_index() == last && now.stage_ended();
  };
  if (!there(simulation)) scarp::run(simulation, {.until = there, .after_step = proceed});
  if (!there(simulation)) return {};
  return simulation;
}

std::optional<Trial> StrengthReduction::run(const StageStrength& end, double reduction,
                                            const Proceed& proceed) {
  const auto start = Clock::now();
  Begun begun = begin(stages_to(end, criterion_.window));
  Simulation& simulation = begun.state;
  Trial trial;
  trial.reduction = reduction;
  trial.displacement = begun.displacement;
  const std::size_t held = simulation.scene().stages.size() - 1;
  const std::uint64_t first_step = simulation.last_step().step,
                      settled_step = settled_.last_step().step;
  const double limit = criterion_.elastic + criterion_.limit;
  Rate rate(criterion_.span);
  bool over = false, goes_on = true;
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
      trial.reduction = reduction_reached(now.scene().stages[now.stage_index()], reduction);
    } else if (now.finished()) {
      over = true;
      trial.end = TrialEnd::window_over;
    } else if (criterion_.early_stop && to_go && trial.displacement + way_margin * *to_go < limit) {
      over = true;
      trial.end = TrialEnd::came_to_rest;
    } else if (!holds && now.stage_ended()) {
      keep_level(now, trial.displacement);
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
  return trial;
}

std::optional<Trial> StrengthReduction::measure_elastic(const Proceed& proceed) {
  const std::optional<double> own = settled_reduction(settled_.scene());
  std::optional<Trial> trial = run(strength_before(), own.value_or(1.0), proceed);
  if (!trial || trial->fails) return trial;
  take_elastic(*trial);
  return trial;
}

void StrengthReduction::take_elastic(const Trial& trial) {
  criterion_.elastic = trial.displacement;
  elastic_ = trial;
}

std::optional<Trial> StrengthReduction::respond(double reduction, const Proceed& proceed) {
  const bool same = elastic_ && settled_reduction(settled_.scene()) == reduction &&
                    settled_.scene().stages.back().material_strength_reduction.empty();
  if (same) {  // has been run already
    Trial trial = *elastic_;
    trial.steps = 0;
    trial.wall_s = 0.0;
    return trial;
  }
  std::optional<Trial> trial = run(strength_after(reduction), reduction, proceed);
  if (trial) forget_levels(*trial);
  return trial;
}

}  // namespace scarp
