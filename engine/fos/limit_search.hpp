// SPDX-License-Identifier: BSD-3-Clause
/// Encloses the strength reduction factor at which a slope begins to fail.
#pragma once

#include <functional>
#include <optional>

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

/// Trials that a search still takes once it knows `bracket`, if the factor lies within one step
/// outward.
int trials_left(const SearchOptions& options, const Bracket& bracket);

/// Steps outward from `from` by factors of 1.5 until one trial stands and one fails, then halves.
/// `fails` says of one factor whether the slope fails; empty: it was told to stop, and so does the
/// search. Without a trial that stands (or fails) within the bounds above an end stays empty. Pre:
/// `from` and `to` within the bounds, `tolerance` above 0.
Bracket find_limit(const SearchOptions& options,
                   const std::function<std::optional<bool>(double)>& fails);

}  // namespace scarp
