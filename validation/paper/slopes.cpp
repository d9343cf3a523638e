// SPDX-License-Identifier: BSD-3-Clause
/// Bodies, walls and probes of the five slopes.

#include "validation/paper/slopes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/scene/facets.hpp"

namespace scarp::validation {
namespace {

using Points = std::vector<std::array<double, 2>>;

double face_run_of(SlopeShape shape, double height) {
  return shape == SlopeShape::plane_35 ? std::numbers::sqrt2 * height : height;
}

}  // namespace

Slope3d::Slope3d(SlopeShape shape, const SlopeSize& size)
    : shape_(shape),
      size_(size),
      run_(face_run_of(shape, size.height)),
      length_(size.crest + run_ + size.toe) {}

double Slope3d::width() const { return plane() ? 0.0 : corner() ? length_ : size_.half_width; }

double Slope3d::distance(double x, double y) const {
  switch (shape_) {
    case SlopeShape::concave:
      return length_ - std::hypot(length_ - x, y);
    case SlopeShape::convex:
      return std::hypot(x, y);
    case SlopeShape::concave_corner:
      return std::min(x, y);
    case SlopeShape::convex_corner:
      return std::max(x, y);
    default:
      return x;
  }
}

double Slope3d::surface(double distance) const {
  return top() - size_.height * std::clamp((distance - size_.crest) / run_, 0.0, 1.0);
}

double Slope3d::lateral_section() const {
  return shape_ == SlopeShape::concave_corner ? length_ - 0.5 * size_.crest : 0.5 * size_.crest;
}

Scene Slope3d::scene(Scene scene) const {
  const double crest = size_.crest, toe = crest + run_, low = size_.foundation, high = top();
  const double above = high + 0.25 * size_.height;  // walls: soil may be pushed up against them
  Body& body = scene.bodies.front();
  scene.bodies.resize(1);
  scene.title = words(shape_) + " slope, strength cut by 1.4";
  Wall rigid{"rigid", WallKind::no_slip, {}, {}, {}, {}};
  scene.walls.clear();
  scene.probes.clear();
  if (plane()) {
    scene.dimension = 2;
    scene.gravity = {0.0, scene.gravity[2], 0.0};
    body.shape = Polygon{
        Points{{0, 0}, {length_, 0}, {length_, low}, {toe, low}, {crest, high}, {0, high}}, {}};
    rigid.facets = line_facets({{0, above}, {0, 0}, {length_, 0}, {length_, above}});
    scene.probes = {{"crest", {crest, high, 0}}, {"toe", {toe, low, 0}}};
    scene.walls = {rigid};
    return scene;
  }
  HeightField field;
  field.plan_maximum = {length_, width()};
  const Points downhill{{crest, high}, {toe, low}};
  if (corner()) {
    field.kind = HeightField::Kind::expression;
    field.expression = fmt::format("min({}, max({}, {} - {}(x, y)))", high, low, high + crest,
                                   shape_ == SlopeShape::convex_corner ? "max" : "min");
  } else if (shape_ == SlopeShape::straight) {
    field.kind = HeightField::Kind::x_profile;
    field.profile = downhill;
  } else {
    field.kind = HeightField::Kind::radial_profile;
    const bool convex = shape_ == SlopeShape::convex;
    field.centre = {convex ? 0.0 : length_, 0.0};
    field.profile = convex ? downhill : Points{{length_ - toe, low}, {length_ - crest, high}};
  }
  body.shape = field;
  const Box room{{0, 0, 0}, {length_, width(), above}};
  if (corner()) {
    rigid.facets = box_facets(room, {"+z"}, 3);
    scene.walls = {rigid};
    const double q = lateral_section();
    scene.probes = {{"P1", {crest, crest, high}},
                    {"P2", {toe, toe, low}},
                    {"Q1", {crest, q, high}},
                    {"Q2", {toe, q, low}}};
    return scene;
  }
  rigid.facets = box_facets(room, {"+z", "-y"}, 3);
  Wall symmetry{"section M", WallKind::free_slip, {}, {}, {}, {}};
  symmetry.facets = {rectangle_facet({0, 0, 0}, {0, 0, above}, {length_, 0, 0})};
  scene.walls = {rigid, symmetry};
  scene.probes = {{"M1", {crest, 0, high}}, {"M2", {toe, 0, low}}};
  return scene;
}

std::string words(SlopeShape shape) {
  constexpr std::array names{"concave",       "straight",        "convex",         "concave corner",
                             "convex corner", "plane 45 degree", "plane 35 degree"};
  return names[static_cast<std::size_t>(shape)];
}

}  // namespace scarp::validation
