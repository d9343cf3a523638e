// SPDX-License-Identifier: BSD-3-Clause
/// Findings on slip surfaces, stresses and plastic zones.

#include "validation/cases/slope_corner/corner_mechanism.hpp"

#include <cmath>

namespace scarp::validation {
namespace {

using Shape = SlopeShape;

Finding slip_surface(const ReadingOutcomes& all, Shape shape, double sign) {
  const double above = all.of(shape).at("slip surface, either side above the corner [m]");
  return {if_measured({above}, sign * above > 0.0),
          fmt::format("either side {:.3g} m above the corner", above)};
}

Pair normal_stress(const ReadingOutcomes& all, Shape shape, const char* moment) {
  const Outcome& outcome = all.of(shape);
  return {outcome.at(fmt::format("section P: across, {} [Pa]", moment)) / 1e3,
          outcome.at(fmt::format("section Q: across, {} [Pa]", moment)) / 1e3};
}

Finding zone_shape(const ReadingOutcomes& all, Shape shape, bool triangle) {
  // Of the rectangle that holds it a triangle takes 1/2, a circle's segment 2/3, a rectangle 1.
  const double share = all.of(shape).at("section P: plastic zone over its rectangle [-]");
  return {if_measured({share}, triangle ? share < 7.0 / 12.0 : share > 2.0 / 3.0),
          fmt::format("{:.3g} of the rectangle", share)};
}

}  // namespace

Finding concave_wing(const ReadingOutcomes& all) {
  return slip_surface(all, Shape::concave_corner, 1.0);
}

Finding convex_wing(const ReadingOutcomes& all) {
  return slip_surface(all, Shape::convex_corner, -1.0);
}

Finding symmetrical(const ReadingOutcomes& all) {
  constexpr const char* sides = "slide volume, difference of the sides over both [-]";
  const double concave = all.of(Shape::concave_corner).at(sides),
               convex = all.of(Shape::convex_corner).at(sides);
  return {if_measured({concave, convex}, concave < 0.02 && convex < 0.02),
          fmt::format("concave {:.2g}, convex {:.2g}", concave, convex)};
}

Finding centre_less_constrained(const ReadingOutcomes& all) {
  const Pair stress = normal_stress(all, Shape::convex_corner, "settled");
  return stress.finding(stress.p < stress.q, "kPa");
}

Finding stresses_hold_concave(const ReadingOutcomes& all) {
  const double concave = normal_stress(all, Shape::concave_corner, "settled").p,
               convex = normal_stress(all, Shape::convex_corner, "settled").p;
  const double plane = all.of(Shape::plane_35).at("section: across, settled [Pa]") / 1e3;
  return {if_measured({concave, convex, plane}, concave > plane && convex < plane),
          fmt::format("concave {:.3g}, 2D {:.3g}, convex {:.3g} kPa", concave, plane, convex)};
}

Finding q_fails_first(const ReadingOutcomes& all) {
  std::string numbers;
  bool holds = true;
  for (const Shape shape : {Shape::concave_corner, Shape::convex_corner}) {
    const double p = all.of(shape).at("P1: failed after [s]"),
                 q = all.of(shape).at("Q1: failed after [s]");
    holds &= q < (std::isnan(p) ? INFINITY : p);  // NaN: it never failed
    numbers +=
        fmt::format("{}{} P1 {:.3g}, Q1 {:.3g} s", numbers.empty() ? "" : "; ", words(shape), p, q);
  }
  return {holds, numbers};
}

Finding convex_top_sinks_by_q(const ReadingOutcomes& all) {
  const Outcome& convex = all.of(Shape::convex_corner);
  const double q = convex.at("Q1: failed after [s]"), p = convex.at("P1: failed after [s]"),
               foot = convex.at("P2: advance [m]"), sinks = convex.at("P1: settlement [m]");
  return {if_measured({foot, sinks}, q < p && foot < sinks),
          fmt::format(
              "Q1 fails after {:.3g} s, P1 after {:.3g} s; P1 sinks {:.3g} m, P2 advances {:.3g} m",
              q, p, sinks, foot)};
}

Finding cracks_at_corner_toe(const ReadingOutcomes& all) {
  const Outcome& convex = all.of(Shape::convex_corner);
  const Pair density{convex.at("section P: lowest density above the toe [-]"),
                     convex.at("section Q: lowest density above the toe [-]")};
  return density.finding(density.p < density.q, "of the initial density");
}

Finding concave_triangle(const ReadingOutcomes& all) {
  return zone_shape(all, Shape::concave_corner, true);
}

Finding convex_quadrilateral(const ReadingOutcomes& all) {
  return zone_shape(all, Shape::convex_corner, false);
}

Finding plastic_by_lateral_slides(const ReadingOutcomes& all) {
  const Outcome& concave = all.of(Shape::concave_corner);
  const Pair area{concave.at("section P: plastic area [m2]"),
                  concave.at("section Q: plastic area [m2]")};
  return area.finding(area.p < area.q, "m2");
}

}  // namespace scarp::validation
