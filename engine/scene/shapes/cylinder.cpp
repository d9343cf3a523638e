// SPDX-License-Identifier: BSD-3-Clause
/// Discs and rings in 2D, upright cylinders and tubes in 3D.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "engine/scene/read_parts.hpp"
#include "engine/scene/shape_list.hpp"
#include "engine/scene/text_lines.hpp"
#include "engine/scene/validate_parts.hpp"

namespace scarp {
namespace {

const Cylinder& cylinder_of(const Body::Shape& shape) { return std::get<Cylinder>(shape); }

Body::Shape read(const input::Table&, const input::Value& value, int dimension) {
  using kernels::Unit;
  const input::Table table = value.table({"centre", "radius", "inner_radius", "height"});
  Cylinder cylinder;
  cylinder.centre = input::read_vector(
      table.require("centre", dimension == 2 ? "[0, 0]" : "[0, 0, 0]"), Unit::length, dimension);
  cylinder.radius = table.require("radius", "1.0").number(Unit::length);
  if (const auto inner = table.find("inner_radius")) {
    cylinder.inner_radius = inner->number(Unit::length);
  }
  if (dimension == 3) {
    cylinder.height = table.require("height", "1.0").number(Unit::length);
  } else if (const auto height = table.find("height")) {
    height->fail("a disc in 2D has no height. Try without it, or dimension = 3.");
  }
  return cylinder;
}

void check(const Body::Shape& shape, int dimension, const std::string& path) {
  using checks::inside, checks::largest_length;
  const Cylinder& cylinder = cylinder_of(shape);
  const std::string key = path + ".cylinder";
  checks::vector(cylinder.centre, dimension, largest_length, key + ".centre");
  inside(cylinder.radius, 1e-9, largest_length, key + ".radius");
  inside(cylinder.inner_radius, 0.0, largest_length, key + ".inner_radius");
  checks::rule(cylinder.inner_radius < cylinder.radius, key + ".inner_radius",
               fmt::format("{}", cylinder.inner_radius),
               "nothing is left of the ring. Try less than the radius.");
  if (dimension == 3) inside(cylinder.height, 1e-9, largest_length, key + ".height");
}

void write(const Body::Shape& shape, TextLines& lines) {
  const Cylinder& c = cylinder_of(shape);
  lines.add("cylinder.centre", c.centre);
  lines.add("cylinder.radius", c.radius);
  lines.add("cylinder.inner_radius", c.inner_radius);
  lines.add("cylinder.height", c.height);
}

ShapeExtent extent(const Body::Shape& shape, int dimension) {
  const Cylinder& c = cylinder_of(shape);
  const auto& [x, y, z] = c.centre;
  const double r = c.radius;
  return {{x - r, y - r, z}, {x + r, y + r, z + (dimension == 2 ? 0.0 : c.height)}};
}

std::string describe(const Body::Shape& shape, int dimension) {
  return from_to(dimension == 2 ? "disc" : "cylinder", extent(shape, dimension), dimension);
}

/// Along one axis of the plan, at `x` on the other one, on which the centre is at `middle`.
void cut_disc(const Cylinder& disc, double middle, double x, double centre, double tolerance,
              std::vector<Range>& out) {
  const double away = std::abs(x - middle);
  const auto half_chord = [&](double radius) {
    return radius > away ? std::sqrt((radius - away) * (radius + away)) : 0.0;
  };
  if (away > disc.radius + tolerance) return;
  const double outer = half_chord(disc.radius + tolerance);
  const double inner = half_chord(disc.inner_radius - tolerance);
  if (inner > 0.0) {
    out.push_back({centre - outer, centre - inner});
    out.push_back({centre + inner, centre + outer});
  } else {
    out.push_back({centre - outer, centre + outer});
  }
}

ShapeCut cut(const Body::Shape& shape, int, double tolerance, const std::string&) {
  return [c = &cylinder_of(shape), t = tolerance](std::size_t axis, const Vec3& at,
                                                  std::vector<Range>& out) {
    if (axis != 2) {
      const std::size_t other = 1 - axis;
      cut_disc(*c, c->centre[other], at[other], c->centre[axis], t, out);
      return;
    }
    const double radius = std::hypot(at[0] - c->centre[0], at[1] - c->centre[1]);
    if (!within(radius, c->inner_radius - t, c->radius + t)) return;
    out.push_back({c->centre[2], c->centre[2] + c->height});
  };
}

void corners(const Body::Shape& shape, int, std::size_t axis, std::vector<double>& out) {
  const Cylinder& c = cylinder_of(shape);
  const double centre = c.centre[axis], outer = c.radius, inner = c.inner_radius;
  if (axis == 2) {
    out.insert(out.end(), {centre, centre + c.height});
  } else {
    out.insert(out.end(), {centre - outer, centre - inner, centre + inner, centre + outer});
  }
}

double cost(const Body::Shape&) { return 5.0; }

}  // namespace

const ShapeRow cylinder_row{"cylinder", {},  read,  check, write,   describe,
                            extent,     cut, false, true,  corners, cost};

}  // namespace scarp
