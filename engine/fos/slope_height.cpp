// SPDX-License-Identifier: BSD-3-Clause
/// Tops of the bodies' columns, or of the particles where gravity is oblique.

#include "engine/fos/slope_height.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "engine/boundary/facet_geometry.hpp"
#include "engine/particles/shapes.hpp"
#include "engine/particles/soil_above.hpp"

namespace scarp {
namespace {

/// Points from `low` to `high`, both included, at most `step` apart.
std::vector<double> grid(double low, double high, double step) {
  const int pieces = std::max(1, static_cast<int>(std::ceil((high - low) / step - 1e-9)));
  std::vector<double> points;
  for (int k = 0; k <= pieces; ++k) points.push_back(low + (high - low) * k / pieces);
  return points;
}

/// The ground is where a particle has no more than a spacing of soil above it and no wall there:
/// what lies against a wall that hangs over, as every wall on the uphill side does, is none.
double oblique_height(const Scene& scene) {
  const Particles soil = generate_soil(scene);
  const std::vector<SoilAbove> above = soil_above(scene, soil, 1);
  const Vec3 up = upward(scene);
  const auto under_wall = [&](const Vec3& from, double reach) {
    const Vec3 beyond = geometry::plus(from, reach, up);
    return std::any_of(scene.walls.begin(), scene.walls.end(), [&](const Wall& wall) {
      return std::any_of(wall.facets.begin(), wall.facets.end(), [&](const Facet& facet) {
        return geometry::comes_out(facet, scene.dimension, beyond, from, 0.0);
      });
    });
  };
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (std::size_t i = 0; i < above.size(); ++i) {
    const double thickness = above[i].thickness;
    if (!(thickness <= scene.spacing)) continue;
    if (under_wall(soil.position[i], thickness + scene.spacing)) continue;
    const double top = geometry::dot(soil.position[i], up) + thickness;
    low = std::min(low, top);
    high = std::max(high, top);
  }
  return high > low ? high - low : 0.0;
}

}  // namespace

double slope_height(const Scene& scene) {
  const bool plane = scene.dimension == 2;
  const Vec3& g = scene.gravity;
  const bool down = plane ? g[0] == 0.0 && g[1] < 0.0 : g[0] == 0.0 && g[1] == 0.0 && g[2] < 0.0;
  if (!down) return oblique_height(scene);
  const std::vector<ColumnShape> shapes = column_shapes(scene);
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
