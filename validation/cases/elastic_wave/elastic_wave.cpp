// SPDX-License-Identifier: BSD-3-Clause
/// Speed, decay and error of a standing longitudinal wave against the exact one.

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <optional>

#include "engine/output/text_file.hpp"
#include "validation/case_list.hpp"
#include "validation/convergence.hpp"
#include "validation/extruded.hpp"

namespace scarp::validation {
namespace {

constexpr double amplitude = 1e-3;  ///< of the velocity in the scene [m/s]

/// v = v0 sin(k x) cos(k c t) between smooth ends, with k = pi/L and c = c_p.
struct StandingWave {
  double wave_number, speed;

  explicit StandingWave(const Scene& scene) {
    const Material& soil = scene.materials.front();
    const double youngs = soil.model.parameter("youngs_modulus"),
                 poisson = soil.model.parameter("poisson_ratio");
    // K + 4/3 G in terms of E and nu.
    const double modulus = youngs * (1.0 - poisson) / ((1.0 + poisson) * (1.0 - 2.0 * poisson));
    speed = std::sqrt(modulus / soil.density);
    wave_number = std::numbers::pi / std::get<Box>(scene.bodies.front().shape).maximum[0];
  }
  double shape(double x) const { return std::sin(wave_number * x); }
  double velocity(double x, double time) const {
    return amplitude * shape(x) * std::cos(wave_number * speed * time);
  }
};

/// rms error of the velocity at the end over the rms of its first state.
double velocity_error(const Simulation& ended) {
  const StandingWave wave(ended.scene());
  const std::vector<double> position = ended.field("position"), velocity = ended.field("velocity");
  const double time = ended.last_step().time;
  double squares = 0.0;
  for (std::size_t k = 0; k < velocity.size(); k += 3) {
    squares += std::pow(velocity[k] - wave.velocity(position[k], time), 2) +
               std::pow(velocity[k + 1], 2) + std::pow(velocity[k + 2], 2);
  }
  return std::sqrt(2.0 * squares / static_cast<double>(ended.soil_count())) / amplitude;
}

/// Share of the wave's shape in the velocity field, over its first value.
double share_of_shape(const Simulation& simulation) {
  const StandingWave wave(simulation.scene());
  const std::vector<double> position = simulation.field("position"),
                            velocity = simulation.field("velocity");
  double sum = 0.0;
  for (std::size_t k = 0; k < velocity.size(); k += 3) sum += velocity[k] * wave.shape(position[k]);
  return 2.0 * sum / static_cast<double>(simulation.soil_count()) / amplitude;
}

/// Follows the share of the wave's shape and notes when it vanishes.
class ZeroCrossings {
 public:
  void note(const Simulation& simulation) {
    const double time = simulation.last_step().time, share = share_of_shape(simulation);
    if (share * share_ < 0.0) {
      const double at = time_ + (time - time_) * share_ / (share_ - share);
      if (count_++ == 0) first_ = at;
      last_ = at;
    }
    time_ = time;
    share_ = share;
  }
  /// Crossings are half a period apart. NaN before the second.
  double period() const { return 2.0 * (last_ - first_) / (count_ - 1); }

