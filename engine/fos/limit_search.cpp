// SPDX-License-Identifier: BSD-3-Clause
/// Bracketing, then a secant between two trials, with bisection where that does not help.

#include "engine/fos/limit_search.hpp"

#include <algorithm>
#include <cmath>

namespace scarp {
namespace {

constexpr double outward = 1.5;

/// A bracket that is aimed at is a little narrower than the tolerance, to end the search.
constexpr double aimed_share = 0.99;

/// The two factors are the ends of a bracket of the aimed width if their ratio is this.
double aimed_ratio(double tolerance) {
  const double half = 0.5 * aimed_share * tolerance;
  return (1.0 + half) / (1.0 - half);
}

double width(const Bracket& bracket) { return *bracket.fails - *bracket.stands; }

/// Whether the last three trials have not halved a bracket that was closed before them.
bool lags(const SearchOptions& options, const std::vector<Outcome>& outcomes) {
  if (outcomes.size() < 3) return false;
  const Bracket before = bracket_of(options, {outcomes.begin(), outcomes.end() - 3});
  return before.factor() && width(bracket_of(options, outcomes)) > 0.5 * width(before);
}

double step_outward(const SearchOptions& options, const Bracket& bracket) {
  if (bracket.fails) return std::max(*bracket.fails / outward, least_reduction);
  const double stands = *bracket.stands;
  const bool has_end = options.to && *options.to > stands;
  return std::min(has_end ? *options.to : outward * stands, most_reduction);
}

/// The middle of a bracket that either half of ends the search; else one end of a bracket around
/// `expected`, the upper one unless a trial has failed near it. Where the slope stands beyond what
/// was expected, twice as far beyond.
double aim(double tolerance, const Bracket& bracket, double expected) {
  constexpr double near_share = 0.7;  // of the tolerance; half would be the very end
  const double ratio = aimed_ratio(tolerance), stands = *bracket.stands, fails = *bracket.fails;
  if (fails <= stands * ratio * ratio) return *bracket.factor();
  if (fails - std::max(expected, stands) <= near_share * tolerance * fails) return fails / ratio;
  const double above = std::max(expected * (1.0 + 0.5 * tolerance), stands * ratio);
  const double beyond = stands + 2.0 * (stands - expected);
  return beyond < fails / ratio ? std::max(above, beyond) : above;
}

}  // namespace

std::optional<double> Bracket::factor() const {
  if (!stands || !fails) return {};
  return 0.5 * (*stands + *fails);
}

Bracket bracket_of(const SearchOptions& options, const std::vector<Outcome>& outcomes) {
  Bracket bracket;
  for (const Outcome& outcome : outcomes) {
    if (outcome.fails) {
      bracket.fails = std::min(bracket.fails.value_or(outcome.factor), outcome.factor);
    } else {
      bracket.stands = std::max(bracket.stands.value_or(outcome.factor), outcome.factor);
    }
  }
  bracket.complete = bracket.factor() && width(bracket) <= options.tolerance * *bracket.factor();
  return bracket;
}

std::optional<double> expected_limit(const std::vector<Outcome>& outcomes) {
  std::vector<Outcome> failed;
  for (const Outcome& outcome : outcomes) {
    if (outcome.fails && outcome.excess > 0.0) failed.push_back(outcome);
  }
  if (failed.empty()) return {};
  std::sort(failed.begin(), failed.end(),
            [](const Outcome& a, const Outcome& b) { return a.factor < b.factor; });
  const Outcome& least = failed[0];
  if (failed.size() > 1 && failed[1].excess > least.excess) {
    const double slope = (failed[1].factor - least.factor) / (failed[1].excess - least.excess);
    return least.factor - slope * least.excess;
  }
  return least.factor / (1.0 + least.excess);
}

std::optional<double> next_factor(const SearchOptions& options,
                                  const std::vector<Outcome>& outcomes) {
  if (outcomes.empty()) return options.from;
  const Bracket bracket = bracket_of(options, outcomes);
  if (bracket.complete) return {};
  if (!bracket.factor()) {
    const double next = step_outward(options, bracket);
    const bool at_bound = next == bracket.stands || next == bracket.fails;
    return at_bound ? std::nullopt : std::optional(next);
  }
  const std::optional<double> expected = expected_limit(outcomes);
  if (!expected || lags(options, outcomes)) return bracket.factor();
  return aim(options.tolerance, bracket, *expected);
}

std::vector<double> likely_next(const SearchOptions& options, const std::vector<Outcome>& outcomes,
                                double factor) {
  const std::optional<double> limit = expected_limit(outcomes);
  if (!limit && !outcomes.empty()) return {};
  const bool likely_fails = limit && factor > *limit;
  std::vector<double> factors;
  for (const bool fails : {likely_fails, !likely_fails}) {
    Outcome outcome{factor, fails};
    if (fails && limit && factor > *limit) outcome.excess = factor / *limit - 1.0;
    std::vector<Outcome> then = outcomes;
    then.push_back(outcome);
    if (const std::optional<double> next = next_factor(options, then)) factors.push_back(*next);
  }
  return factors;
}

int trials_left(const SearchOptions& options, const Bracket& bracket) {
  const bool closed = bracket.stands && bracket.fails;
  const double low = closed ? *bracket.stands : 1.0;
  const double high = closed                                            ? *bracket.fails
                      : options.to && !bracket.stands && !bracket.fails ? *options.to / options.from
                                                                        : outward;
  const double ratio = (high - low) / (options.tolerance * 0.5 * (high + low));
  const int halvings = ratio > 1.0 ? static_cast<int>(std::ceil(std::log2(ratio))) : 0;
  return halvings + (closed ? 0 : bracket.stands || bracket.fails ? 1 : 2);
}

Bracket find_limit(const SearchOptions& options,
                   const std::function<std::optional<Outcome>(double)>& respond,
                   std::vector<Outcome> known) {
  while (const std::optional<double> next = next_factor(options, known)) {
    const std::optional<Outcome> outcome = respond(*next);
    if (!outcome) break;
    known.push_back(*outcome);
  }
  return bracket_of(options, known);
}

}  // namespace scarp
