// SPDX-License-Identifier: BSD-3-Clause
/// The Pareto front of error against run time: what nothing else beats in both.
#pragma once

#include <cstddef>
#include <vector>

namespace scarp::validation {

struct ErrorTime {
  double error = 0.0;   ///< relative; NaN or infinite: not to be chosen
  double wall_s = 0.0;  ///< [s]
};

/// Indices of the points that no other point beats or equals in both with one of them better, by
/// rising run time; of equal points the first.
std::vector<std::size_t> pareto_front(const std::vector<ErrorTime>& points);

/// True for each point that no other clearly beats: none is better by `factor` in error or run time
/// and as good, to 5 %, in the other. A point on the front may be beaten so, if a hair less error
/// took far longer.
std::vector<bool> near_front(const std::vector<ErrorTime>& points, double factor);

}  // namespace scarp::validation
