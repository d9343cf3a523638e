// SPDX-License-Identifier: BSD-3-Clause
/// A stress point under rotation, and the order of the errors in the strain increment.

#include <fmt/format.h>

#include <cmath>
#include <complex>
#include <functional>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "engine/element/material_point.hpp"
#include "engine/output/text_file.hpp"
#include "validation/cases/element/closed_forms.hpp"
#include "validation/cases/element/element_parts.hpp"

namespace scarp::validation {
namespace {

constexpr double B = confining_pressure;

/// The stress that is turned: compression with shear in the plane of the spin.
constexpr std::array<double, 6> turned{-B, -3 * B, -2 * B, 0.5 * B, 0, 0};

MaterialPoint point_of(Scene scene, StressRotation rotation, std::string_view material,
                       const RunOptions& options) {
  scene.numerics.stress_rotation = rotation;
  return MaterialPoint(scene, material, 2, options);
}

/// The state after `steps` equal increments.
PointState advanced(const MaterialPoint& point, const std::array<double, 6>& stress,
                    const GradientIncrement& total, int steps) {
  GradientIncrement increment = total;
  for (double& part : increment) part /= steps;
  PointState state = point.at(stress);
  for (int n = 0; n < steps; ++n) state = point.advance(state, increment);
  return state;
}

/// Frobenius norm of the difference over that of `exact`.
double difference(const std::array<double, 6>& stress, const std::array<double, 6>& exact) {
  double sum = 0.0, size = 0.0;
  for (std::size_t c = 0; c < 6; ++c) {
    const double count = c < 3 ? 1.0 : 2.0;
    sum += count * std::pow(stress[c] - exact[c], 2);
    size += count * exact[c] * exact[c];
  }
  return std::sqrt(sum / size);
}

PointState turned_by(const MaterialPoint& point, int turns, int steps) {
  const double angle = 2.0 * std::numbers::pi * turns;
  return advanced(point, turned, {0, -angle, 0, angle, 0, 0, 0, 0, 0}, steps);
}

/// (s_xx - s_yy)/2 + i s_xy, which turns by twice the angle.
std::complex<double> deviator_in_plane(const std::array<double, 6>& s) {
  return {0.5 * (s[0] - s[1]), s[3]};
}

/// One and ten turns in 1000 steps each. What both methods make of the deviator in the plane is
/// known: Hughes-Winget turns it by 4 atan(d/2) a step of angle d, the explicit rate multiplies it
/// by 1 + 2 i d.
void rotation(CaseRun& run, const Scene& scene) {
  constexpr int steps = 1000;
  const double d = 2.0 * std::numbers::pi / steps;
  for (const StressRotation kind : {StressRotation::hughes_winget, StressRotation::jaumann}) {
    const bool exact = kind == StressRotation::hughes_winget;
    const MaterialPoint point = point_of(scene, kind, "elastic", run.options().run);
    for (const int turns : {1, 10}) {
      const std::string who = fmt::format("{}, {} turn{} of {} steps: ", word(kind), turns,
                                          turns == 1 ? "" : "s", steps);
      const PointState state = turned_by(point, turns, turns * steps);
      const double error = difference(state.stress, turned);
      if (exact) {
        run.add(within(who + "stress error", error, "", 0.0, 0.0, 1e-4 * turns, "1e-4 a turn"));
      } else {
        run.add(reported(who + "stress error", error, "", "explicit rate; the deviator grows"));
      }
      const std::complex<double> factor =
          exact ? std::polar(1.0, 4.0 * std::atan(0.5 * d)) : std::complex(1.0, 2.0 * d);
      const std::complex<double> expected =
          deviator_in_plane(turned) * std::pow(factor, turns * steps);
      // 4 eps for the operations of each step, times 10 for the way roundings add up.
      const double round_off = 40.0 * turns * steps * std::numeric_limits<double>::epsilon();
      run.add(within(who + "deviator against its own closed form",
                     std::abs(deviator_in_plane(state.stress) - expected) / std::abs(expected), "",
                     0.0, 0.0, round_off,
                     exact ? "turns by 4 atan(d/2) a step d, to round-off"
                           : "times 1 + 2 i d a step d, to round-off"));
    }
  }
}

/// An error as a function of the number of steps, and the order it must fall with.
struct Series {
  std::string name;
  double least_order;
  std::string why;
  std::function<double(int)> error;
};

/// Elastic simple shear to gamma = 1 under constant sigma_yy, through the driver.
double elastic_shear_error(Scene scene, StressRotation kind, int steps, const RunOptions& options) {
  scene.numerics.stress_rotation = kind;
  const ElementResult result =
      run_element(scene, {ElementPath::simple_shear, "elastic", B, 1.0, steps}, options);
  const double g = result.shear_modulus;
  const ElasticShear exact = elastic_simple_shear(result.bulk_modulus, g, 1.0);
  const auto& stress = result.samples.back().stress;
  return std::hypot(stress[3] / g - exact.shear_stress, (stress[0] + B) / g - exact.normal_stress);
}

/// Krieg & Krieg (1977): on the cone, strain at right angles to the deviator turns it towards
/// itself, tan(angle/2) = tan(angle_0/2) exp(-2 G |e| / |s|); here by 2 G |e| = |s|.
double turning_flow_error(const MaterialPoint& point, int steps) {
  const auto cone = point.shown();
  const double j = cone.at("k_c") + 3.0 * cone.at("alpha_phi") * B,
               half = 0.5 * j / point.moduli().shear_modulus;
  const PointState state =
      advanced(point, {-B + j, -B - j, -B, 0, 0, 0}, {0, half, 0, half, 0, 0, 0, 0, 0}, steps);
  const double angle = std::atan2(state.stress[0] + B, state.stress[3]);
  return std::fabs(angle - 2.0 * std::atan(std::exp(-1.0)));
}

std::vector<Series> all_series(const Scene& scene, const RunOptions& options) {
  const auto hughes_winget = point_of(scene, StressRotation::hughes_winget, "elastic", options);
  const auto jaumann = point_of(scene, StressRotation::jaumann, "elastic", options);
  const auto soil = point_of(scene, StressRotation::hughes_winget, "soil_0", options);
  return {
      {"one turn, hughes_winget", 1.8, "second order: lags by d^3/12 a step d",
       [=](int n) { return difference(turned_by(hughes_winget, 1, n).stress, turned); }},
      {"one turn, jaumann", 0.9, "first order: an explicit rate",
       [=](int n) { return difference(turned_by(jaumann, 1, n).stress, turned); }},
      {"elastic simple shear, hughes_winget", 0.9,
       "first order: the strain increment is not turned by half the step's rotation",
       [=](int n) {
         return elastic_shear_error(scene, StressRotation::hughes_winget, n, options);
       }},
      {"elastic simple shear, jaumann", 0.9, "first order: an explicit rate",
       [=](int n) { return elastic_shear_error(scene, StressRotation::jaumann, n, options); }},
      {"flow that turns, return mapping", 0.9, "first order: an implicit step of the flow rule",
       [=](int n) { return turning_flow_error(soil, n); }},
  };
}

/// Simple shear of constant volume with Hughes-Winget: each increment d gamma lags by the half turn
/// of d gamma/4 that it is not given, the deviator by twice that.
void lag_in_shear(CaseRun& run, const Scene& scene) {
  const MaterialPoint point =
      point_of(scene, StressRotation::hughes_winget, "elastic", run.options().run);
  const double g = point.moduli().shear_modulus;
  const int steps = steps_of(run, 400);
  const PointState state =
      advanced(point, {-B, -B, -B, 0, 0, 0}, {0, 1.0, 0, 0, 0, 0, 0, 0, 0}, steps);
  const double error = std::hypot(state.stress[3] - g * std::sin(1.0),
                                  state.stress[0] + B - g * (1.0 - std::cos(1.0)));
  const double d = 1.0 / steps, lag = 2.0 * std::sin(0.5) * 0.5 * d * g;
  run.add(within("hughes_winget, simple shear of constant volume: error over the half-step lag",
                 error / lag, "", 1.0, 1.0 - 2.0 * d, 1.0 + 2.0 * d,
                 "the next term is smaller by d gamma"));
}

}  // namespace

void step_counts(CaseRun& run) {
  const Scene scene = run.scene_at(0.1, run.options().preset);
  rotation(run, scene);
  lag_in_shear(run, scene);
  const Form form = run.options().form;
  std::vector<int> counts{100, 200};
  if (form != Form::short_form) counts.push_back(400);
  if (form == Form::full) counts.insert(counts.end(), {800, 1600});
  CsvFile table(run.folder() / "convergence.csv", {"quantity", "steps", "error", "order"});
  for (const Series& series : all_series(scene, run.options().run)) {
    std::vector<ErrorAtSpacing> errors;  // over the increment in place of the spacing
    for (const int steps : counts) {
      errors.push_back({1.0 / steps, series.error(steps)});
      run.add(reported(fmt::format("{}: error in {} steps", series.name, steps),
                       errors.back().error, ""));
    }
    const double order = observed_order(errors);
    for (const ErrorAtSpacing& one : errors) {
      table << series.name << 1.0 / one.spacing << one.error << order;
      table.end_row();
    }
    const std::string name = series.name + ": observed order";
    if (counts.size() >= 3) {
      run.add(within(name, order, "", {}, series.least_order,
                     std::numeric_limits<double>::infinity(), series.why));
    } else {
      run.add(reported(name, order, "", series.why));
    }
  }
}

}  // namespace scarp::validation
