// SPDX-License-Identifier: BSD-3-Clause
/// Outlines in a plane, cut along a line.
#pragma once

#include <array>
#include <vector>

#include "engine/scene/scene.hpp"

namespace scarp {

struct Range {
  double low = 0.0;
  double high = 0.0;
};

/// Ranges of y inside the outline at `x`, appended in any order, overlaps allowed. Parity of
/// crossings decides the inside; every edge adds the points that lie on it to `tolerance`.
void cut_polygon(const std::vector<std::array<double, 2>>& points, double x, double tolerance,
                 std::vector<Range>& out);

/// Ranges of y inside the disc or ring at `x`.
void cut_disc(const Cylinder& disc, double x, double tolerance, std::vector<Range>& out);

}  // namespace scarp
