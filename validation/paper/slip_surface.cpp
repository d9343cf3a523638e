// SPDX-License-Identifier: BSD-3-Clause
/// Depth of slides from their grains.

#include "validation/paper/slip_surface.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace scarp::validation {
namespace {

double ground(const Slope3d& slope, double x, double y) {
  return slope.surface(slope.distance(x, y));
}

/// Mean vertical thickness of the slide over three by three columns of particles around a place in
/// plan [m]: one column alone would tell it to a whole spacing.
double slide_depth(const std::vector<Grain>& grains, const Slope3d& slope, double spacing, double x,
                   double y) {
  double number = 0.0;
  for (const Grain& grain : grains) {
    number += slides(grain, slope) && std::fabs(grain.start[0] - x) < 1.5 * spacing &&
              std::fabs(grain.start[1] - y) < 1.5 * spacing;
  }
  return number * spacing / 9.0;
}

/// x at which the middle of the face of a case 1 slope passes y.
double middle_of_face(const Slope3d& slope, double y) {
  const double d = slope.size().crest + 0.5 * slope.face_run();
  if (slope.shape() == SlopeShape::straight) return d;
  const double r = slope.shape() == SlopeShape::convex ? d : slope.length() - d;
  const double x = std::sqrt(std::max(r * r - y * y, 0.0));
  return slope.shape() == SlopeShape::convex ? x : slope.length() - x;
}

}  // namespace

void measure_slip_surface(const std::vector<Grain>& grains, const Slope3d& slope, double spacing,
                          Outcome& outcome) {
  const auto depth = [&](double x, double y) { return slide_depth(grains, slope, spacing, x, y); };
  const auto put = [&](const char* where, double value) {
    outcome.values[fmt::format("slide depth {} [m]", where)] = value;
  };
  if (!slope.corner()) {
    const double width = slope.size().half_width;
    const auto at = [&](double y) { return depth(middle_of_face(slope, y), y); };
    put("at M", at(1.5 * spacing));
    put("between", at(0.5 * width));
    put("at side", at(width - 1.5 * spacing));
    return;
  }
  const double c = slope.size().crest + 0.5 * slope.face_run();
  const double t = 0.5 * slope.size().height / std::numbers::sqrt2;
  const double at_p = depth(c, c), beside = 0.5 * (depth(c + t, c - t) + depth(c - t, c + t));
  const double rise =
      0.5 * (ground(slope, c + t, c - t) + ground(slope, c - t, c + t)) - ground(slope, c, c);
  put("at P", at_p);
  put("beside P", beside);
  put("at Q", depth(c, slope.lateral_section()));
  outcome.values["ground beside P above that at P [m]"] = rise;
  outcome.values["slip surface beside P above that at P [m]"] = rise - beside + at_p;
}

}  // namespace scarp::validation
