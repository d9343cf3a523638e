// SPDX-License-Identifier: BSD-3-Clause
/// Findings about soil that is too soft or cannot yield, and numerics known not to work together.
#include "engine/scene/warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/boundary/wall_gaps.hpp"
#include "kernels/constitutive/list.hpp"

namespace scarp {
namespace {

using kernels::DruckerPrager;

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  void take(double x) {
    low = std::min(low, x);
    high = std::max(high, x);
  }
};

/// Extent of a body along one axis [m]; a height given by an expression is not known here and
/// counts as 0.
struct Extent {
  std::size_t axis;
  int dimension;

  Range operator()(const Polygon& polygon) const {
    Range range;
    const bool across = dimension == 3 && axis == 1;
    for (const auto& p : polygon.points) range.take(p[axis == 0 ? 0 : 1]);
    return across ? Range{polygon.extrude[0], polygon.extrude[1]} : range;
  }
  Range operator()(const Box& box) const { return {box.minimum[axis], box.maximum[axis]}; }
  Range operator()(const Cylinder& cylinder) const {
    const double centre = cylinder.centre[axis];
    if (axis == 2) return {centre, centre + cylinder.height};
    return {centre - cylinder.radius, centre + cylinder.radius};
  }
  Range operator()(const HeightField& field) const {
    if (axis != 2) return {field.plan_minimum[axis], field.plan_maximum[axis]};
    Range range{field.base, field.base};
    for (const auto& p : field.profile) range.take(p[1]);
    return range;
  }
};

std::string degrees(double angle) {
  return fmt::format("{:.4g} deg", angle * 45.0 / std::atan(1.0));
}

void check_cone(const Scene& scene, const Material& material, std::vector<std::string>& found) {
  if (material.model != DruckerPrager::name) return;
  const auto& p = material.parameters;
  const double phi = p[DruckerPrager::friction_angle];
  const auto cone = static_cast<kernels::Cone>(static_cast<int>(p[DruckerPrager::cone]));
  if (scene.dimension == 2 && cone == kernels::Cone::outer) {
    const double alpha = DruckerPrager::cone_constants(0.0, phi, 0.0, cone).alpha_phi;
    if (3.0 * alpha >= 1.0) {
      found.push_back(
          fmt::format("material '{}': with cone = \"outer\" and a friction angle of {} the soil "
                      "never yields in "
                      "plane strain. Try cone = \"plane_strain\", or less than 42.2 deg.",
                      material.name, degrees(phi)));
    }
  }
  if (p[DruckerPrager::cohesion] == 0.0 && phi == 0.0) {
    found.push_back(fmt::format(
        "material '{}': cohesion and friction angle are 0, so it has no strength at all.",
        material.name));
  }
}

bool has_body(const Scene& scene, std::size_t material) {
  return std::any_of(scene.bodies.begin(), scene.bodies.end(),
                     [material](const Body& body) { return body.material == material; });
}

double constrained_modulus(const Material& material) {
  // Both indices are 0 and 1 in every model: elasticity comes first.
  return kernels::elastic_moduli(material.parameters[0], material.parameters[1]).wave_modulus();
}

/// Settlement under its own weight, gamma H / (2 M) of the height H; M is the constrained modulus.
void check_settlement(const Scene& scene, std::vector<std::string>& found) {
  const auto larger = [](double a, double b) { return std::abs(a) < std::abs(b); };
  const auto steepest = std::max_element(scene.gravity.begin(), scene.gravity.end(), larger);
  const Extent extent{static_cast<std::size_t>(steepest - scene.gravity.begin()), scene.dimension};
  for (std::size_t m = 0; m < scene.materials.size(); ++m) {
    Range range;
    for (const Body& body : scene.bodies) {
      if (body.material != m) continue;
      const Range own = std::visit(extent, body.shape);
      range.take(own.low);
      range.take(own.high);
    }
    const Material& material = scene.materials[m];
    const double e = material.parameters[0], modulus = constrained_modulus(material);
    const double height = range.high - range.low;
    const double share = material.density * std::abs(*steepest) * height / (2.0 * modulus);
    if (!(height > 0.0) || !(share > 0.1)) continue;
    found.push_back(fmt::format(
        "material '{}': with E = {:.4g} Pa a body {:.4g} m high settles by about {:.0f} % of its "
        "height under its own weight. Is E in the right unit (kPa, MPa)? Try a stiffer soil.",
        material.name, e, height, 100.0 * share));
  }
}

/// The stiffest material sets the step for all. Where it only carries, a hundred times the
/// stiffness of the softest will do: under the same stress it strains a hundredth as much.
void check_contrast(const Scene& scene, std::vector<std::string>& found) {
  constexpr double much = 1000.0, enough = 100.0;
  const Material *soft = nullptr, *fast = nullptr;
  const auto sound = [](const Material& m) {
    return std::sqrt(constrained_modulus(m) / m.density);
  };
  for (std::size_t m = 0; m < scene.materials.size(); ++m) {
    if (!has_body(scene, m)) continue;
    const Material& material = scene.materials[m];
    if (soft == nullptr || constrained_modulus(material) < constrained_modulus(*soft))
      soft = &material;
    if (fast == nullptr || sound(material) > sound(*fast)) fast = &material;
  }
  if (soft == nullptr) return;
  const double contrast = constrained_modulus(*fast) / constrained_modulus(*soft);
  if (contrast < much) return;
  found.push_back(fmt::format(
      "material '{}' makes the time step {:.3g} times shorter than '{}' needs. Where it only "
      "carries, try youngs_modulus = {:.3g}: {:.2g} times fewer steps; under the same stress it "
      "then "
      "strains {:.0f} % as much as '{}', instead of {:.2g} %.",
      fast->name, sound(*fast) / sound(*soft), soft->name, fast->parameters[0] * enough / contrast,
      std::sqrt(contrast / enough), 100.0 / enough, soft->name, 100.0 / contrast));
}

}  // namespace

