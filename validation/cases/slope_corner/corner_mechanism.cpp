// SPDX-License-Identifier: BSD-3-Clause
/// Findings on slip surfaces, stresses and plastic zones.

#include "validation/cases/slope_corner/corner_mechanism.hpp"

#include <algorithm>
#include <cmath>

namespace scarp::validation {
namespace {

using Shape = SlopeShape;

/// Rises (sign 1) or falls to either side of the corner; `junction` is what the slides do there.
Finding wing(const ReadingOutcomes& all, Shape shape, double sign, bool junction) {
  const Outcome& outcome = all.of(shape);
  const double above = outcome.at("slip surface beside P above that at P [m]"),
               ground = outcome.at("ground beside P above that at P [m]"),
               at_p = outcome.at("slide depth at P [m]"),
               beside = outcome.at("slide depth beside P [m]");
  return {if_measured({above, at_p, beside}, beside > 0.0 && sign * above > 0.0 && junction),
          fmt::format("{:.3g} m to either side, the ground {:.3g} m; slide {:.3g} m deep at P, "
                      "{:.3g} m beside",
                      above, ground, at_p, beside)};
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
  const Outcome& concave = all.of(Shape::concave_corner);
  return wing(all, Shape::concave_corner, 1.0,
              concave.at("slide depth at P [m]") < concave.at("slide depth beside P [m]"));
}

Finding convex_wing(const ReadingOutcomes& all) {
  const Outcome& convex = all.of(Shape::convex_corner);
  return wing(all, Shape::convex_corner, -1.0, convex.at("slide depth at P [m]") > 0.0);
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

Finding sides_differ_in_direction(const ReadingOutcomes& all) {
  const auto turn = [&](Shape shape) {
    return all.of(shape).at("beside P: turn of the greater pressure, settled [deg]");
  };
  const double concave = turn(Shape::concave_corner), convex = turn(Shape::convex_corner);
  // The other side has the opposite turn; along the diagonal and across it both are one direction.
  const auto between = [](double angle) {
    return std::min(2.0 * std::fabs(angle), 180.0 - 2.0 * std::fabs(angle));
  };
  const double concave_between = between(concave), convex_between = between(convex);
  return {if_measured({concave, convex}, concave_between > 10.0 && convex_between > 10.0),
          fmt::format("concave {:.3g}, convex {:.3g} deg", concave_between, convex_between)};
}

Finding q_fails_first(const ReadingOutcomes& all) {
  std::vector<double> times;
  std::string numbers;
  bool holds = true;
  for (const Shape shape : {Shape::concave_corner, Shape::convex_corner}) {
    const double p = failed_after(all.of(shape), "P1"), q = failed_after(all.of(shape), "Q1");
    times.insert(times.end(), {p, q});
    holds &= q < p;
    numbers +=
        fmt::format("{}{} P1 {:.3g}, Q1 {:.3g} s", numbers.empty() ? "" : "; ", words(shape), p, q);
  }
  return {if_measured(times, holds), numbers + " (inf: never)"};
}

Finding q_helps_p(const ReadingOutcomes& all) {
  const double concave = all.of(Shape::concave_corner).at("P1: settlement [m]"),
               convex = all.of(Shape::convex_corner).at("P1: settlement [m]"),
               plane = all.of(Shape::plane_35).at("crest: settlement [m]");
  return {if_measured({concave, convex, plane}, std::max(concave, convex) < plane),
          fmt::format("concave {:.3g}, convex {:.3g}, 2D of P {:.3g} m", concave, convex, plane)};
}

Finding convex_top_sinks_by_q(const ReadingOutcomes& all) {
  const Outcome& convex = all.of(Shape::convex_corner);
  const double q = failed_after(convex, "Q1"), p = failed_after(convex, "P1"),
               whole_p = convex.at("section P: mean displacement of the soil above the toe [m]"),
               whole_q = convex.at("section Q: mean displacement of the soil above the toe [m]");
  return {if_measured({q, p, whole_p, whole_q}, q < p && whole_p < whole_q),
          fmt::format("Q1 fails after {:.3g} s, P1 after {:.3g} s; soil above the toe moves "
                      "{:.3g} m in Q, {:.3g} m in P",
                      q, p, whole_q, whole_p)};
}

Finding cracks_at_corner_toe(const ReadingOutcomes& all) {
  const Outcome& convex = all.of(Shape::convex_corner);
  constexpr const char* kept = "section {}: fewest neighbours above the toe, now over before [-]";
  const Pair share{convex.at(fmt::format(kept, "P")), convex.at(fmt::format(kept, "Q"))};
  return share.finding(share.p < 0.9 * share.q, "of the neighbours");
}

Finding cracks_reduce_deformation(const ReadingOutcomes& all) {
  const Outcome& convex = all.of(Shape::convex_corner);
  const Pair toe{convex.at("P2: advance [m]"), convex.at("Q2: advance [m]")},
      foot{convex.at("section P: front: advance [m]"), convex.at("section Q: front: advance [m]")};
  return {if_measured({toe.p, toe.q, foot.p, foot.q}, toe.p < toe.q && foot.p < foot.q),
          fmt::format("P2 {:.3g}, Q2 {:.3g} m; foot of the slide P {:.3g}, Q {:.3g} m", toe.p,
                      toe.q, foot.p, foot.q)};
}

Finding concave_triangle(const ReadingOutcomes& all) {
  return zone_shape(all, Shape::concave_corner, true);
}

Finding convex_quadrilateral(const ReadingOutcomes& all) {
  return zone_shape(all, Shape::convex_corner, false);
}

Finding slide_from_beside(const ReadingOutcomes& all) {
  const double share =
      all.of(Shape::concave_corner).at("section P: share of the slide from beside [-]");
  return {if_measured({share}, share > 0.5),
          std::isnan(share) ? "no slide ends there" : fmt::format("{:.3g} %", 100.0 * share)};
}

}  // namespace scarp::validation
