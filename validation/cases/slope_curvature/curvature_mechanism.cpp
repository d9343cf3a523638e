// SPDX-License-Identifier: BSD-3-Clause
/// Findings on stresses and failure.

#include "validation/cases/slope_curvature/curvature_mechanism.hpp"

namespace scarp::validation {
namespace {

/// The stresses are causes: they are judged before the slope fails.
constexpr const char* across = "section M: across, settled [Pa]";
constexpr const char* along = "section M: along, settled [Pa]";
constexpr const char* vertical = "section M: vertical, settled [Pa]";

std::string stress_text(const ReadingOutcomes& all) {
  return text(three(all, across), "kPa", 1e-3) + "; at the end " +
         text(three(all, "section M: across, at the end [Pa]"), "kPa", 1e-3);
}

/// Horizontal stress on section M over that at the rough side.
Three arch_of(const ReadingOutcomes& all) {
  Three t = three(all, along);
  const Three side = three(all, "side: downhill, settled [Pa]");
  for (std::size_t k = 0; k < 3; ++k) t[k] /= side[k];
  return t;
}

}  // namespace

Finding planar_stress_similar(const ReadingOutcomes& all) {
  const Three level = three(all, along), plumb = three(all, vertical);
  return finding(
      level, std::min(least_share(level), least_share(plumb)) > 1.0 - similar,
      "horizontal " + text(level, "kPa", 1e-3) + "; vertical " + text(plumb, "kPa", 1e-3));
}

Finding normal_stress_differs(const ReadingOutcomes& all) {
  const Three t = three(all, across);
  return finding(t, least_share(t) * much < 1.0, stress_text(all));
}

Finding concave_lateral_stress(const ReadingOutcomes& all) {
  const Three t = three(all, across);
  return finding(t, t[0] > std::max(t[1], t[2]), stress_text(all));
}

Finding extra_confining_pressure(const ReadingOutcomes& all) {
  const double concave = all.of(Shape::concave).at(across),
               plane = all.of(Shape::plane_45).at("section: across, settled [Pa]");
  return {if_measured({concave, plane}, concave > plane),
          fmt::format("concave {:.3g}, 2D {:.3g} kPa", 1e-3 * concave, 1e-3 * plane)};
}

Finding arch(const ReadingOutcomes& all) {
  const Three t = arch_of(all);
  return finding(t, t[0] < 1.0 && t[0] < t[2], text(t, "of the stress at the side"));
}

Finding convex_the_opposite(const ReadingOutcomes& all) {
  const Three stress = three(all, across), t = arch_of(all);
  return {if_measured({stress[0], stress[1], stress[2], t[0], t[1], t[2]},
                      falling(stress) && rising(t)),
          "on M " + text(stress, "kPa", 1e-3) + "; arch " + text(t, "of the stress at the side")};
}

Finding failure_delayed(const ReadingOutcomes& all) {
  const Three t{failed_after(all.of(Shape::concave), "M1"),
                failed_after(all.of(Shape::straight), "M1"),
                failed_after(all.of(Shape::convex), "M1")};
  return finding(t, falling(t), text(t, "s (inf: never)"));
}

Finding shear_zone_larger(const ReadingOutcomes& all) {
  const Three t = three(all, "section M: plastic area [m2]");
  return finding(t, t[0] * much < t[2], text(t, "m2"));
}

Finding three_stresses(const ReadingOutcomes& all) {
  const Three x = three(all, along), y = three(all, across), z = three(all, vertical);
  bool differ = true;
  for (std::size_t k = 0; k < 3; ++k) {
    Three sorted{x[k], y[k], z[k]};
    std::sort(sorted.begin(), sorted.end());
    differ &= 1.1 * sorted[0] < sorted[1] && 1.1 * sorted[1] < sorted[2];
  }
  return {if_measured({x[0], x[1], x[2], y[0], y[1], y[2], z[0], z[1], z[2]}, differ),
          "along M " + text(x, "kPa", 1e-3) + "; across " + text(y, "kPa", 1e-3) + "; vertical " +
              text(z, "kPa", 1e-3)};
}

Finding related_to_lateral_stress(const ReadingOutcomes& all) {
  const Three stress = three(all, across), top = three(all, "M1: settlement [m]");
  bool opposite = true;
  for (std::size_t a = 0; a < 3; ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      opposite &= (stress[a] - stress[b]) * (top[a] - top[b]) < 0.0;
    }
  }
  return {if_measured({stress[0], stress[1], stress[2], top[0], top[1], top[2]}, opposite),
          text(stress, "kPa", 1e-3) + "; top " + text(top, "m")};
}

}  // namespace scarp::validation