std::vector<std::string> warnings(const Scene& scene) {
  std::vector<std::string> found;
  for (const Material& material : scene.materials) check_cone(scene, material, found);
  check_settlement(scene, found);
  for (std::size_t m = 0; m < scene.materials.size(); ++m) {
    if (!has_body(scene, m)) {
      found.push_back(
          fmt::format("material '{}': no body is made of it.", scene.materials[m].name));
    }
  }
  check_contrast(scene, found);
  for (std::string& gap : wall_gaps(scene)) found.push_back(std::move(gap));
  if (scene.numerics.plasticity == Plasticity::rate_corrected &&
      scene.numerics.integrator == Integrator::verlet) {
    found.emplace_back(
        "numerics: plasticity = \"rate_corrected\" gives wrong plastic strains with Verlet. Try "
        "integrator = \"kick_drift_kick\", or plasticity = \"return\".");
  }
  // With corrected gradients a slope still creeps after its slide at 0.6 (THEORY, section 3).
  const double highest = scene.numerics.gradient_correction ? 0.3 : 0.8;
  if (scene.numerics.integrator == Integrator::verlet && scene.numerics.cfl > highest) {
    found.push_back(
        fmt::format("numerics: cfl = {} is near or above what Verlet, which leaps over two steps, "
                    "bears. Try {}, "
                    "or integrator = \"kick_drift_kick\".",
                    scene.numerics.cfl, scene.numerics.gradient_correction ? 0.3 : 0.6));
  }
  for (const Wall& wall : scene.walls) {
    if (!wall.removed_at.empty() && wall.removed_at == scene.stages.front().name) {
      found.push_back(fmt::format(
          "wall '{}': it is removed when the first stage begins, so it never acts.", wall.name));
    }
  }
  return found;
}

}  // namespace scarp
