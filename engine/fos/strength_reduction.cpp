// SPDX-License-Identifier: BSD-3-Clause
/// Trials of one strength each, stopped as soon as their outcome is certain.

#include "engine/fos/strength_reduction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <deque>

#include "engine/errors.hpp"
#include "engine/fos/displacement.hpp"
#include "engine/run/run.hpp"

namespace scarp {
namespace {

using Clock = std::chrono::steady_clock;

/// A step is short against everything here; gathering all displacements is not free.
constexpr std::uint64_t sample_steps = 10;

/// Steps of equal ratio in which the strength is cut; each sets free a hundredth of the energy that
/// the whole cut at once would.
constexpr int ramp_steps = 10;

/// A slope stands if this many times its present rate could not bring it to the limit in time.
constexpr double rate_margin = 3.0;

/// Displacement of the fastest-moving soil over a trailing span of time.
class Rate {
 public:
  explicit Rate(double span) : span_(span) {}
  void sample(double time, double displacement) {
    samples_.push_back({time, displacement});
    while (samples_.size() > 1 && samples_[1].time <= time - span_) samples_.pop_front();
  }
  /// [m/s], of the largest rise within the span; empty before a whole span has gone by.
  std::optional<double> value() const {
    const Sample &first = samples_.front(), &last = samples_.back();
    if (last.time - first.time < 0.999 * span_) return {};
    const auto [low, high] = std::minmax_element(
        samples_.begin(), samples_.end(),
        [](const Sample& a, const Sample& b) { return a.displacement < b.displacement; });
    return (high->displacement - low->displacement) / (last.time - first.time);
  }

