// SPDX-License-Identifier: BSD-3-Clause
/// The search over trials of one slope.

#include <fmt/format.h>

#include "engine/errors.hpp"
#include "engine/fos/displacement.hpp"
#include "engine/fos/side_by_side.hpp"
#include "engine/fos/strength_reduction.hpp"

namespace scarp {
namespace {

[[noreturn]] void refuse_failing(const StrengthReduction& slope, const Trial& trial) {
  throw SceneError(fmt::format(
      "{}: the slope fails with the strength it settled with: {:.3g} m of displacement within "
      "{:.3g} s, more than 1 % of its height of {:.4g} m{}. Try strength_reduction below 1 (0.5 "
      "doubles the strength) in the stages before the last, or let them settle for longer.",
      slope.settled().scene().file, trial.displacement, trial.time, slope.criterion().height,
      slope.settled().stage_reached_rest() ? "" : ", and it had not come to rest before"));
}

/// A mass that a load e above the limit drives gains speed^2 = 2 e g' u over a way u, with g' the
/// gravity along its slip times what the slip takes of it: a quarter of g, 0.22 to 0.29 on the
/// slopes of `slope_2d` and `slopes_fos`.
constexpr double driving_share = 0.25;

/// A slope that crosses the limit within the time of one level of the cut did not get its speed
/// from the strength that was reached: it tells nothing.
Outcome outcome_of(const StrengthReduction& slope, const Trial& trial) {
  Outcome outcome{trial.reduction, trial.fails};
  if (trial.end != TrialEnd::limit_crossed) return outcome;
  if (trial.time - slope.cut_time(trial.reduction) < slope.level_time()) return outcome;
  const double gravity = size_of(slope.settled().scene().gravity);
  outcome.excess = trial.speed * trial.speed / (2.0 * driving_share * gravity * trial.displacement);
  return outcome;
}

}  // namespace

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
  std::vector<Outcome> outcomes;
  const auto take = [&](const Trial& trial) {
    outcomes.push_back(outcome_of(slope, trial));
    found.trials.push_back(trial);
    found.bracket = bracket_of(search, outcomes);  // so that an error later leaves what is known
    if (done) done(found, trial);
  };
  for (const Trial& trial : known) take(trial);
  SideBySide trials(slope);
  find_limit(
      search,
      [&](double reduction) -> std::optional<Outcome> {
        const std::optional<Trial> trial =
            trials.respond(reduction, likely_next(search, outcomes, reduction), proceed);
        if (!trial) return {};
        take(*trial);
        return outcomes.back();
      },
      outcomes);
  return found;
}

}  // namespace scarp
