// SPDX-License-Identifier: BSD-3-Clause
/// Every soil and cone along every path, against its closed form.

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "engine/element/material_point.hpp"
#include "engine/output/text_file.hpp"
#include "validation/cases/element/closed_forms.hpp"
#include "validation/cases/element/element_parts.hpp"
#include "validation/extruded.hpp"

namespace scarp::validation {
namespace {

constexpr double B = confining_pressure;

/// A number beside its closed form; the error is their difference over `scale`.
struct Compared {
  std::string quantity;
  double computed, expected, scale;
};

/// What a path is run with and compared by.
struct Setting {
  const Scene& scene;
  const Material& soil;
  const RunOptions& options;
  const CaseRun& run;

  double parameter(std::string_view name) const { return soil.model.parameter(name); }
  bool has(Cone cone) const { return parameter("cone") == static_cast<double>(cone); }
  ElementResult driven(ElementPath path, double strain, int main_steps) const {
    return run_element(scene, {path, soil.name, B, strain, steps_of(run, main_steps)}, options);
  }
};

/// Coulomb's axial stress under the lateral pressure B, from c and phi themselves: the larger
/// (compression) or the smaller (extension) principal stress at failure.
double coulomb(const Setting& at, bool compression) {
  const double sign = compression ? 1.0 : -1.0;
  const double phi = at.parameter("friction_angle");
  const double c = at.parameter("cohesion");
  return (B * (1.0 + sign * std::sin(phi)) + sign * 2.0 * c * std::cos(phi)) /
         (1.0 - sign * std::sin(phi));
}

std::vector<Compared> triaxial(const Setting& at) {
  const ElementResult pressed = at.driven(ElementPath::triaxial, 0.05, 1000),
                      pulled = at.driven(ElementPath::triaxial, -0.05, 1000);
  const PlasticSoil soil(pressed);
  const ElementSample& end = pressed.samples.back();
  const double high = triaxial_strength(soil, B), low = triaxial_extension_strength(soil, B);
  const TriaxialStrains strains = triaxial_strains(soil, B, 0.05);
  const double compression = -end.stress[1], extension = -pulled.samples.back().stress[1];
  std::vector<Compared> all{
      {"triaxial compression, axial stress", compression, high, high},
      {"triaxial compression, volumetric strain", end.volumetric_strain,
       strains.elastic_volumetric + strains.plastic_volumetric,
       strains.plastic_volumetric - strains.elastic_volumetric},
      {"triaxial compression, plastic strain", end.history[0], strains.accumulated_plastic,
       strains.accumulated_plastic},
      // What is left of the stress can be near 0 or below it, so the pressure is the scale.
      {"triaxial extension, axial stress", extension, low, B}};
  if (at.has(Cone::outer)) {
    const double exact = coulomb(at, true);
    all.push_back({"triaxial compression, axial stress by Coulomb", compression, exact, exact});
  }
  if (at.has(Cone::inner)) {
    all.push_back(
        {"triaxial extension, axial stress by Coulomb", extension, coulomb(at, false), B});
  }
  return all;
}

std::vector<Compared> plane_strain(const Setting& at) {
  const ElementResult result = at.driven(ElementPath::plane_strain, 0.2, 2000);
  const PlaneStrainStrength exact = plane_strain_strength(PlasticSoil(result), B);
  const ElementSample& end = result.samples.back();
  std::vector<Compared> all{
      {"plane strain, axial stress", -end.stress[1], exact.axial, exact.axial},
      {"plane strain, stress across the plane", -end.stress[2], exact.across, exact.across}};
  const bool associated = at.parameter("dilation_angle") == at.parameter("friction_angle");
  if (associated && at.has(Cone::plane_strain)) {
    const double principal = coulomb(at, true);
    all.push_back(
        {"plane strain, psi = phi, axial stress by Coulomb", -end.stress[1], principal, principal});
  }
  return all;
}

std::vector<Compared> simple_shear(const Setting& at) {
  const ElementResult result = at.driven(ElementPath::simple_shear, 0.3, 6000);
  const double tau = simple_shear_strength(PlasticSoil(result), B);
  return {{"simple shear, shear stress", result.samples.back().stress[3], tau, tau}};
}

std::vector<Compared> isotropic(const Setting& at) {
  const ElementResult pressed = at.driven(ElementPath::isotropic, 0.01, 1000),
                      pulled = at.driven(ElementPath::isotropic, -0.01, 1000);
  const PlasticSoil soil(pressed);
  const double high = -3.0 * (B + soil.bulk_modulus * 0.01);
  return {{"isotropic compression, I1", pressed.samples.back().first_invariant, high, -high},
          {"isotropic extension, I1", pulled.samples.back().first_invariant,
           isotropic_extension(soil, B, 0.01), 3.0 * B}};
}

/// Pure shear with dilation, far enough that every soil with friction ends at its apex; the largest
/// error on the way counts.
std::vector<Compared> shear_to_apex(const Setting& at) {
  constexpr double shear = 0.01;
  const PlasticSoil soil(at.driven(ElementPath::isotropic, 0.01, 4));
  const MaterialPoint point(at.scene, at.soil.name, at.scene.dimension, at.options);
  const int steps = steps_of(at.run, 200);
  PointState state = point.at({-B, -B, -B, 0, 0, 0});
  GradientIncrement increment = shear_with_dilation_path(at.scene.dimension, shear);
  for (double& part : increment) part /= steps;
  const double strength = soil.strength(-3.0 * B);
  Compared i1{"shear with dilation to the apex, I1", 0, 0, 3.0 * B},
      j{"shear with dilation to the apex, sqrt J2", 0, 0, strength},
      plastic{"shear with dilation to the apex, plastic strain", 0, 0, shear};
  const auto keep = [](Compared& worst, double computed, double expected) {
    if (std::fabs(computed - expected) < std::fabs(worst.computed - worst.expected)) return;
    worst.computed = computed;
    worst.expected = expected;
  };
  for (int n = 1; n <= steps; ++n) {
    state = point.advance(state, increment);
    const double share = static_cast<double>(n) / steps;
    const auto exact = shear_with_dilation(soil, B, share * shear, share * shear);
    keep(i1, point.first_invariant(state), exact.first_invariant);
    keep(j, point.root_j2(state), exact.root_j2);
    keep(plastic, state.history[0], exact.accumulated_plastic);
  }
  return {i1, j, plastic};
}

/// The largest error of each quantity over soils, presets and dimensions.
struct Worst {
  std::string quantity, where;
  double error = 0.0;
};

class Errors {
 public:
  explicit Errors(CaseRun& run)
      : run_(run),
        table_(run.folder() / "paths.csv", {"preset", "cone", "dimension", "soil", "quantity",
                                            "computed", "expected", "relative_error"}) {}

