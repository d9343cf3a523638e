// SPDX-License-Identifier: BSD-3-Clause
/// Column cuts of polygon, box, cylinder and height field.
#include "engine/particles/shapes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "engine/errors.hpp"
#include "engine/scene/expression.hpp"

namespace scarp {
namespace {

constexpr double largest_height = 1e9;  // [m] as for every length of a scene

bool within(double value, double low, double high) { return value >= low && value <= high; }

/// Linear between the points of a profile, constant beyond its ends.
double profile_height(const std::vector<std::array<double, 2>>& profile, double distance) {
  const auto next =
      std::upper_bound(profile.begin(), profile.end(), distance,
                       [](double value, const auto& point) { return value < point[0]; });
  if (next == profile.begin()) return profile.front()[1];
  if (next == profile.end()) return profile.back()[1];
  const auto& [a, low] = *(next - 1);
  const auto& [b, high] = *next;
  return low + (high - low) * (distance - a) / (b - a);
}

using HeightFunction = std::function<double(double, double)>;

HeightFunction expression_height(const std::string& text, const std::string& label) {
  const auto fail = [label, text](const ExpressionError& error) {
    throw SceneError(fmt::format("{}: expression \"{}\" {} Try an expression of x and y.", label,
                                 text, error.what()));
  };
  try {
    return [expression = Expression(text, "xy"), fail](double x, double y) {
      try {
        return expression({x, y, 0.0});
      } catch (const ExpressionError& error) {
        fail(error);
      }
      return 0.0;
    };
  } catch (const ExpressionError& error) {
    fail(error);
  }
  return {};
}

HeightFunction height_function(const HeightField& field, const std::string& label) {
  const auto* f = &field;
  switch (field.kind) {
    case HeightField::Kind::x_profile:
      return [f](double x, double) { return profile_height(f->profile, x); };
    case HeightField::Kind::y_profile:
      return [f](double, double y) { return profile_height(f->profile, y); };
    case HeightField::Kind::radial_profile:
      return [f](double x, double y) {
        return profile_height(f->profile, std::hypot(x - f->centre[0], y - f->centre[1]));
      };
    case HeightField::Kind::expression:
      break;
  }
  return expression_height(field.expression, label);
}

/// Fills a ColumnShape from one alternative of Body::shape.
struct Builder {
  int dimension;
  double spacing;
  std::string start;  // of a message
  ColumnShape shape{};

  void bound(const std::string& what, const Vec3& minimum, const Vec3& maximum) {
    shape.minimum = minimum;
    shape.maximum = maximum;
    shape.label = fmt::format("{}{} from {} to {}", start, what, point_text(minimum, dimension),
                              point_text(maximum, dimension));
    // A billionth of a spacing, or more where coordinates are so large that round-off is more.
    shape.tolerance = 1e-9 * spacing;
    for (std::size_t a = 0; a < 3; ++a) {
      const double largest = std::max(std::abs(minimum[a]), std::abs(maximum[a]));
      shape.tolerance = std::max(shape.tolerance, 16 * 2.2e-16 * largest);
    }
  }

  void operator()(const Polygon& polygon) {
    double low[2] = {polygon.points[0][0], polygon.points[0][1]}, high[2] = {low[0], low[1]};
    for (const auto& point : polygon.points) {
      for (std::size_t a = 0; a < 2; ++a) {
        low[a] = std::min(low[a], point[a]);
        high[a] = std::max(high[a], point[a]);
      }
    }
    if (dimension == 2) {
      bound("polygon", {low[0], low[1], 0.0}, {high[0], high[1], 0.0});
    } else {
      bound("polygon", {low[0], polygon.extrude[0], low[1]},
            {high[0], polygon.extrude[1], high[1]});
    }
    shape.column = [p = &polygon, t = shape.tolerance](double x, double, std::vector<Range>& out) {
      cut_polygon(p->points, x, t, out);
    };
  }

  void operator()(const Box& box) {
    bound("box", box.minimum, box.maximum);
    const std::size_t up = dimension == 2 ? 1 : 2;
    shape.column = [b = &box, up](double, double, std::vector<Range>& out) {
      out.push_back({b->minimum[up], b->maximum[up]});
    };
  }

  void operator()(const Cylinder& cylinder) {
    const auto& [x, y, z] = cylinder.centre;
    const double r = cylinder.radius;
    bound(dimension == 2 ? "disc" : "cylinder", {x - r, y - r, z},
          {x + r, y + r, z + (dimension == 2 ? 0.0 : cylinder.height)});
    const double t = shape.tolerance;
    if (dimension == 2) {
      shape.column = [c = &cylinder, t](double at, double, std::vector<Range>& out) {
        cut_disc(*c, at, t, out);
      };
      return;
    }
    shape.column = [c = &cylinder, t](double at_x, double at_y, std::vector<Range>& out) {
      const double radius = std::hypot(at_x - c->centre[0], at_y - c->centre[1]);
      if (!within(radius, c->inner_radius - t, c->radius + t)) return;
      out.push_back({c->centre[2], c->centre[2] + c->height});
    };
  }

  void operator()(const HeightField& field) {
    const auto& [x0, y0] = field.plan_minimum;
    const auto& [x1, y1] = field.plan_maximum;
    bound("height field", {x0, y0, field.base}, {x1, y1, field.base});
    shape.label = fmt::format("{}height field over x {} to {}, y {} to {}, base {}", start, x0, x1,
                              y0, y1, field.base);
    shape.column = [base = field.base, label = shape.label,
                    height = height_function(field, shape.label)](double x, double y,
                                                                  std::vector<Range>& out) {
      const double top = height(x, y);
      if (!(std::abs(top) <= largest_height)) {
        throw SceneError(
            fmt::format("{}: the height at x = {:.9g}, y = {:.9g} is {}: not a finite length "
                        "below {} m. Try a profile or expression that is finite on the whole plan.",
                        label, x, y, top, largest_height));
      }
      if (top > base) out.push_back({base, top});
    };
  }
};

}  // namespace

std::string point_text(const Vec3& point, int dimension) {
  if (dimension == 2) return fmt::format("({:.9g}, {:.9g})", point[0], point[1]);
  return fmt::format("({:.9g}, {:.9g}, {:.9g})", point[0], point[1], point[2]);
}

ColumnShape column_shape(const Scene& scene, std::size_t index) {
  const Body& body = scene.bodies[index];
  Builder builder{scene.dimension, scene.spacing, message_start(scene, body)};
  std::visit(builder, body.shape);
  return std::move(builder.shape);
}

}  // namespace scarp
