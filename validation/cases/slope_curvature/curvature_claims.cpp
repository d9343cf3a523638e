// SPDX-License-Identifier: BSD-3-Clause
/// The paper's sentences on concave, straight ("common") and convex slopes.

#include "validation/cases/slope_curvature/curvature_claims.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "validation/cases/slope_curvature/curvature_mechanism.hpp"

namespace scarp::validation {
namespace {

constexpr const char* case_1 = "Case 1";
constexpr const char* conclusions_b = "Conclusions (b)";
constexpr const char* thickness_m = "section M: plastic thickness [m]";
constexpr const char* thickness_n = "section N: plastic thickness [m]";
Finding any_dish(const ReadingOutcomes& all) {
  const Three m = three(all, "slide depth at M [m]"),
              between = three(all, "slide depth between [m]"),
              side = three(all, "slide depth at side [m]");
  bool holds = true;
  for (std::size_t k = 0; k < 3; ++k) holds &= m[k] > between[k] && between[k] > side[k];
  return finding(
      m, holds,
      "M " + text(m, "m") + "; half way " + text(between, "m") + "; side " + text(side, "m"));
}

Finding clearer_dish(const ReadingOutcomes& all) {
  Three t = three(all, "slide depth at M [m]");
  const Three side = three(all, "slide depth at side [m]");
  for (std::size_t k = 0; k < 3; ++k) t[k] -= side[k];
  return finding(t, rising(t), text(t, "m"));
}

Finding convex_not_restrained(const ReadingOutcomes& all) {
  Three t = three(all, "share of the slide at the rough side [-]");
  return finding(t, t[2] < std::min(t[0], t[1]), text(t, "% of the slide", 100.0));
}

Finding convex_moves_most(const ReadingOutcomes& all) {
  const Three t = three(all, "largest displacement, 99.9 % [m]");
  return finding(t, t[2] > std::max(t[0], t[1]), text(t, "m"));
}

Finding convex_volume(const ReadingOutcomes& all) {
  const Three t = three(all, "slide volume [m3]");
  return finding(t, t[2] > much * std::max(t[0], t[1]), text(t, "m3"));
}

Finding thinner(const ReadingOutcomes& all, bool (*holds)(const Three&)) {
  const Three m = three(all, thickness_m), n = three(all, thickness_n);
  return {if_measured({m[0], m[1], m[2], n[0], n[1], n[2]}, holds(m) && holds(n)),
          "M " + text(m, "m") + "; N " + text(n, "m")};
}

Finding concave_thinner(const ReadingOutcomes& all) {
  return thinner(all, [](const Three& t) { return t[0] * much < t[2]; });
}

Finding straight_between(const ReadingOutcomes& all) { return thinner(all, rising); }

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

/// Settlement of M1 over that of the plane slope's crest.
Three over_plane(const ReadingOutcomes& all) {
  Three t = three(all, "M1: settlement [m]");
  for (double& value : t) value /= all.of(Shape::plane_45).at("crest: settlement [m]");
  return t;
}

Finding differs_from_plane(const ReadingOutcomes& all) {
  const Three t = over_plane(all);
  const auto differs = [](double part) { return std::fabs(part - 1.0) > 0.1; };
  return finding(t, std::all_of(t.begin(), t.end(), differs) && rising(t), text(t, "times 2D"));
}

Finding no_simple_relation(const ReadingOutcomes& all) {
  const Three t = over_plane(all);
  const auto [low, high] = std::minmax_element(t.begin(), t.end());
  return finding(t, *low < 1.0 && *high > 1.0, text(t, "times 2D"));
}

Finding geometry_matters(const ReadingOutcomes& all) {
  const Three top = three(all, "M1: settlement [m]"), slip = three(all, "slide depth at M [m]"),
              foot = three(all, "section M: front: advance [m]");
  const double most = std::max({least_share(top), least_share(slip), least_share(foot)});
  return {
      if_measured({top[0], top[1], top[2], slip[0], slip[1], slip[2], foot[0], foot[1], foot[2]},
                  most * much < 1.0),
      "settlement " + text(top, "m") + "; slip surface " + text(slip, "m deep") +
          "; foot of the slide " + text(foot, "m")};
}

constexpr const char* front =
    "how far the foot of the soil above toe level advances on section M; the slip may leave above "
    "M2";

constexpr std::array rows = std::to_array<ReadingClaim>({
    {case_1, "the whole slip surface eventually evolves to a dish shape",
     "thickness of the slide at the middle of the face: falls from section M over half way to the "
     "rough side",
     any_dish},
    {case_1, "the dish shape becomes successively clearer: concave, common, convex",
     "thickness at section M less that at the side: rises in this order", clearer_dish},
    {case_1, "the convex slope, which is not restrained by the boundaries",
     "share of the slide within two spacings of the rough side: least of the three",
     convex_not_restrained},
    {case_1, "the convex slope causes the largest displacement of the three",
     "99.9 % quantile of the displacement", convex_moves_most},
    {case_1, "its volume of the slide body is significantly larger than the others",
     "soil that moved over 4 % of the height: 1.5 times both others", convex_volume},
    {case_1, "the plastic area of the concave slope is much thinner than that of the convex slope",
     "plastic area (strain over 0.1) of section M over its length along the face, and of section N "
     "over the width: by 1.5",
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
     "settled, mean over the same soil: by 1.5", normal_stress_differs},
    {case_1, "concave: the walls induce strong lateral stress", "the same: greatest of the three",
     concave_lateral_stress},
    {case_1, "which provides extra confining pressure to the soil on the M plane",
     "the same: concave above 2D", extra_confining_pressure},
    {case_1, "concave: longitudinal stress of the M plane is redistributed to lateral zones (arch)",
     "settled, horizontal stress on M over that at the side: below 1 and below the convex slope's",
     arch},
    {case_1, "concave: these effects delay the shear failure of the soil",
     "time until M1 has moved 1 % of the height: concave after straight after convex",
     failure_delayed},
    {case_1, "the convex situation is just the opposite, the common one falls in between",
     "normal stress on M falls and the arch's ratio rises from concave over straight to convex",
     convex_the_opposite},
    {case_1, "a confined deformation zone (concave), shear failure in a large zone (convex)",
     "plastic area of section M: by 1.5", shear_zone_larger},
    {case_1, "the more the slope bulges, the farther the settlement of the top", "M1, at the end",
     bulges_top},
    {case_1, "... and the translational distance of the slope toe", "M2, at the end", bulges_toe},
    {case_1, "... and the translational distance of the slope toe", front, bulges_front},
    {"Discussion", "the three normal stresses may differ from each other in the symmetric plane",
     "settled, means over the soil above the toe: each off the next by over 10 %", three_stresses},
    {"Discussion", "there is no simple relation between the 2D and 3D results",
     "settlement of M1 over that in 2D: below 1 and above 1", no_simple_relation},
    {"Conclusions (a)", "the 3D geometry affects the final profile, slip surface and distance",
     "settlement of M1, depth of the slide at M, advance of its foot: each by 1.5 over the shapes",
     geometry_matters},
    {"Conclusions (a)",
     "2D results are different from 3D, and the difference is related to the surface",
     "settlement of M1: off that in 2D by over 10 % for each, rising from concave to convex",
     differs_from_plane},
    {conclusions_b, "these are all related to lateral stress magnitude at the middle plane",
     "the less normal stress on M, the more M1 settles", related_to_lateral_stress},
});

}  // namespace

void judge_curvature_claims(CaseRun& run, const std::vector<ReadingOutcomes>& readings) {
  judge_claims(run, rows, readings);
}

}  // namespace scarp::validation
