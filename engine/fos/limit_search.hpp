// SPDX-License-Identifier: BSD-3-Clause
/// Encloses the strength reduction factor at which a slope begins to fail.
#pragma once

#include <functional>
#include <optional>
#include <vector>

namespace scarp {

struct SearchOptions {
  double from = 1.0;         ///< the factor tried first
  std::optional<double> to;  ///< tried next if `from` stands; must be above it
  double tolerance = 0.01;   ///< width of the bracket over its middle at which the search ends
};

/// Factors beyond these are not tried.
inline constexpr double least_reduction = 0.02, most_reduction = 50.0;

/// What is known of the factor of safety: it lies between the two.
struct Bracket {
  std::optional<double> stands;  ///< the largest factor seen to stand
  std::optional<double> fails;   ///< the least factor seen to fail
  bool complete = false;         ///< the search reached its tolerance

  /// The middle of the bracket; empty while one end is missing.
  std::optional<double> factor() const;
};

/// What one factor did, for the search.
struct Outcome {
  double factor = 1.0;
  bool fails = false;
  /// By how much the factor is above the limit, over the limit, as far as the trial alone tells.
  /// Where two fail, what they say is taken in proportion: it has to vanish at the limit. 0: no
  /// telling.
  double excess = 0.0;
};

/// Pre: outcomes that do not contradict each other.
Bracket bracket_of(const SearchOptions& options, const std::vector<Outcome>& outcomes);

/// Where the trials that fail say that the limit lies; empty if none says so.
std::optional<double> expected_limit(const std::vector<Outcome>& outcomes);

/// The factor to try after these: outward from `from` by factors of 1.5 until one trial stands and
/// one fails; then the ends of a bracket around the expected limit; the middle where nothing is
/// expected, or where that has not halved the bracket in three trials. Depends on its arguments
/// alone. Empty: the search is at its end, complete or at the bounds above. Pre: `from` and `to`
/// within these bounds, `tolerance` above 0.
std::optional<double> next_factor(const SearchOptions& options,
                                  const std::vector<Outcome>& outcomes);

/// The factors that may be tried after `factor`, the likely one first: if it does what is expected
/// of it (the first one stands, others fail above the expected limit and stand below it), and if it
/// does the other. Empty: nothing is expected.
std::vector<double> likely_next(const SearchOptions& options, const std::vector<Outcome>& outcomes,
                                double factor);

/// Trials that a search still takes at most once it knows `bracket`, if the factor lies within one
/// step outward and nothing is expected of it.
int trials_left(const SearchOptions& options, const Bracket& bracket);

/// Tries what `next_factor` says after `known` and what has been tried. `respond` is empty if it
/// was told to stop, and so does the search.
Bracket find_limit(const SearchOptions& options,
                   const std::function<std::optional<Outcome>(double)>& respond,
                   std::vector<Outcome> known = {});

}  // namespace scarp
