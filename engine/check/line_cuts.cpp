// SPDX-License-Identifier: BSD-3-Clause
/// Ranges of each shape along each axis, and who owns what of a line.
#include "engine/check/line_cuts.hpp"

#include <algorithm>
#include <map>

namespace scarp {
LineCuts::LineCuts(const Scene& scene) : scene_(scene), shapes_(column_shapes(scene)) {
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    materials_.push_back(static_cast<int>(material_of(scene, scene.bodies[b])));
    for (std::size_t a = 0; a < 3; ++a) {
      minimum_[a] = b == 0 ? shapes_[b].minimum[a] : std::min(minimum_[a], shapes_[b].minimum[a]);
      maximum_[a] = b == 0 ? shapes_[b].maximum[a] : std::max(maximum_[a], shapes_[b].maximum[a]);
    }
  }
}

bool LineCuts::knows(std::size_t axis) const {
  return axis == 2 || std::none_of(scene_.bodies.begin(), scene_.bodies.end(),
                                   [](const Body& b) { return row_of(b.shape).only_vertical; });
}

std::vector<double> LineCuts::corners(std::size_t axis) const {
  std::vector<double> places;
  for (const Body& body : scene_.bodies)
    row_of(body.shape).corners(body.shape, scene_.dimension, axis, places);
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return places;
}

void LineCuts::ranges_of(std::size_t body, std::size_t axis, const Vec3& at,
                         std::vector<Range>& out) const {
  const ColumnShape& shape = shapes_[body];
  const bool only_vertical = row_of(scene_.bodies[body].shape).only_vertical;
  for (std::size_t a = 0; a < static_cast<std::size_t>(scene_.dimension); ++a) {
    const bool top_unknown = a == shape.up && only_vertical;
    if (a != axis && !top_unknown && !within(at[a], shape.minimum[a], shape.maximum[a])) return;
  }
  shape.cut(axis, at, out);
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
