// SPDX-License-Identifier: BSD-3-Clause
/// Ranges of each shape along each axis, and who owns what of a line.
#include "engine/check/line_cuts.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace scarp {
namespace {

bool within(double value, double low, double high) { return value >= low && value <= high; }

/// Ranges of one shape along `axis` through `at`; a height field is left to its columns.
struct Cutter {
  int dimension;
  std::size_t axis;
  const Vec3& at;
  double tolerance;
  const std::vector<std::array<double, 2>>& turned;
  std::vector<Range>& out;

  void operator()(const Polygon& polygon) const {
    const std::size_t up = dimension == 2 ? 1 : 2;
    if (dimension == 3 && axis == 1) {
      std::vector<Range> heights;
      cut_polygon(polygon.points, at[0], tolerance, heights);
      const bool inside = std::any_of(heights.begin(), heights.end(), [&](const Range& range) {
        return within(at[2], range.low, range.high);
      });
      if (inside) out.push_back({polygon.extrude[0], polygon.extrude[1]});
      return;
    }
    if (dimension == 3 && !within(at[1], polygon.extrude[0], polygon.extrude[1])) return;
    if (axis == up) {
      cut_polygon(polygon.points, at[0], tolerance, out);
    } else {
      cut_polygon(turned, at[up], tolerance, out);
    }
  }

  void operator()(const Box& box) const {
    for (std::size_t a = 0; a < static_cast<std::size_t>(dimension); ++a) {
      if (a != axis && !within(at[a], box.minimum[a], box.maximum[a])) return;
    }
    out.push_back({box.minimum[axis], box.maximum[axis]});
  }

  void operator()(const Cylinder& cylinder) const {
    const auto& [x, y, z] = cylinder.centre;
    if (axis == 2) {
      const double radius = std::hypot(at[0] - x, at[1] - y);
      if (within(radius, cylinder.inner_radius, cylinder.radius))
        out.push_back({z, z + cylinder.height});
      return;
    }
    if (dimension == 3 && !within(at[2], z, z + cylinder.height)) return;
    if (axis == 1) {
      cut_disc(cylinder, at[0], tolerance, out);
      return;
    }
    Cylinder turned_disc = cylinder;
    std::swap(turned_disc.centre[0], turned_disc.centre[1]);
    cut_disc(turned_disc, at[1], tolerance, out);
  }

  void operator()(const HeightField&) const {}
};

/// Places along one axis where an outline turns.
struct Corners {
  int dimension;
  std::size_t axis;
  std::vector<double>& out;

  void operator()(const Polygon& polygon) const {
    if (dimension == 3 && axis == 1) {
      out.insert(out.end(), polygon.extrude.begin(), polygon.extrude.end());
      return;
    }
    for (const auto& point : polygon.points) out.push_back(point[axis == 0 ? 0 : 1]);
  }
  void operator()(const Box& box) const {
    out.push_back(box.minimum[axis]);
    out.push_back(box.maximum[axis]);
  }
  void operator()(const Cylinder& cylinder) const {
    const double centre = cylinder.centre[axis];
    if (axis == 2) {
      out.insert(out.end(), {centre, centre + cylinder.height});
      return;
    }
    const double outer = cylinder.radius, inner = cylinder.inner_radius;
    out.insert(out.end(), {centre - outer, centre - inner, centre + inner, centre + outer});
  }
  void operator()(const HeightField& field) const {
    if (axis < 2) out.insert(out.end(), {field.plan_minimum[axis], field.plan_maximum[axis]});
  }
};

}  // namespace

LineCuts::LineCuts(const Scene& scene) : scene_(scene) {
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    shapes_.push_back(column_shape(scene, b));
    materials_.push_back(static_cast<int>(material_of(scene, scene.bodies[b])));
    turned_.emplace_back();
    if (const auto* polygon = std::get_if<Polygon>(&scene.bodies[b].shape)) {
      for (const auto& [x, y] : polygon->points) turned_.back().push_back({y, x});
    }
    for (std::size_t a = 0; a < 3; ++a) {
      minimum_[a] = b == 0 ? shapes_[b].minimum[a] : std::min(minimum_[a], shapes_[b].minimum[a]);
      maximum_[a] = b == 0 ? shapes_[b].maximum[a] : std::max(maximum_[a], shapes_[b].maximum[a]);
    }
  }
}

bool LineCuts::knows(std::size_t axis) const {
  return axis == 2 || std::none_of(scene_.bodies.begin(), scene_.bodies.end(), [](const Body& b) {
           return std::holds_alternative<HeightField>(b.shape);
         });
}

std::vector<double> LineCuts::corners(std::size_t axis) const {
  std::vector<double> places;
  for (const Body& body : scene_.bodies)
    std::visit(Corners{scene_.dimension, axis, places}, body.shape);
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return places;
}

void LineCuts::ranges_of(std::size_t body, std::size_t axis, const Vec3& at,
                         std::vector<Range>& out) const {
  const ColumnShape& shape = shapes_[body];
  const std::size_t up = scene_.dimension == 2 ? 1 : 2;
  for (std::size_t a = 0; a < static_cast<std::size_t>(scene_.dimension); ++a) {
    const bool top_unknown =
        a == up && std::holds_alternative<HeightField>(scene_.bodies[body].shape);
    if (a != axis && !top_unknown && !within(at[a], shape.minimum[a], shape.maximum[a])) return;
  }
  if (std::holds_alternative<HeightField>(scene_.bodies[body].shape)) {
    if (axis == up) shape.column(at[0], at[1], out);
    return;
  }
  std::visit(Cutter{scene_.dimension, axis, at, shape.tolerance, turned_[body], out},
             scene_.bodies[body].shape);
}

std::vector<LinePiece> LineCuts::cut(std::size_t axis, const Vec3& at) const {
  std::vector<End> ends;
  std::vector<Range> ranges;
  for (std::size_t b = 0; b < shapes_.size(); ++b) {
    ranges.clear();
    ranges_of(b, axis, at, ranges);
    for (const Range& range : ranges) {
      if (!(range.high > range.low)) continue;
      ends.push_back({range.low, static_cast<int>(b), 1});
      ends.push_back({range.high, static_cast<int>(b), -1});
    }
  }
  std::sort(ends.begin(), ends.end(), [](const End& a, const End& b) { return a.place < b.place; });
  const double nothing = 1e-6 * scene_.spacing;  // bodies that share a face to round-off touch
  std::map<int, int> inside;                     // ranges of each body that hold the place
  std::vector<LinePiece> pieces;
  for (std::size_t k = 1; k < ends.size(); ++k) {
    const auto entry = inside.try_emplace(ends[k - 1].body, 0).first;
    entry->second += ends[k - 1].step;
    if (entry->second == 0) inside.erase(entry);
    if (ends[k].place - ends[k - 1].place <= nothing) continue;
    LinePiece piece{ends[k - 1].place, ends[k].place};
    if (!inside.empty()) {
      piece.body = inside.begin()->first;  // the first body owns the point
      piece.material = materials_[static_cast<std::size_t>(piece.body)];
    }
    if (!pieces.empty() && pieces.back().material == piece.material) {
      pieces.back().high = piece.high;
    } else {
      pieces.push_back(piece);
    }
  }
  return pieces;
}

}  // namespace scarp
