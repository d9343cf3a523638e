// SPDX-License-Identifier: BSD-3-Clause
/// The paper's sentences on concave, straight ("common") and convex slopes.

#include "validation/cases/slope_curvature/curvature_claims.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace scarp::validation {
namespace {

using Shape = SlopeShape;

constexpr const char* case_1 = "Case 1";
constexpr const char* conclusions_b = "Conclusions (b)";
constexpr double much = 1.5;     ///< "significantly larger", "very different", "much thinner"
constexpr double similar = 0.2;  ///< "more or less similar": spread over the largest

/// A value of the concave, the straight and the convex slope.
using Three = std::array<double, 3>;

Three three(const ReadingOutcomes& all, const std::string& value) {
  return {all.of(Shape::concave).at(value), all.of(Shape::straight).at(value),
          all.of(Shape::convex).at(value)};
}

std::string text(const Three& t, const std::string& unit, double scale = 1.0) {
  return fmt::format("concave {:.3g}, straight {:.3g}, convex {:.3g} {}", t[0] * scale,
                     t[1] * scale, t[2] * scale, unit);
}

Finding finding(const Three& t, bool holds, const std::string& numbers) {
  return {if_measured({t[0], t[1], t[2]}, holds), numbers};
}

bool rising(const Three& t) { return t[0] < t[1] && t[1] < t[2]; }

constexpr const char* thickness = "section M: plastic thickness [m]";
constexpr const char* across = "section M: across, at the end [Pa]";

/// Slide depth at section M less that one spacing from the rough side.
Three dish(const ReadingOutcomes& all) {
  Three t = three(all, "slide depth at M [m]");
  const Three side = three(all, "slide depth at side [m]");
  for (std::size_t k = 0; k < 3; ++k) t[k] -= side[k];
  return t;
}

Finding any_dish(const ReadingOutcomes& all) {
  const Three t = dish(all);
  return finding(t, std::min({t[0], t[1], t[2]}) > 0.0, text(t, "m"));
}

Finding clearer_dish(const ReadingOutcomes& all) {
  const Three t = dish(all);
  return finding(t, rising(t), text(t, "m"));
}

Finding convex_moves_most(const ReadingOutcomes& all) {
  const Three t = three(all, "largest displacement, 99.9 % [m]");
  return finding(t, t[2] > std::max(t[0], t[1]), text(t, "m"));
}

Finding convex_volume(const ReadingOutcomes& all) {
  const Three t = three(all, "slide volume [m3]");
  return finding(t, t[2] > much * std::max(t[0], t[1]), text(t, "m3"));
}

Finding concave_thinner(const ReadingOutcomes& all) {
  const Three t = three(all, thickness);
  return finding(t, t[0] * much < t[2], text(t, "m"));
}

Finding straight_between(const ReadingOutcomes& all) {
  const Three t = three(all, thickness);
  return finding(t, rising(t), text(t, "m"));
}

/// A probe's displacement in 3D and in the plane.
Finding against_plane(const ReadingOutcomes& all, Shape shape, const char* probe, const char* plane,
                      double sign) {
  const double in_3d = all.of(shape).at(probe), in_2d = all.of(Shape::plane_45).at(plane);
  return {if_measured({in_3d, in_2d}, sign * (in_3d - in_2d) > 0.0),
          fmt::format("3D {:.3g}, 2D {:.3g} m", in_3d, in_2d)};
}

template <Shape shape, int sign>
Finding top_against_plane(const ReadingOutcomes& all) {
  return against_plane(all, shape, "M1: settlement [m]", "crest: settlement [m]", sign);
}

template <Shape shape, int sign>
Finding toe_against_plane(const ReadingOutcomes& all) {
  return against_plane(all, shape, "M2: advance [m]", "toe: advance [m]", sign);
}

template <Shape shape, int sign>
Finding front_against_plane(const ReadingOutcomes& all) {
  return against_plane(all, shape, "section M: front: advance [m]", "section: front: advance [m]",
                       sign);
}

Finding planar_stress_similar(const ReadingOutcomes& all) {
  const Three along = three(all, "section M: along, settled [Pa]"),
              vertical = three(all, "section M: vertical, settled [Pa]");
  const auto spread = [](const Three& t) {
    const auto [low, high] = std::minmax_element(t.begin(), t.end());
    return (*high - *low) / *high;
  };
  return finding(
      along, spread(along) < similar && spread(vertical) < similar,
      "horizontal " + text(along, "kPa", 1e-3) + "; vertical " + text(vertical, "kPa", 1e-3));
}

Finding normal_stress_differs(const ReadingOutcomes& all) {
  const Three t = three(all, across);
  const auto [low, high] = std::minmax_element(t.begin(), t.end());
  return finding(t, *high > much * *low, text(t, "kPa", 1e-3));
}

Finding concave_lateral_stress(const ReadingOutcomes& all) {
  const Three t = three(all, across);
  return finding(t, t[0] > std::max(t[1], t[2]), text(t, "kPa", 1e-3));
}

Finding convex_the_opposite(const ReadingOutcomes& all) {
  const Three t = three(all, across);
  return finding(t, t[0] > t[1] && t[1] > t[2], text(t, "kPa", 1e-3));
}

Finding arch(const ReadingOutcomes& all) {
  Three t = three(all, "section M: along, at the end [Pa]");
  const Three side = three(all, "side: downhill, at the end [Pa]");
  for (std::size_t k = 0; k < 3; ++k) t[k] /= side[k];
  return finding(t, t[0] < 1.0 && t[0] < t[2], text(t, "of the stress at the side"));
}

Finding failure_delayed(const ReadingOutcomes& all) {
  Three t = three(all, "M1: failed after [s]");
  for (double& time : t) {
    if (std::isnan(time)) time = INFINITY;  // it never failed
  }
  return {t[0] > t[1] && t[1] > t[2], text(t, "s")};
}

Finding shear_zone_larger(const ReadingOutcomes& all) {
  const Three t = three(all, "section M: plastic area [m2]");
  return finding(t, t[0] < t[2], text(t, "m2"));
}

Finding bulges_top(const ReadingOutcomes& all) {
  const Three t = three(all, "M1: settlement [m]");
  return finding(t, rising(t), text(t, "m"));
}

Finding bulges_toe(const ReadingOutcomes& all) {
  const Three t = three(all, "M2: advance [m]");
  return finding(t, rising(t), text(t, "m"));
}

Finding bulges_front(const ReadingOutcomes& all) {
  const Three t = three(all, "section M: front: advance [m]");
  return finding(t, rising(t), text(t, "m"));
}

Finding differs_from_plane(const ReadingOutcomes& all) {
  Three t = three(all, "M1: settlement [m]");
  const double plane = all.of(Shape::plane_45).at("crest: settlement [m]");
  for (double& value : t) value = value / plane - 1.0;
  const auto differs = [](double part) { return std::fabs(part) > 0.1; };
  return finding(t, std::all_of(t.begin(), t.end(), differs), text(t, "% more than 2D", 100.0));
}

Finding related_to_lateral_stress(const ReadingOutcomes& all) {
  const Three stress = three(all, across), top = three(all, "M1: settlement [m]");
  bool opposite = true;
  for (std::size_t a = 0; a < 3; ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      opposite &= (stress[a] - stress[b]) * (top[a] - top[b]) < 0.0;
    }
  }
  return finding(stress, opposite, text(stress, "kPa", 1e-3) + "; top " + text(top, "m"));
}

