// SPDX-License-Identifier: BSD-3-Clause
/// Bracketing and bisection.

#include "engine/fos/limit_search.hpp"

#include <algorithm>
#include <cmath>

namespace scarp {
namespace {

constexpr double outward = 1.5;

}  // namespace

std::optional<double> Bracket::factor() const {
  if (!stands || !fails) return {};
  return 0.5 * (*stands + *fails);
}

int trials_left(const SearchOptions& options, const Bracket& bracket) {
  const bool closed = bracket.stands && bracket.fails;
  const double low = closed ? *bracket.stands : 1.0;
  const double high = closed                                            ? *bracket.fails
                      : options.to && !bracket.stands && !bracket.fails ? *options.to / options.from
                                                                        : outward;
  const double width = (high - low) / (options.tolerance * 0.5 * (high + low));
  const int halvings = width > 1.0 ? static_cast<int>(std::ceil(std::log2(width))) : 0;
  return halvings + (closed ? 0 : bracket.stands || bracket.fails ? 1 : 2);
}

Bracket find_limit(const SearchOptions& options,
                   const std::function<std::optional<bool>(double)>& fails) {
  Bracket bracket;
  double next = options.from;
  while (true) {
    const std::optional<bool> failed = fails(next);
    if (!failed) return bracket;
    (*failed ? bracket.fails : bracket.stands) = next;
    if (bracket.stands && bracket.fails) {
      const double width = *bracket.fails - *bracket.stands;
      bracket.complete = width <= options.tolerance * *bracket.factor();
      if (bracket.complete) return bracket;
      next = *bracket.factor();
    } else if (bracket.stands) {
      if (next >= most_reduction) return bracket;
      const bool has_end = options.to && *options.to > next;
      next = std::min(has_end ? *options.to : outward * next, most_reduction);
    } else {
      if (next <= least_reduction) return bracket;
      next = std::max(next / outward, least_reduction);
    }
  }
}

}  // namespace scarp