 private:
  double time_ = 0.0, share_ = 1.0, first_ = 0.0, last_ = 0.0;
  int count_ = 0;
};

struct Outcome {
  double error = 0.0;  ///< of the velocity at the end
  double speed = 0.0;  ///< measured over exact
  double final_share = 0.0, exact_share = 0.0;
};

Outcome measure(const Simulation& ended, const ZeroCrossings& crossings) {
  const StandingWave wave(ended.scene());
  const double exact_period = 2.0 * std::numbers::pi / (wave.wave_number * wave.speed);
  return {
      velocity_error(ended), exact_period / crossings.period(), share_of_shape(ended),
      wave.velocity(0.5 * std::numbers::pi / wave.wave_number, ended.last_step().time) / amplitude};
}

double outcome_of(CaseRun& run, const Scene& scene) {
  return velocity_error(run.solve("wave", scene));
}

/// The speed of what a run is expected to carry. On a lattice of moment m both gradients are m
/// times the true ones and so is the speed; the artificial stress weakens tension besides, so that
/// no speed is expected with it.
void judge(CaseRun& run, const std::string& who, double moment, bool artificial_stress,
           const std::vector<ErrorAtSpacing>& errors, const std::vector<ErrorAtSpacing>& speeds,
           const Outcome& finest) {
  const bool normalised = moment == 1.0;
  if (artificial_stress) {
    for (const ErrorAtSpacing& one : speeds) {
      run.add(reported(fmt::format("{}wave speed over c_p, dx = {} m", who, one.spacing),
                       one.error + moment, "", "artificial stress weakens the half in tension"));
    }
    run.add(reported(who + "L2 error of velocity", errors.back().error, ""));
    return;
  }
  run.add(within(who + "wave speed over c_p", finest.speed, "", moment, 0.99 * moment,
                 1.01 * moment, normalised ? "c_p = sqrt((K + 4/3 G)/rho), 1 %" : "M c_p, 1 %"));
  run.add(reported(who + "amplitude after 2 3/8 periods", finest.final_share / finest.exact_share,
                   "", "over the exact one; phase and decay together"));
  judge_convergence(
      run, who + (normalised ? "speed over c_p - 1" : "speed over c_p - M"), speeds,
      {0.01 * moment, normalised ? std::optional(1.0) : std::nullopt, "as the speed"});
  // A speed of c (1 - e) shifts the phase of 2 3/8 periods by 14.9 e; sine and cosine of the end
  // are 0.707.
  if (normalised) {
    judge_convergence(
        run, who + "L2 error of velocity", errors,
        {0.707 * (0.149 + 0.05), 1.0, "1 % of speed over 2 3/8 periods, 5 % of decay"});
  } else {
    run.add(reported(who + "L2 error of velocity", errors.back().error, "",
                     "does not converge: the speed is M c_p"));
  }
}

/// One preset in one dimension, as it stands or without artificial viscosity and stress.
std::optional<Simulation> series(CaseRun& run, const std::string& preset, int dimension, bool whole,
                                 const std::vector<double>& spacings) {
  const std::string who =
      fmt::format("{} {}D{}: ", preset, dimension, whole ? "" : ", elastic terms only");
  std::vector<ErrorAtSpacing> errors, speeds;
  std::optional<Simulation> last;
  Outcome finest;
  double moment = 1.0;
  bool artificial_stress = false;
  for (const double spacing : spacings) {
    Scene scene = run.scene_at(spacing, preset);
    if (!whole) scene.numerics.viscosity_alpha = scene.numerics.artificial_stress = 0.0;
    artificial_stress = scene.numerics.artificial_stress > 0.0;
    if (dimension == 3) scene = extruded(std::move(scene), 4.0 * spacing);
    ZeroCrossings crossings;
    const StandingWave wave(scene);
    CsvFile history(run.folder() / fmt::format("wave_{}_{}d_{}_{}.csv", preset, dimension,
                                               whole ? "whole" : "elastic", spacing),
                    {"time [s]", "amplitude [-]", "closed_form [-]"});
    last = run.solve(fmt::format("{}dx = {} m", who, spacing), scene,
                     [&](const Simulation& simulation) {
                       crossings.note(simulation);
                       const double time = simulation.last_step().time;
                       history << time << share_of_shape(simulation)
                               << std::cos(wave.wave_number * wave.speed * time);
                       history.end_row();
                     });
    if (!scene.numerics.lattice_normalisation) moment = last->lattice_moment();
    finest = measure(*last, crossings);
    errors.push_back({spacing, finest.error});
    speeds.push_back({spacing, finest.speed - moment});
  }
  judge(run, who, moment, artificial_stress, errors, speeds, finest);
  return last;
}

}  // namespace

const ErrorProblem elastic_wave_problem{
    "L2 error of velocity after 2 3/8 periods", {0.5, 0.25, 0.125, 0.0625}, outcome_of};

void elastic_wave(CaseRun& run) {
  const std::vector<double> spacings = run.spacings({0.5, 0.25, 0.125});
  std::optional<Simulation> last;
  for (const std::string& preset : run.presets()) {
    for (const int dimension : {2, 3}) {
      if (dimension == 3 && run.short_form()) continue;
      for (const bool whole : {false, true}) {
        last = series(run, preset, dimension, whole, spacings);
      }
    }
  }
  run.finish(&*last);
}

}  // namespace scarp::validation
