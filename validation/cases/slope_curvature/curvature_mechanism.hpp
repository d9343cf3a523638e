// SPDX-License-Identifier: BSD-3-Clause
/// Stresses and failure of the curved slopes: why the paper says they move as they do.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>

#include "validation/paper/readings.hpp"

namespace scarp::validation {

using Shape = SlopeShape;

inline constexpr double much = 1.5;  ///< "significantly larger", "very different", "much thinner"
inline constexpr double similar = 0.2;  ///< "more or less similar": spread over the largest

/// A value of the concave, the straight and the convex slope.
using Three = std::array<double, 3>;

inline Three three(const ReadingOutcomes& all, const std::string& value) {
  return {all.of(Shape::concave).at(value), all.of(Shape::straight).at(value),
          all.of(Shape::convex).at(value)};
}

inline std::string text(const Three& t, const std::string& unit, double scale = 1.0) {
  return fmt::format("concave {:.3g}, straight {:.3g}, convex {:.3g} {}", t[0] * scale,
                     t[1] * scale, t[2] * scale, unit);
}

inline Finding finding(const Three& t, bool holds, const std::string& numbers) {
  return {if_measured({t[0], t[1], t[2]}, holds), numbers};
}

inline bool rising(const Three& t) { return t[0] < t[1] && t[1] < t[2]; }

inline bool falling(const Three& t) { return t[0] > t[1] && t[1] > t[2]; }

/// Least over greatest.
inline double least_share(const Three& t) {
  const auto [low, high] = std::minmax_element(t.begin(), t.end());
  return *low / *high;
}

Finding planar_stress_similar(const ReadingOutcomes& all);
Finding normal_stress_differs(const ReadingOutcomes& all);
Finding concave_lateral_stress(const ReadingOutcomes& all);
Finding extra_confining_pressure(const ReadingOutcomes& all);
Finding arch(const ReadingOutcomes& all);
Finding convex_the_opposite(const ReadingOutcomes& all);
Finding failure_delayed(const ReadingOutcomes& all);
Finding shear_zone_larger(const ReadingOutcomes& all);
Finding three_stresses(const ReadingOutcomes& all);
Finding related_to_lateral_stress(const ReadingOutcomes& all);

}  // namespace scarp::validation
