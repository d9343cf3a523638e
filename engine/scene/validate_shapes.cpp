// SPDX-License-Identifier: BSD-3-Clause
/// Rules about the shapes of bodies and walls.
#include <fmt/format.h>

#include <cmath>

#include "engine/scene/expression.hpp"
#include "engine/scene/scene_problem.hpp"
#include "engine/scene/shape_list.hpp"
#include "engine/scene/validate_parts.hpp"
#include "engine/scene/vector.hpp"

namespace scarp::checks {
namespace {

using geometry::dot;

constexpr double degree = 3.14159265358979323846 / 180.0;

}  // namespace

void rule(bool holds, const std::string& path, const std::string& value, const std::string& why) {
  if (!holds) throw SceneProblem(path, value, why);
}

void inside(double value, double minimum, double maximum, const std::string& path) {
  rule(std::isfinite(value), path, fmt::format("{}", value),
       "it is not a finite number. Try a finite one.");
  rule(value >= minimum && value <= maximum, path, fmt::format("{}", value),
       fmt::format("it is outside {} to {}. Try a value inside.", minimum, maximum));
}

void positive(double value, double maximum, const std::string& path) {
  inside(value, 0.0, maximum, path);
  rule(value > 0.0, path, "0", "it is 0. Try a value above 0, or none at all.");
}

void inside_degrees(double value, double minimum, double maximum, const std::string& path) {
  rule(std::isfinite(value) && value >= minimum && value <= maximum, path,
       fmt::format("{} rad", value),
       fmt::format("it is outside {:.4g} to {:.4g} deg. Try a value inside.", minimum / degree,
                   maximum / degree));
}

void vector(const Vec3& value, int dimension, double largest, const std::string& path) {
  for (const double component : value) inside(component, -largest, largest, path);
  rule(dimension == 3 || value[2] == 0.0, path, fmt::format("[.., .., {}]", value[2]),
       "2D has no z. Try z = 0, or dimension = 3.");
}

void point(const std::array<double, 2>& p, const std::string& path) {
  for (const double x : p) inside(x, -largest_length, largest_length, path);
}

void ordered(double low, double high, const std::string& path) {
  rule(high > low, path, fmt::format("[{}, {}]", low, high),
       "the second is not above the first. Try the smaller one first.");
}

void formula(const std::string& text, const std::string& variables, const std::vector<Vec3>& places,
             const std::string& key) {
  rule(!text.empty() && text.size() <= 1000, key, fmt::format("{} letters", text.size()),
       "an expression has 1 to 1000 letters. Try a shorter one.");
  try {
    const Expression value(text, variables);
    for (const Vec3& place : places) {
      rule(std::isfinite(value(place)), key, '"' + text + '"',
           fmt::format("the height at x = {}, y = {} is not finite. Try one that is finite on the "
                       "whole plan.",
                       place[0], place[1]));
    }
  } catch (const ExpressionError& error) {
    throw SceneProblem(
        key, '"' + text + '"',
        fmt::format("{} Try an expression of {}.", error.what(),
                    variables == "xy" ? "x and y" : "x, y and z in metres, such as \"-2*y\""));
  }
}

void body(const Scene& scene, std::size_t index, const std::string& path) {
  const Body& body = scene.bodies[index];
  material_of(scene, body);
  row_of(body.shape).check(body.shape, scene.dimension, path);
  vector(body.velocity, scene.dimension, 1e6, path + ".velocity");
  rule(body.velocity_field.empty() ||
           body.velocity_field.size() == static_cast<std::size_t>(scene.dimension),
       path + ".velocity_field", fmt::format("{} expressions", body.velocity_field.size()),
       "each direction needs one. Try [\"-2*y\", \"2*x\"] in 2D.");
  for (std::size_t a = 0; a < body.velocity_field.size(); ++a) {
    formula(body.velocity_field[a], "xyz", {}, fmt::format("{}.velocity_field[{}]", path, a));
  }
}

void wall(const Wall& wall, int dimension, const std::string& path) {
  rule(!wall.facets.empty(), path + ".facets", "none", "the wall has no shape. Try one facet.");
  constexpr double tolerance =
      1e-9;  // far above round-off of a normalised vector, far below a typing error
  for (std::size_t f = 0; f < wall.facets.size(); ++f) {
    const Facet& facet = wall.facets[f];
    const std::string key = fmt::format("{}.facets[{}]", path, f);
    vector(facet.origin, dimension, largest_length, key + ".origin");
    vector(facet.normal, dimension, 2.0, key + ".normal");
    vector(facet.tangent_u, dimension, 2.0, key + ".tangent_u");
    inside(facet.length_u, 1e-9, largest_length, key + ".length_u");
    if (dimension == 3) inside(facet.length_v, 1e-9, largest_length, key + ".length_v");
    const auto off = [](double value, double wanted) {
      return !(std::abs(value - wanted) < tolerance);
    };
    rule(!off(dot(facet.normal, facet.normal), 1.0), key + ".normal", "...",
         "it is no unit vector. Try to normalise it.");
    rule(!off(dot(facet.tangent_u, facet.tangent_u), 1.0), key + ".tangent_u", "...",
         "it is no unit vector. Try to normalise it.");
    rule(!off(dot(facet.normal, facet.tangent_u), 0.0), key + ".normal", "...",
         "it does not stand on the facet. Try u x v.");
    if (dimension == 2) continue;
    vector(facet.tangent_v, 3, 2.0, key + ".tangent_v");
    rule(!off(dot(facet.tangent_v, facet.tangent_v), 1.0), key + ".tangent_v", "...",
         "it is no unit vector. Try to normalise it.");
    rule(!off(dot(facet.normal, facet.tangent_v), 0.0), key + ".normal", "...",
         "it does not stand on the facet. Try u x v.");
    rule(!off(dot(facet.tangent_u, facet.tangent_v), 0.0), key + ".tangent_v", "...",
         "it is not at right angles to tangent_u. Try a rectangle.");
  }
  vector(wall.velocity, dimension, 1e6, path + ".motion.velocity");
}

}  // namespace scarp::checks