  void note(const Setting& at, std::string_view cone, const Compared& one) {
    const double error = std::fabs(one.computed - one.expected) / one.scale;
    const std::string& preset = at.scene.numerics.preset;
    const std::string& soil = at.soil.name;
    table_ << preset << cone << static_cast<double>(at.scene.dimension) << soil << one.quantity
           << one.computed << one.expected << error;
    table_.end_row();
    const std::string where = fmt::format("{}, {} {}D", soil, preset, at.scene.dimension);
    for (Worst& worst : worst_) {
      if (worst.quantity != one.quantity) continue;
      const bool larger = error > worst.error || std::isnan(error);
      if (larger && !std::isnan(worst.error)) worst = {one.quantity, where, error};
      return;
    }
    worst_.push_back({one.quantity, where, error});
  }

  /// Judges what came together for one cone.
  void judge(std::string_view cone) {
    for (const Worst& worst : worst_) {
      run_.add(within(fmt::format("{} cone: {}", cone, worst.quantity), worst.error, "", 0.0, 0.0,
                      1e-3, "closed form; largest in " + worst.where));
    }
    worst_.clear();
  }

 private:
  CaseRun& run_;
  CsvFile table_;
  std::vector<Worst> worst_;
};

}  // namespace

void failure_paths(CaseRun& run) {
  Errors errors(run);
  const RunOptions& options = run.options().run;
  for (std::size_t cone = 0; cone < cone_names.size(); ++cone) {
    for (const std::string& preset : run.presets()) {
      const Scene plane = with_cone(run.scene_at(0.1, preset), cone);
      const Scene space = extruded(plane, 1.0);
      for (std::size_t m = 0; m < plane.materials.size(); ++m) {
        if (!plane.materials[m].model.has("cone")) continue;
        for (const Scene* scene : {&plane, &space}) {
          const Setting at{*scene, scene->materials[m], options, run};
          for (const auto path : {triaxial, plane_strain, simple_shear, isotropic, shear_to_apex}) {
            for (const Compared& one : path(at)) errors.note(at, cone_names[cone], one);
          }
        }
      }
    }
    errors.judge(cone_names[cone]);
  }
}

}  // namespace scarp::validation