constexpr const char* front =
    "how far the foot of the soil above toe level advances on section M; the slip may leave above "
    "M2";

constexpr std::array rows = std::to_array<ReadingClaim>({
    {case_1, "the whole slip surface eventually evolves to a dish shape",
     "depth of the slide below the middle of the face: at section M above that at the rough side",
     any_dish},
    {case_1, "the dish shape becomes successively clearer: concave, common, convex",
     "difference of these depths rises in this order", clearer_dish},
    {case_1, "the convex slope causes the largest displacement of the three",
     "99.9 % quantile of the displacement", convex_moves_most},
    {case_1, "its volume of the slide body is significantly larger than the others",
     "soil that moved over 4 % of the height: 1.5 times both others", convex_volume},
    {case_1, "the plastic area of the concave slope is much thinner than that of the convex slope",
     "plastic area (strain over 0.1) of section M over its length along the face: by 1.5",
     concave_thinner},
    {case_1, "and the common slope falls in between", "the same", straight_between},
    {case_1, "convex: the settlement at M1 is greater than for the 2D case", "M1, at the end",
     top_against_plane<Shape::convex, 1>},
    {case_1, "convex: the translation at M2 is greater than for the 2D case", "M2, at the end",
     toe_against_plane<Shape::convex, 1>},
    {conclusions_b, "convex: the translational distance of the slope toe is greater than for 2D",
     front, front_against_plane<Shape::convex, 1>},
    {case_1, "the opposite occurs for the concave slope: M1", "M1, at the end",
     top_against_plane<Shape::concave, -1>},
    {case_1, "the opposite occurs for the concave slope: M2", "M2, at the end",
     toe_against_plane<Shape::concave, -1>},
    {conclusions_b, "the opposite occurs for the concave slope: its toe", front,
     front_against_plane<Shape::concave, -1>},
    {case_1, "straight: the settlement at M1 is less than for the 2D case", "M1, at the end",
     top_against_plane<Shape::straight, -1>},
    {case_1, "straight: the translation at M2 is less than for the 2D case", "M2, at the end",
     toe_against_plane<Shape::straight, -1>},
    {conclusions_b, "and for the common slope: its toe", front,
     front_against_plane<Shape::straight, -1>},
    {case_1, "the planar stresses in the M plane should be more or less similar",
     "settled, means over the soil above the toe: within 20 %", planar_stress_similar},
    {case_1, "however, the normal stress on the M plane is very different",
     "mean over the same soil at the end: by 1.5", normal_stress_differs},
    {case_1, "concave: the walls induce strong lateral stress", "the same: greatest of the three",
     concave_lateral_stress},
    {case_1, "the convex situation is just the opposite, the common one falls in between",
     "the same: concave above straight above convex", convex_the_opposite},
    {case_1, "concave: longitudinal stress of the M plane is redistributed to lateral zones (arch)",
     "horizontal stress on M over that at the side: below 1 and below the convex slope's", arch},
    {case_1, "concave: these effects delay the shear failure of the soil",
     "time until M1 has moved 1 % of the height: concave after straight after convex",
     failure_delayed},
    {case_1, "a confined deformation zone (concave), shear failure in a large zone (convex)",
     "plastic area of section M", shear_zone_larger},
    {case_1, "the more the slope bulges, the farther the settlement of the top", "M1, at the end",
     bulges_top},
    {case_1, "... and the translational distance of the slope toe", "M2, at the end", bulges_toe},
    {case_1, "... and how far the slope toe migrates", front, bulges_front},
    {"Conclusions (a)",
     "2D results are different from 3D, and the difference is related to the surface",
     "settlement of M1 off the plane's by more than 10 % for each", differs_from_plane},
    {conclusions_b, "these are all related to lateral stress magnitude at the middle plane",
     "the less normal stress on M, the more M1 settles", related_to_lateral_stress},
});

}  // namespace

void judge_curvature_claims(CaseRun& run, const std::vector<ReadingOutcomes>& readings) {
  judge_claims(run, rows, readings);
}

}  // namespace scarp::validation
