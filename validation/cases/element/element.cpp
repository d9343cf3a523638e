// SPDX-License-Identifier: BSD-3-Clause
/// One stress point along the paths of laboratory tests against closed forms.

#include <cmath>

#include "engine/element/element_path.hpp"
#include "engine/output/text_file.hpp"
#include "validation/case_list.hpp"
#include "validation/cases/element/element_parts.hpp"

namespace scarp::validation {

int steps_of(const CaseRun& run, int main) {
  const Form form = run.options().form;
  return form == Form::short_form ? main / 4 : form == Form::main ? main : 4 * main;
}

Scene with_cone(Scene scene, std::size_t cone) {
  for (Material& material : scene.materials) {
    if (!material.model.has("cone")) continue;
    material.model.set("cone", static_cast<double>(cone));
  }
  return scene;
}

GradientIncrement shear_with_dilation_path(int dimension, double strain) {
  // Where z does not strain, the dilation in the plane is a part of the deviator too: each of x and
  // y is strain/2 - strain/3 off the mean, z -strain/3.
  const double each = strain / dimension, mean = strain / 3.0;
  const double z = dimension == 3 ? each : 0.0;
  const double squares = 2.0 * std::pow(each - mean, 2) + std::pow(z - mean, 2);
  const double half = 0.5 * std::sqrt(strain * strain - 2.0 * squares);
  return {each, half, 0, half, each, 0, 0, 0, z};
}

void draw_stress_paths(CaseRun& run) {
  const Scene scene = run.scene_at(0.1, "modern");
  constexpr const char* soil = "soil_12";
  struct Path {
    std::string_view name;
    ElementPath path;
    double strain;
  };
  constexpr std::array<Path, 5> paths{{{"triaxial compression", ElementPath::triaxial, 0.05},
                                       {"triaxial extension", ElementPath::triaxial, -0.05},
                                       {"plane strain", ElementPath::plane_strain, 0.05},
                                       {"simple shear", ElementPath::simple_shear, 0.1},
                                       {"isotropic extension", ElementPath::isotropic, -0.005}}};
  CsvFile table(run.folder() / "stress_paths.csv", {"path", "p [Pa]", "sqrt_J2 [Pa]"});
  CsvFile line(run.folder() / "yield_line.csv", {"alpha_phi", "k_c [Pa]"});
  for (const Path& path : paths) {
    const ElementResult result = run_element(
        scene, {path.path, soil, confining_pressure, path.strain, 500}, run.options().run);
    for (const ElementSample& sample : result.samples) {
      table << path.name << -sample.first_invariant / 3.0 << sample.root_j2;
      table.end_row();
    }
    if (path.name == paths.front().name) {
      line << result.constants.at("alpha_phi") << result.constants.at("k_c");
      line.end_row();
    }
  }
  const MaterialPoint point(scene, soil, 2, run.options().run);
  PointState state = point.at({-confining_pressure, -confining_pressure, -confining_pressure});
  for (int n = 0; n <= 500; ++n) {
    if (n > 0) state = point.advance(state, shear_with_dilation_path(2, 0.01 / 500));
    table << "pure shear with dilation" << -point.first_invariant(state) / 3.0
          << point.root_j2(state);
    table.end_row();
  }
}

void element(CaseRun& run) {
  failure_paths(run);
  plasticity_forms(run);
  step_counts(run);
  draw_stress_paths(run);
  run.finish(nullptr);
}

}  // namespace scarp::validation
