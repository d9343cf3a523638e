// SPDX-License-Identifier: BSD-3-Clause
/// Tops of the bodies' columns.

#include "engine/fos/slope_height.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "engine/errors.hpp"
#include "engine/particles/shapes.hpp"

namespace scarp {
namespace {

/// Points from `low` to `high`, both included, at most `step` apart.
std::vector<double> grid(double low, double high, double step) {
  const int pieces = std::max(1, static_cast<int>(std::ceil((high - low) / step - 1e-9)));
  std::vector<double> points;
  for (int k = 0; k <= pieces; ++k) points.push_back(low + (high - low) * k / pieces);
  return points;
}

}  // namespace

double slope_height(const Scene& scene) {
  const bool plane = scene.dimension == 2;
  const Vec3& g = scene.gravity;
  const bool down = plane ? g[0] == 0.0 && g[1] < 0.0 : g[0] == 0.0 && g[1] == 0.0 && g[2] < 0.0;
  if (!down) {
    throw SceneError(
        "the height of the slope cannot be told: gravity is not straight down. Give --height.");
  }
  std::vector<ColumnShape> shapes;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) shapes.push_back(column_shape(scene, b));
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const ColumnShape& body : shapes) {
    const std::vector<double> across =
        plane ? std::vector<double>{0.0}
              : grid(body.minimum[1], body.maximum[1], 0.5 * scene.spacing);
    for (const double x : grid(body.minimum[0], body.maximum[0], 0.5 * scene.spacing)) {
      for (const double y : across) {
        // The ground is the top of whatever lies highest here.
        std::vector<Range> ranges;
        for (const ColumnShape& shape : shapes) {
          const bool over = x >= shape.minimum[0] && x <= shape.maximum[0] &&
                            (plane || (y >= shape.minimum[1] && y <= shape.maximum[1]));
          if (over) shape.column(x, y, ranges);
        }
        if (ranges.empty()) continue;
        const double top =
            std::max_element(ranges.begin(), ranges.end(), [](const Range& a, const Range& b) {
              return a.high < b.high;
            })->high;
        low = std::min(low, top);
        high = std::max(high, top);
      }
    }
  }
  return high > low ? high - low : 0.0;
}

}  // namespace scarp
