// SPDX-License-Identifier: BSD-3-Clause
/// Return mapping beside the rate form and the rate form with Bui's corrections.

#include <fmt/format.h>

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "engine/element/material_point.hpp"
#include "engine/errors.hpp"
#include "engine/output/text_file.hpp"
#include "validation/cases/element/closed_forms.hpp"
#include "validation/cases/element/element_parts.hpp"
#include "validation/cases/element/rate_forms.hpp"

namespace scarp::validation {
namespace {

constexpr double B = confining_pressure, strain = 0.05, reduction = 1.4;

/// One soil by one form of plasticity.
struct Driven {
  std::string form;
  std::vector<ElementSample> samples;
  /// After c and tan phi have been divided by `reduction` at failure and one step without strain
  /// has passed: f over strength. 0: the stress has followed.
  double after_cut = 0.0;
};

double over_strength(double yield, const PlasticSoil& soil, double first_invariant) {
  return yield / soil.strength(first_invariant);
}

class Comparison {
 public:
  Comparison(CaseRun& run, std::string_view name)
      : run_(run),
        name_(name),
        scene_(run.scene_at(0.1, run.options().preset)),
        soil_(name),
        constants_(run_element(scene_, {ElementPath::isotropic, soil_, B, strain, 1},
                               run.options().run)) {}

  const PlasticSoil& constants() const { return constants_; }

  Driven by_return() const {
    const ElementResult result =
        run_element(scene_, {ElementPath::triaxial, soil_, B, strain, steps()}, run_.options().run);
    const ElementSample& end = result.samples.back();
    const MaterialPoint cut(scene_, soil_, 3, run_.options().run, reduction);
    const PointState state = cut.advance(cut.at(end.stress), {});
    return {"return", result.samples,
            over_strength(cut.yield_function(state), reduced(), cut.first_invariant(state))};
  }
  Driven by_rate(RateForm form) const {
    std::vector<ElementSample> samples = triaxial_by_rate(constants_, form, B, strain, steps());
    const auto& s = samples.back().stress;
    const kernels::SymTensor<double> after =
        rate_step(reduced(), form, {}, {s[0], s[1], s[2], s[3], s[4], s[5]});
    const double share = over_strength(yield_function(reduced(), after), reduced(), trace(after));
    return {std::string(name_of(form)), std::move(samples), share};
  }
  void report(const Driven& driven, CsvFile& table) const {
    const double high = triaxial_strength(constants_, B);
    const ElementSample& end = driven.samples.back();
    const auto expected = [&](double axial) {
      const TriaxialStrains strains = triaxial_strains(constants_, B, axial);
      return strains.elastic_volumetric + strains.plastic_volumetric;
    };
    const std::string who = fmt::format("{}, plasticity = {}: ", name_, driven.form);
    run_.add(reported(who + "axial stress over closed form", -end.stress[1] / high, "",
                      "triaxial compression to 5 %"));
    run_.add(reported(who + "volumetric strain", end.volumetric_strain, "",
                      fmt::format("closed form {:.5f}", expected(strain))));
    run_.add(reported(who + "yield function over strength",
                      over_strength(end.yield_function, constants_, end.first_invariant), "",
                      "0 on the surface"));
    run_.add(reported(who + "the same after the strength is cut by 1.4", driven.after_cut, "",
                      "one step without strain"));
    const double elastic = (high - B) / constants_.youngs_modulus();
    for (const ElementSample& sample : driven.samples) {
      const double axial = -sample.strain[1];
      const double before = -axial * constants_.youngs_modulus() / (3.0 * constants_.bulk_modulus);
      table << name_ << driven.form << axial << -sample.first_invariant / 3.0 << sample.root_j2
            << sample.yield_function << sample.volumetric_strain
            << (axial < elastic ? before : expected(axial));
      table.end_row();
    }
  }

 private:
  int steps() const { return steps_of(run_, 1000); }
  PlasticSoil reduced() const {
    const MaterialPoint cut(scene_, soil_, 3, run_.options().run, reduction);
    PlasticSoil soil = constants_;
    const auto constants = cut.shown();
    soil.alpha_phi = constants.at("alpha_phi");
    soil.k_c = constants.at("k_c");
    soil.alpha_psi = constants.at("alpha_psi");
    return soil;
  }

  CaseRun& run_;
  std::string_view name_;
  Scene scene_;
  std::string soil_;
  PlasticSoil constants_;
};

}  // namespace

void plasticity_forms(CaseRun& run) {
  CsvFile table(run.folder() / "plasticity.csv",
                {"soil", "plasticity", "axial_strain", "p [Pa]", "sqrt_J2 [Pa]",
                 "yield_function [Pa]", "volumetric_strain", "expected_volumetric_strain"});
  for (const std::string_view name : {"soil_0", "soil_12", "soil_30"}) {
    const Comparison comparison(run, name);
    comparison.report(comparison.by_return(), table);
    for (const RateForm form : {RateForm::rate, RateForm::rate_corrected}) {
      try {
        comparison.report(comparison.by_rate(form), table);
      } catch (const Error& error) {
        run.add(reported(fmt::format("{}, plasticity = {}: ran to its end", name, name_of(form)),
                         0.0, "", error.what()));
      }
    }
  }
}

}  // namespace scarp::validation
