// SPDX-License-Identifier: BSD-3-Clause
/// A slope in the words of the trade, made into an outline.
#include <cmath>

#include <fmt/format.h>

#include "engine/scene/read_parts.hpp"

namespace scarp::input {
namespace {

using kernels::Unit;
using Points = std::vector<std::array<double, 2>>;

double length_of(const Value& value, bool above_zero) {
  const double length = value.number(Unit::length);
  if (above_zero && !(length > 0.0)) value.fail("it is not above 0. Try a length above 0.");
  if (!(length >= 0.0)) value.fail("it is below 0. Try 0 or more.");
  return length;
}

double optional_length(const Table& slope, std::string_view key, double otherwise,
                       bool above_zero) {
  const auto value = slope.find(key);
  return value ? length_of(*value, above_zero) : otherwise;
}

/// Horizontal length of the face for a height of 1.
double run_of(const Table& slope) {
  if (slope.require_one_of({"ratio", "angle"}) == "ratio") {
    const Value value = slope.require("ratio", "2");
    const double ratio = value.number(Unit::none);
    if (!(ratio >= 0.0 && ratio <= 100.0))
      value.fail(
          "it is the horizontal length for 1 of height, 0 to 100. Try 2 for a slope of 1 : 2.");
    return ratio;
  }
  const Value value = slope.require("angle", "\"30 deg\"");
  const double angle = value.number(Unit::angle);
  if (!(angle > 0.005 && angle <= kernels::right_angle * (1.0 + 1e-12)))
    value.fail("a face rises by 0.3 to 90 degrees. Try \"30 deg\".");
  return std::fmax(0.0, std::cos(angle) / std::sin(angle));
}

/// Height above the toe and width of each level step, from the toe up.
Points berms_of(const Table& slope, double height) {
  const auto value = slope.find("berms");
  if (!value) return {};
  Points berms = read_pairs(*value, 1);
  double below = 0.0;
  for (const auto& [at, width] : berms) {
    if (!(at > below && at < height) || !(width > 0.0)) {
      value->fail(
          fmt::format("the berm [{:.9g}, {:.9g}] is out of place: each is [height above the "
                      "toe, width], heights rise from above 0 to below {:.9g}, widths are "
                      "above 0. Try [[{:.9g}, 2]].",
                      at, width, height, 0.5 * height));
    }
    below = at;
  }
  return berms;
}

}  // namespace

Points slope_outline(const Value& value) {
  const Table slope = value.table(
      {"toe", "height", "ratio", "angle", "crest", "ground", "depth", "berms", "faces"});
  const std::vector<double> toe = slope.require("toe", "[30, 5]").numbers(Unit::length, 2);
  const double height = length_of(slope.require("height", "10"), true);
  const double run = run_of(slope);
  const double crest = optional_length(slope, "crest", 2.0 * height, true);
  const double ground = optional_length(slope, "ground", 2.0 * height, false);
  const double depth = optional_length(slope, "depth", height, false);
  if (depth == 0.0 && ground > 0.0)
    slope.fail("the ground before the toe has no depth. Try ground = 0, or depth = 2.");

  // As if it fell towards +x, from the lower left corner round against the clock.
  Points face{{toe[0], toe[1]}};
  double x = toe[0], y = 0.0;
  const auto rise_to = [&](double level) {
    x -= run * (level - y);
    y = level;
    face.push_back({x, toe[1] + y});
  };
  for (const auto& [at, width] : berms_of(slope, height)) {
    rise_to(at);
    x -= width;
    face.push_back({x, toe[1] + y});
  }
  rise_to(height);
  const double back = x - crest, front = toe[0] + ground, bottom = toe[1] - depth;
  Points outline{{back, bottom}};
  if (depth > 0.0) outline.push_back({front, bottom});
  if (ground > 0.0) outline.push_back({front, toe[1]});
  outline.insert(outline.end(), face.begin(), face.end());
  outline.push_back({back, toe[1] + height});
  const auto faces = slope.find("faces");
  if (faces && faces->choice("+x|-x") == 1) {
    for (auto& point : outline) point[0] = 2.0 * toe[0] - point[0];
  }
  return outline;
}

}  // namespace scarp::input
