// SPDX-License-Identifier: BSD-3-Clause
/// The paper's sentences on slopes that turn a corner.

#include "validation/cases/slope_corner/corner_claims.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "validation/cases/slope_corner/corner_mechanism.hpp"

namespace scarp::validation {
namespace {

using Shape = SlopeShape;

constexpr const char* case_2 = "Case 2";
constexpr const char* conclusions = "Conclusions (c)";
constexpr double far_below = 0.5;  ///< of the plane counterpart

/// A value of a corner slope's section and of the plane counterparts of sections P and Q.
struct AgainstPlane {
  double value, plane_p, plane_q;
  std::string text() const {
    return fmt::format("3D {:.3g}, 2D of P {:.3g}, 2D of Q {:.3g} m", value, plane_p, plane_q);
  }
  Finding finding(bool holds) const {
    return {if_measured({value, plane_p, plane_q}, holds), text()};
  }
  bool between() const {
    return value > std::min(plane_p, plane_q) && value < std::max(plane_p, plane_q);
  }
};

AgainstPlane top(const ReadingOutcomes& all, Shape shape, const char* probe) {
  constexpr const char* plane = "crest: settlement [m]";
  return {all.of(shape).at(fmt::format("{}: settlement [m]", probe)),
          all.of(Shape::plane_35).at(plane), all.of(Shape::plane_45).at(plane)};
}

AgainstPlane toe(const ReadingOutcomes& all, Shape shape, const char* probe) {
  constexpr const char* plane = "toe: advance [m]";
  return {all.of(shape).at(fmt::format("{}: advance [m]", probe)),
          all.of(Shape::plane_35).at(plane), all.of(Shape::plane_45).at(plane)};
}

Pair tops(const ReadingOutcomes& all, Shape shape) {
  return {top(all, shape, "P1").value, top(all, shape, "Q1").value};
}

Pair toes(const ReadingOutcomes& all, Shape shape) {
  return {toe(all, shape, "P2").value, toe(all, shape, "Q2").value};
}

/// Mean displacement of the soil above the toe.
Pair whole(const ReadingOutcomes& all, Shape shape) {
  constexpr const char* value = "section {}: mean displacement of the soil above the toe [m]";
  return {all.of(shape).at(fmt::format(value, "P")), all.of(shape).at(fmt::format(value, "Q"))};
}

Finding centre_moves_less(const ReadingOutcomes& all) {
  const Pair concave = whole(all, Shape::concave_corner), convex = whole(all, Shape::convex_corner);
  return {if_measured({concave.p, concave.q, convex.p, convex.q},
                      concave.p < concave.q && convex.p < convex.q),
          fmt::format("concave P {:.3g}, Q {:.3g}; convex P {:.3g}, Q {:.3g} m", concave.p,
                      concave.q, convex.p, convex.q)};
}

Finding flatter_is_more_stable(const ReadingOutcomes& all) {
  const AgainstPlane crest = top(all, Shape::convex_corner, "P1");
  return {if_measured({crest.plane_p, crest.plane_q}, crest.plane_p < crest.plane_q),
          fmt::format("2D of P {:.3g}, of Q {:.3g} m", crest.plane_p, crest.plane_q)};
}

Finding concave_top_immobile(const ReadingOutcomes& all) {
  const double p1 = top(all, Shape::concave_corner, "P1").value;
  const double share = p1 / all.size.height;
  return {if_measured({p1}, share < failure_share),
          fmt::format("{:.3g} m = {:.2g} % of the height", p1, 100.0 * share)};
}

Finding convex_top_between(const ReadingOutcomes& all) {
  const AgainstPlane p1 = top(all, Shape::convex_corner, "P1");
  return p1.finding(p1.between());
}

Finding toes_far_below(const ReadingOutcomes& all) {
  const AgainstPlane concave = toe(all, Shape::concave_corner, "P2"),
                     convex = toe(all, Shape::convex_corner, "P2");
  return {if_measured({concave.value, convex.value, convex.plane_p},
                      std::max(concave.value, convex.value) < far_below * convex.plane_p),
          fmt::format("concave {:.3g}, convex {:.3g}, 2D of P {:.3g} m", concave.value,
                      convex.value, convex.plane_p)};
}

/// How far the foot of the soil that lay above toe level has come.
AgainstPlane front(const ReadingOutcomes& all, Shape shape, const char* section) {
  constexpr const char* plane = "section: front: advance [m]";
  return {all.of(shape).at(fmt::format("section {}: front: advance [m]", section)),
          all.of(Shape::plane_35).at(plane), all.of(Shape::plane_45).at(plane)};
}

Finding corner_front_safe(const ReadingOutcomes& all) {
  const Pair concave{front(all, Shape::concave_corner, "P").value,
                     front(all, Shape::concave_corner, "Q").value},
      convex{front(all, Shape::convex_corner, "P").value,
             front(all, Shape::convex_corner, "Q").value};
  return {if_measured({concave.p, concave.q, convex.p, convex.q},
                      concave.p < concave.q && convex.p < convex.q),
          fmt::format("concave P {:.3g}, Q {:.3g}; convex P {:.3g}, Q {:.3g} m", concave.p,
                      concave.q, convex.p, convex.q)};
}

Finding plane_q_higher(const ReadingOutcomes& all) {
  const AgainstPlane p2 = toe(all, Shape::convex_corner, "P2");
  return {if_measured({p2.plane_p, p2.plane_q}, p2.plane_q > p2.plane_p),
          fmt::format("2D of P {:.3g}, of Q {:.3g} m", p2.plane_p, p2.plane_q)};
}

Finding concave_q1_between(const ReadingOutcomes& all) {
  const AgainstPlane q1 = top(all, Shape::concave_corner, "Q1");
  return q1.finding(q1.between());
}

Finding concave_q2_between(const ReadingOutcomes& all) {
  const AgainstPlane q2 = toe(all, Shape::concave_corner, "Q2");
  return q2.finding(q2.between());
}

Finding convex_q_below(const ReadingOutcomes& all) {
  constexpr const char* advance = ": advance [m]";
  const double q1 = all.of(Shape::convex_corner).at(std::string("Q1") + advance),
               crest = all.of(Shape::plane_35).at(std::string("crest") + advance);
  const AgainstPlane q2 = toe(all, Shape::convex_corner, "Q2");
  return {if_measured({q1, crest, q2.value, q2.plane_p}, q1 < crest && q2.value < q2.plane_p),
          fmt::format("Q1 {:.3g}, 2D of P {:.3g} m; Q2 {:.3g}, 2D of P {:.3g} m", q1, crest,
                      q2.value, q2.plane_p)};
}

Finding corner_toe_safe(const ReadingOutcomes& all) {
  const Pair concave = toes(all, Shape::concave_corner), convex = toes(all, Shape::convex_corner);
  return {if_measured({concave.p, concave.q, convex.p, convex.q},
                      concave.p < concave.q && convex.p < convex.q),
          fmt::format("concave P2 {:.3g}, Q2 {:.3g}; convex P2 {:.3g}, Q2 {:.3g} m", concave.p,
                      concave.q, convex.p, convex.q)};
}

Finding convex_top_unstable(const ReadingOutcomes& all) {
  const Pair t = tops(all, Shape::convex_corner);
  const double foot = toe(all, Shape::convex_corner, "P2").value;
  return {if_measured({t.p, t.q, foot}, t.p > t.q && t.p > foot),
          fmt::format("P1 {:.3g}, Q1 {:.3g}, P2 {:.3g} m", t.p, t.q, foot)};
}

Finding concave_side_unstable(const ReadingOutcomes& all) {
  const Pair t = tops(all, Shape::concave_corner), f = toes(all, Shape::concave_corner);
  return {if_measured({t.p, t.q, f.p, f.q}, t.p < t.q && f.p < f.q),
          fmt::format("top P {:.3g}, Q {:.3g}; toe P {:.3g}, Q {:.3g} m", t.p, t.q, f.p, f.q)};
}

/// Settlement of a top and of its plane counterpart.
using TopAndPlane = std::array<double, 2>;

std::vector<TopAndPlane> tops_of_corners(const ReadingOutcomes& all) {
  std::vector<TopAndPlane> points;
  for (const Shape shape : {Shape::concave_corner, Shape::convex_corner}) {
    const AgainstPlane p = top(all, shape, "P1"), q = top(all, shape, "Q1");
    points.insert(points.end(), {{p.value, p.plane_p}, {q.value, q.plane_q}});
  }
  return points;
}

Finding plane_misses_corner(const ReadingOutcomes& all) {
  std::vector<double> numbers;
  std::string text;
  bool holds = true;
  constexpr std::array names{"concave P1", "Q1", "convex P1", "Q1"};
  const std::vector<TopAndPlane> points = tops_of_corners(all);
  for (std::size_t k = 0; k < points.size(); ++k) {
    const auto [value, plane] = points[k];
    numbers.insert(numbers.end(), {value, plane});
    holds &= std::fabs(value - plane) > 0.1 * plane;
    text += fmt::format("{}{} {:.3g} for {:.3g}", k == 0 ? "" : ", ", names[k], value, plane);
  }
  return {if_measured(numbers, holds), text + " m in 2D"};
}

/// Mean of how far the settlements are off their plane counterparts [m]: shares of a plane slope
/// that hardly moves would tell nothing.
double off_plane(const std::vector<TopAndPlane>& points) {
  double sum = 0.0;
  for (const auto& [value, plane] : points) sum += std::fabs(value - plane);
  return sum / static_cast<double>(points.size());
}

Finding more_apparent(const ReadingOutcomes& all) {
  std::vector<TopAndPlane> curved;
  for (const Shape shape : {Shape::concave, Shape::straight, Shape::convex}) {
    if (!all.has(shape)) return {{}, "case slope_curvature has not been run in this folder"};
    curved.push_back({all.of(shape).at("M1: settlement [m]"),
                      all.of(Shape::plane_45).at("crest: settlement [m]")});
  }
  const double curvature = off_plane(curved), corner = off_plane(tops_of_corners(all));
  return {if_measured({curvature, corner}, corner > curvature),
          fmt::format("case 1 {:.3g} m, case 2 {:.3g} m", curvature, corner)};
}

constexpr const char* across_the_diagonal =
    "slip surface across the diagonal at mid-face, half a height to either side against the corner";

constexpr std::array rows = std::to_array<ReadingClaim>({
    {case_2, "the 2D simulation could not represent the deformation characteristics for the corner",
     "settlement of P1 and Q1: each off its 2D case by over 10 %", plane_misses_corner},
    {case_2, "concave: hollow junction of two 'C' surfaces, like a rising wing",
     "the slip surface rises from the corner to either side, where the slide is deeper",
     concave_wing},
    {case_2, "convex: raised combination of two 'S' curves, like the downbeat of a wing",
     across_the_diagonal, convex_wing},
    {case_2, "with a symmetrical shape",
     "slide volume on the two sides of the diagonal: within 2 % (the scene is symmetric)",
     symmetrical},
    {case_2, "the displacement at the centre section is smaller than that at the lateral section",
     "mean displacement of the soil above the toe: P below Q, both corners", centre_moves_less},
    {case_2, "the slope angle at the centre is smaller, which makes it more stable",
     "settlement of the crest in the plane counterparts", flatter_is_more_stable},
    {case_2, "the slope at the centre suffers less constraint of the lateral zones",
     "convex, settled: mean normal stress on the sections, soil above the toe",
     centre_less_constrained},
    {case_2, "the peak P1 of the concave subbase is almost immobile",
     "settlement of P1 below 1 % of the height", concave_top_immobile},
    {case_2, "P1 of the convex subbase falls in between the 2D cases for sections P and Q",
     "settlement of P1", convex_top_between},
    {case_2, "P2 for concave and convex is small and far below the 2D case in section P",
     "advance of P2 below half of it", toes_far_below},
    {case_2, "the 2D case in cross-section Q is higher than that in section P",
     "advance of the toe", plane_q_higher},
    {case_2, "Q1 of the concave subbase falls between the 2D cases for sections P and Q",
     "settlement of Q1", concave_q1_between},
    {case_2, "as does the horizontal displacement at Q2", "advance of Q2", concave_q2_between},
    {case_2, "convex: the horizontal displacements at Q1 and Q2 are smaller than 2D in section P",
     "advance of Q1 and of Q2", convex_q_below},
    {case_2, "the foot of the slope at the corner is relatively safe",
     "P2 against Q2, both corners", corner_toe_safe},
    {conclusions, "the toe at the corner of the convex and concave subbases is relatively safe",
     "advance of the foot of the soil that lay above toe level: section P below Q, both corners",
     corner_front_safe},
    {conclusions, "for the two typical subbases the 3D effect becomes more apparent",
     "settlement of the tops less that of their 2D cases, mean: case 2 above case 1",
     more_apparent},
    {conclusions, "instability is more likely to occur at the top corner of the convex subbase",
     "convex: settlement of P1 above that of Q1 and the advance of P2", convex_top_unstable},
    {conclusions, "and at the side slope of the concave subbase",
     "concave: Q1 and Q2 above P1 and P2", concave_side_unstable},
    {case_2, "the normal stress on the P plane from each side has a different direction",
     "settled: angle between the greater horizontal pressures on both sides of P: over 10 degrees",
     sides_differ_in_direction},
    {case_2, "concave: the normal stresses help section P to remain steady; convex: the opposite",
     "settled: mean normal stress on section P against the 2D case of P", stresses_hold_concave},
    {case_2, "the Q plane will always fail first",
     "time until Q1 and P1 have moved 1 % of the height", q_fails_first},
    {case_2, "and then help the P plane to remain steady, even for the convex case",
     "settlement of P1 below the 2D case of P", q_helps_p},
    {case_2, "convex: failure of Q causes sinking of the top of P and prevents its further failure",
     "Q1 fails before P1, and the soil above the toe moves less in P than in Q",
     convex_top_sinks_by_q},
    {case_2, "it also causes cracks around the toe of the P plane",
     "convex: neighbours within 1.5 dx kept on the lower half of the face, 5 % quantile: P below "
     "0.9 "
     "of Q",
     cracks_at_corner_toe},
    {case_2, "which isolate the toe area and reduce the deformation",
     "convex: advance of P2 and of the foot of the slide below those of Q",
     cracks_reduce_deformation},
    {case_2, "the plastic area of the concave subbase in section P is triangular",
     "convex hull of the plastic zone over its rectangle along the face: below 7/12",
     concave_triangle},
    {case_2, "where the slide body is mainly composed of the lateral slide materials",
     "concave: of the slide that ends in section P more than half began over a spacing beside it",
     slide_from_beside},
    {case_2, "whereas it is quadrilateral for the convex subbase", "the same: above 2/3",
     convex_quadrilateral},
});

}  // namespace

void judge_corner_claims(CaseRun& run, const std::vector<ReadingOutcomes>& readings) {
  judge_claims(run, rows, readings);
}

}  // namespace scarp::validation
