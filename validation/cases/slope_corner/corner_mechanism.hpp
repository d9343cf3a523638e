// SPDX-License-Identifier: BSD-3-Clause
/// Slip surfaces, stresses and plastic zones of the corners: why the paper says they move as they
/// do.
#pragma once

#include <fmt/format.h>

#include "validation/paper/readings.hpp"

namespace scarp::validation {

/// The same value at P and at Q of one slope.
struct Pair {
  double p, q;
  Finding finding(bool holds, const char* unit) const {
    return {if_measured({p, q}, holds), fmt::format("P {:.3g}, Q {:.3g} {}", p, q, unit)};
  }
};

Finding concave_wing(const ReadingOutcomes& all);
Finding convex_wing(const ReadingOutcomes& all);
Finding symmetrical(const ReadingOutcomes& all);
Finding centre_less_constrained(const ReadingOutcomes& all);
Finding stresses_hold_concave(const ReadingOutcomes& all);
Finding sides_differ_in_direction(const ReadingOutcomes& all);
Finding q_helps_p(const ReadingOutcomes& all);
Finding cracks_reduce_deformation(const ReadingOutcomes& all);
Finding q_fails_first(const ReadingOutcomes& all);
Finding convex_top_sinks_by_q(const ReadingOutcomes& all);
Finding cracks_at_corner_toe(const ReadingOutcomes& all);
Finding concave_triangle(const ReadingOutcomes& all);
Finding convex_quadrilateral(const ReadingOutcomes& all);
Finding slide_from_beside(const ReadingOutcomes& all);

}  // namespace scarp::validation