 private:
  struct Sample {
    double time, displacement;
  };
  double span_;
  std::deque<Sample> samples_;
};

[[noreturn]] void refuse_failing(const StrengthReduction& slope, const Trial& trial) {
  throw SceneError(fmt::format(
      "{}: the slope fails with the strength it settled with: {:.3g} m of displacement within "
      "{:.3g} s, more than 1 % of its height of {:.4g} m{}. Try strength_reduction below 1 (0.5 "
      "doubles the strength) in the stages before the last, or let them settle for longer.",
      slope.settled().scene().file, trial.displacement, trial.time, slope.criterion().height,
      slope.settled().stage_reached_rest() ? "" : ", and it had not come to rest before"));
}

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

Simulation StrengthReduction::reduced(double reduction, double duration) const {
  return with_strength(
      [reduction](const Stage& last) {
        StageStrength strength{last.strength_reduction, last.material_strength_reduction};
        if (strength.materials.empty()) strength.all = reduction;
        for (auto& [material, factor] : strength.materials) factor = reduction;
        return strength;
      }(settled_.scene().stages.back()),
      duration);
}

Simulation StrengthReduction::with_strength(const StageStrength& end, double duration) const {
  const Stage& before = settled_.scene().stages[settled_.stage_index()];
  Stage hold = settled_.scene().stages.back();
  hold.until = StageEnd::duration;
  hold.duration = duration;
  hold.reset_after = false;
  hold.strength_reduction = end.all;
  hold.material_strength_reduction = end.materials;
  std::vector<Stage> stages;
  for (int k = 1; k < ramp_steps && criterion_.ramp > 0.0; ++k) {
    const double part = static_cast<double>(k) / ramp_steps;
    const auto between = [part](double from, double to) {
      return from * std::pow(to / from, part);
    };
    Stage step = hold;
    step.name = fmt::format("{:.50}~{}", hold.name, k);
    step.duration = criterion_.ramp / (ramp_steps - 1);
    step.strength_reduction = between(before.strength_reduction, end.all);
    for (const auto& [material, factor] : end.materials) {
      const auto own = before.material_strength_reduction.find(material);
      const double from =
          own != before.material_strength_reduction.end() ? own->second : before.strength_reduction;
      step.material_strength_reduction[material] = between(from, factor);
    }
    stages.push_back(step);
  }
  stages.push_back(hold);
  Simulation simulation = settled_.clone();
  simulation.set_following_stages(stages);
  return simulation;
}

std::optional<Trial> StrengthReduction::run(Simulation simulation, double reduction,
                                            const Proceed& proceed) const {
  const auto start = Clock::now();
  const std::uint64_t first_step = simulation.last_step().step;
  const double start_time = simulation.last_step().time;
  const double limit = criterion_.elastic + criterion_.limit;
  Trial trial;
  trial.reduction = reduction;
  Rate rate(criterion_.span);
  rate.sample(0.0, 0.0);
  bool over = false, goes_on = true;
  const auto judge = [&](const Simulation& now) {
    const double time = now.last_step().time - start_time;
    trial.steps = now.last_step().step - first_step;
    const bool sampled = trial.steps % sample_steps == 0 || now.finished();
    if (sampled || !criterion_.probe.empty()) {
      trial.displacement = std::max(trial.displacement, displacement(now));
    }
    if (sampled) rate.sample(time, largest_displacement(now));
    const std::optional<double> moving = sampled ? rate.value() : std::nullopt;
    const double left = criterion_.ramp + criterion_.window - time;
    if (trial.displacement > limit) {
      trial.fails = over = true;
      trial.end = TrialEnd::limit_crossed;
    } else if (now.finished()) {
      over = true;
      trial.end = TrialEnd::window_over;
    } else if (criterion_.early_stop && moving && left < criterion_.window - criterion_.span &&
               trial.displacement + rate_margin * *moving * left < limit) {
      over = true;
      trial.end = TrialEnd::came_to_rest;
    }
    goes_on = !proceed || proceed(now);
    return goes_on;
  };
  scarp::run(simulation,
             {.until = [&over](const Simulation&) { return over; }, .after_step = judge});
  if (!goes_on) return {};
  trial.time = simulation.last_step().time - start_time;
  trial.speed = speed(simulation);
  trial.wall_s = std::chrono::duration<double>(Clock::now() - start).count();
  return trial;
}

std::optional<Trial> StrengthReduction::measure_elastic(const Proceed& proceed) {
  const Stage& before = settled_.scene().stages[settled_.stage_index()];
  Simulation simulation = with_strength(
      {before.strength_reduction, before.material_strength_reduction}, criterion_.window);
  const std::optional<double> own = settled_reduction(settled_.scene());
  std::optional<Trial> trial = run(std::move(simulation), own.value_or(1.0), proceed);
  if (!trial || trial->fails) return trial;
  take_elastic(*trial);
  return trial;
}

void StrengthReduction::take_elastic(const Trial& trial) {
  criterion_.elastic = trial.displacement;
  elastic_ = trial;
}

std::optional<Trial> StrengthReduction::respond(double reduction, const Proceed& proceed) const {
  const bool same = elastic_ && settled_reduction(settled_.scene()) == reduction &&
                    settled_.scene().stages.back().material_strength_reduction.empty();
  if (same) {  // has been run already
    Trial trial = *elastic_;
    trial.steps = 0;
    trial.wall_s = 0.0;
    return trial;
  }
  return run(reduced(reduction, criterion_.window), reduction, proceed);
}

FactorOfSafety find_factor(StrengthReduction& slope, const SearchOptions& search,
                           const Proceed& proceed,
                           const std::function<void(const FactorOfSafety&, const Trial&)>& done,
                           const std::vector<Trial>& known) {
  FactorOfSafety found;
  const std::optional<Trial> elastic =
      slope.elastic() ? slope.elastic() : slope.measure_elastic(proceed);
  if (!elastic) return found;
  if (elastic->fails) refuse_failing(slope, *elastic);
  found.elastic = *elastic;
  if (done) done(found, *elastic);
  found.bracket = find_limit(search, [&](double reduction) -> std::optional<bool> {
    const auto before = std::find_if(known.begin(), known.end(), [reduction](const Trial& trial) {
      return trial.reduction == reduction;
    });
    const std::optional<Trial> trial =
        before != known.end() ? *before : slope.respond(reduction, proceed);
    if (!trial) return {};
    found.trials.push_back(*trial);
    std::optional<double>& end = trial->fails ? found.bracket.fails : found.bracket.stands;
    end = reduction;  // so that an error later leaves what is known
    if (done) done(found, *trial);
    return trial->fails;
  });
  return found;
}

}  // namespace scarp
