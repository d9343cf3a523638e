// SPDX-License-Identifier: BSD-3-Clause
/// Return mapping beside the rate form and the rate form with Bui's corrections.

#include <fmt/format.h>

#include <array>
#include <string_view>

#include "engine/element/material_point.hpp"
#include "engine/errors.hpp"
#include "engine/output/text_file.hpp"
#include "validation/cases/element/closed_forms.hpp"
#include "validation/cases/element/element_parts.hpp"

namespace scarp::validation {
namespace {

/// Yield function over strength after c and tan phi of a point at failure have been divided by
/// `reduction` and one step without strain has passed. 0: the stress has followed.
double after_strength_cut(const Scene& scene, std::size_t soil, const ElementSample& failed,
                          double reduction, const RunOptions& options) {
  const MaterialPoint cut(scene, soil, 3, options, reduction);
  const PointState state = cut.advance(cut.at(failed.stress), {});
  const auto& c = cut.constants();
  return cut.yield_function(state) / (c.k_c - c.alpha_phi * cut.first_invariant(state));
}

}  // namespace

void plasticity_forms(CaseRun& run) {
  constexpr std::array forms{Plasticity::return_mapping, Plasticity::rate,
                             Plasticity::rate_corrected};
  constexpr double B = confining_pressure, strain = 0.05;
  Scene scene = run.scene_at(0.1, run.options().preset);
  CsvFile table(run.folder() / "plasticity.csv",
                {"soil", "plasticity", "axial_strain", "p [Pa]", "sqrt_J2 [Pa]",
                 "yield_function [Pa]", "volumetric_strain", "expected_volumetric_strain"});
  for (const std::string_view name : {"soil_0", "soil_12", "soil_30"}) {
    const std::size_t soil = material_of(scene, name);
    for (const Plasticity form : forms) {
      scene.numerics.plasticity = form;
      const std::string who = fmt::format("{}, plasticity = {}: ", name, word(form));
      ElementResult result;
      try {
        result = run_element(scene, {ElementPath::triaxial, soil, B, strain, steps_of(run, 1000)},
                             run.options().run);
      } catch (const Error& error) {
        run.add(reported(who + "ran to its end", 0.0, "", error.what()));
        continue;
      }
      const PlasticSoil constants(result);
      const double high = triaxial_strength(constants, B);
      const ElementSample& end = result.samples.back();
      const auto expected = [&](double axial) {
        const TriaxialStrains strains = triaxial_strains(constants, B, axial);
        return strains.elastic_volumetric + strains.plastic_volumetric;
      };
      run.add(reported(who + "axial stress over closed form", -end.stress[1] / high, "",
                       "triaxial compression to 5 %"));
      run.add(reported(who + "volumetric strain", end.volumetric_strain, "",
                       fmt::format("closed form {:.5f}", expected(strain))));
      run.add(reported(who + "yield function over strength",
                       end.yield_function / constants.strength(end.first_invariant), "",
                       "0 on the surface"));
      run.add(reported(who + "the same after the strength is cut by 1.4",
                       after_strength_cut(scene, soil, end, 1.4, run.options().run), "",
                       "one step without strain"));
      for (const ElementSample& sample : result.samples) {
        const double axial = -sample.strain[1];
        const double elastic = (high - B) / constants.youngs_modulus();
        const double before = -axial * constants.youngs_modulus() / (3.0 * constants.bulk_modulus);
        table << name << word(form) << axial << -sample.first_invariant / 3.0 << sample.root_j2
              << sample.yield_function << sample.volumetric_strain
              << (axial < elastic ? before : expected(axial));
        table.end_row();
      }
    }
  }
}

}  // namespace scarp::validation
