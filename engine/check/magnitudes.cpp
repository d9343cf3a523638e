// SPDX-License-Identifier: BSD-3-Clause
/// Density, strength, stiffness and gravity against what soils have.
#include "engine/check/magnitudes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/check/body_range.hpp"

namespace scarp {
namespace {

/// Along gravity [m].
class Heights {
 public:
  explicit Heights(const Scene& scene)
      : scene_(scene), ranges_(body_ranges(scene, gravity_axis(scene))) {}

  /// From the lowest to the highest point of a material; 0: unknown, or no body is made of it.
  double of_all(std::size_t material) const {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    BodyRange range{infinity, -infinity};
    for_each_body(material, [&range](const BodyRange& own) {
      range.low = std::min(range.low, own.low);
      range.high = std::max(range.high, own.high);
    });
    return std::fmax(range.high - range.low, 0.0);
  }
  /// Of the tallest body of a material.
  double of_tallest(std::size_t material) const {
    double tallest = 0.0;
    for_each_body(material, [&tallest](const BodyRange& own) {
      tallest = std::fmax(tallest, own.high - own.low);
    });
    return tallest;
  }

 private:
  template <class Visit>
  void for_each_body(std::size_t material, const Visit& visit) const {
    for (std::size_t body = 0; body < ranges_.size(); ++body) {
      if (material_of(scene_, scene_.bodies[body]) == material) visit(ranges_[body]);
    }
  }

  const Scene& scene_;
  std::vector<BodyRange> ranges_;
};

std::string pressure_text(double pressure) {
  return pressure < 1e3 ? fmt::format("{:.4g} Pa", pressure)
                        : fmt::format("{:.4g} kPa", 1e-3 * pressure);
}

/// What a number was perhaps meant to be, by the sizes soils have in other units.
std::string density_meant(double density) {
  const struct {
    double low, high;
    const char* text;
  } guesses[] = {{0.5, 5.0, "density = \"{:.4g} t/m3\""},
                 {5.0, 40.0, "unit_weight = \"{:.4g} kN/m3\""},
                 {40.0, 250.0, "unit_weight = \"{:.4g} pcf\""},
                 {5000.0, 40000.0, "unit_weight = \"{:.4g} N/m3\""}};
  for (const auto& guess : guesses) {
    if (density >= guess.low && density <= guess.high)
      return fmt::format(fmt::runtime(guess.text), density);
  }
  return "density = \"2000 kg/m3\"";
}

/// Bulk densities run from peat and snow to ore; what only carries may be lighter or heavier.
void check_density(const Material& material, std::vector<std::string>& found) {
  const bool soil = material.model.yields();
  const double least = soil ? 400.0 : 10.0, most = soil ? 5000.0 : 25000.0;
  if (material.density >= least && material.density <= most) return;
  found.push_back(fmt::format(
      "material '{}': a density of {:.4g} kg/m3 is outside what {} has, {:g} to {:g}. Is it in the "
      "right unit? Try {}.",
      material.name, material.density, soil ? "soil" : "any ground", least, most,
      density_meant(material.density)));
}

/// Clays with much smectite have 5 deg and more, dense gravel under low stress up to 55 deg.
void check_friction(const Material& material, std::vector<std::string>& found) {
  const auto strength = material.model.strength();
  if (!strength) return;
  constexpr double degree = 3.14159265358979323846 / 180.0;
  const double phi = strength->friction_angle;
  if (phi == 0.0 || (phi >= 4.999 * degree && phi <= 55.001 * degree)) return;
  found.push_back(fmt::format(
      "material '{}': a friction angle of {} is outside what soils have, 5 to 55 deg. Is it in the "
      "right unit? Try 0 for undrained clay, or 20 to 40 deg.",
      material.name, degrees_text(phi)));
}

/// Cohesion over the pressure below the tallest body: a cliff stands up to a ratio of about 1/4.
void check_cohesion(const Material& material, double pressure, double height,
                    std::vector<std::string>& found) {
  constexpr double nothing = 1e-3, too_much = 1e3;
  const auto strength = material.model.strength();
  if (!strength || !(pressure > 0.0)) return;
  const double cohesion = strength->cohesion, ratio = cohesion / pressure;
  if (cohesion == 0.0 || (ratio >= nothing && ratio <= too_much)) return;
  const std::string start = fmt::format(
      "material '{}': a cohesion of {} is {:.2g} times the weight of the soil {:.4g} m high, {}: ",
      material.name, pressure_text(cohesion), ratio, height, pressure_text(pressure));
  found.push_back(
      start +
      (ratio < nothing
           ? fmt::format("it carries nothing. Is it in the right unit? Try \"{:.4g} kPa\", or 0.",
                         cohesion < 1000.0 ? cohesion : 1e-3 * cohesion)
           : "it will not yield under its own weight. Is it in the right unit? Try kPa."));
}

/// Equation: E14 the other way.
double youngs_modulus(const Material& material) {
  const auto [k, g] = material.model.moduli();
  return 9.0 * k * g / (3.0 * k + g);
}

/// Pressure waves run at 1500 m/s in saturated soil and at 7000 m/s in the hardest rock.
void check_stiffness(const Material& material, std::vector<std::string>& found) {
  constexpr double fastest = 10000.0;
  const double speed = std::sqrt(material.model.moduli().wave_modulus() / material.density);
  if (speed <= fastest) return;
  found.push_back(
      fmt::format("material '{}': with E = {:.4g} Pa and a density of {:.4g} kg/m3 sound would run "
                  "at {:.3g} m/s, "
                  "faster than in any rock. Are they in the right units? Try a softer soil.",
                  material.name, youngs_modulus(material), material.density, speed));
}

/// Settlement under its own weight, gamma H / (2 M) of the height H; M is the constrained modulus.
void check_settlement(const Material& material, double weight, double height,
                      std::vector<std::string>& found) {
  const double share = weight * height / (2.0 * material.model.moduli().wave_modulus());
  if (!(share > 0.1)) return;
  found.push_back(fmt::format(
      "material '{}': with E = {:.4g} Pa a body {:.4g} m high settles by about {:.0f} % of its "
      "height under its own weight. Is E in the right unit (kPa, MPa)? Try a stiffer soil.",
      material.name, youngs_modulus(material), height, 100.0 * share));
}

void check_gravity(const Scene& scene, std::vector<std::string>& found) {
  const double up = scene.gravity[scene.dimension == 2 ? 1 : 2];
  const double g = std::hypot(scene.gravity[0], scene.gravity[1], scene.gravity[2]);
  if (up > 0.5 * g) {
    found.push_back(fmt::format("gravity points up. Try a negative number for {}, as in -9.81.",
                                scene.dimension == 2 ? 'y' : 'z'));
  }
}

}  // namespace

std::string degrees_text(double angle) {
  return fmt::format("{:.4g} deg", angle * 45.0 / std::atan(1.0));
}

void check_magnitudes(const Scene& scene, std::vector<std::string>& found) {
  check_gravity(scene, found);
  const double g = std::hypot(scene.gravity[0], scene.gravity[1], scene.gravity[2]);
  const Heights heights(scene);
  for (std::size_t m = 0; m < scene.materials.size(); ++m) {
    const Material& material = scene.materials[m];
    check_friction(material, found);
    if (g == 0.0) continue;  // nothing has weight: scales may be chosen freely
    const double weight = material.density * g, tallest = heights.of_tallest(m);
    check_density(material, found);
    check_stiffness(material, found);
    check_settlement(material, weight, heights.of_all(m), found);
    check_cohesion(material, weight * tallest, tallest, found);
  }
}

}  // namespace scarp
