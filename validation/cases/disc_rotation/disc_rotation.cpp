// SPDX-License-Identifier: BSD-3-Clause
/// A free elastic body in rotation: what it keeps of its motion and stress, against the closed
/// form.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "engine/scene/vector.hpp"
#include "validation/case_list.hpp"
#include "validation/convergence.hpp"

namespace scarp::validation {
namespace {

constexpr double turn_time = 1.0;  ///< of the scene's velocity field [s]
constexpr double angular_velocity = 2.0 * std::numbers::pi / turn_time;

using geometry::cross;

/// Kinetic energy and angular momentum, both over the mass of a particle, about the scene's origin,
/// where the centre of mass rests.
struct Motion {
  double kinetic = 0.0;
  Vec3 angular{};

  explicit Motion(const Simulation& simulation) {
    const std::vector<double> position = simulation.field("position"),
                              velocity = simulation.field("velocity");
    for (std::size_t k = 0; k < velocity.size(); k += 3) {
      const Vec3 x{position[k], position[k + 1], position[k + 2]};
      const Vec3 v{velocity[k], velocity[k + 1], velocity[k + 2]};
      kinetic += 0.5 * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
      const Vec3 moment = cross(x, v);
      for (std::size_t a = 0; a < 3; ++a) angular[a] += moment[a];
    }
  }
  /// Angular momentum along that of `start`, over its size.
  double spin_over(const Motion& start) const {
    double along = 0.0, size = 0.0;
    for (std::size_t a = 0; a < 3; ++a) {
      along += angular[a] * start.angular[a];
      size += start.angular[a] * start.angular[a];
    }
    return along / size;
  }
};

/// Stress of a disc in steady rotation, plane strain, free rim: radial (3 - 2 nu) k (R^2 - r^2),
/// hoop k ((3 - 2 nu) R^2 - (1 + 2 nu) r^2), k = rho w^2/(8 (1 - nu)), no shear. Source: Timoshenko
/// and Goodier, Theory of Elasticity, section 32, with nu/(1 - nu) for nu.
struct CentrifugalStress {
  double radius, poisson, factor;

  explicit CentrifugalStress(const Scene& scene) {
    const Material& soil = scene.materials.front();
    radius = std::get<Cylinder>(scene.bodies.front().shape).radius;
    poisson = soil.model.parameter("poisson_ratio");
    factor = soil.density * angular_velocity * angular_velocity / (8.0 * (1.0 - poisson));
  }
  double centre() const { return factor * (3.0 - 2.0 * poisson) * radius * radius; }
  /// Radial, hoop, shear.
  std::array<double, 3> at(double r) const {
    return {centre() - factor * (3.0 - 2.0 * poisson) * r * r,
            centre() - factor * (1.0 + 2.0 * poisson) * r * r, 0.0};
  }
};

/// Mean over time of each particle's stress along its own radius and hoop: the frame that turns
/// with the disc. The mean, because a disc set in rotation without stress breathes about the steady
/// state.
class CorotatedMean {
 public:
  void note(const Simulation& simulation) {
    if (++calls_ % 5 != 0) return;  // 30 samples and more in one breath of the disc
    const std::vector<double> position = simulation.field("position"),
                              stress = simulation.field("stress");
    mean_.resize(simulation.soil_count());
    for (std::size_t i = 0; i < mean_.size(); ++i) {
      const double x = position[3 * i], y = position[3 * i + 1];
      const double square = std::fmax(x * x + y * y, std::numeric_limits<double>::min());
      const double cc = x * x / square, ss = y * y / square, cs = x * y / square;
      const double xx = stress[6 * i], yy = stress[6 * i + 1], xy = stress[6 * i + 3];
      mean_[i][0] += xx * cc + yy * ss + 2.0 * xy * cs;
      mean_[i][1] += xx * ss + yy * cc - 2.0 * xy * cs;
      mean_[i][2] += (yy - xx) * cs + xy * (cc - ss);
    }
    ++count_;
  }

  /// rms over particles and components of the difference to the closed form, over its largest
  /// value.
  double error(const Simulation& simulation) const {
    const CentrifugalStress exact(simulation.scene());
    const std::vector<double> position = simulation.field("position"),
                              displacement = simulation.field("displacement");
    double squares = 0.0;
    for (std::size_t i = 0; i < mean_.size(); ++i) {
      const double r = std::hypot(position[3 * i] - displacement[3 * i],
                                  position[3 * i + 1] - displacement[3 * i + 1]);
      const std::array<double, 3> reference = exact.at(r);
      for (std::size_t c = 0; c < 3; ++c)
        squares += std::pow(mean_[i][c] / count_ - reference[c], 2);
    }
    return std::sqrt(squares / (3.0 * static_cast<double>(mean_.size()))) / exact.centre();
  }

  /// rms of the change from `earlier`, over the largest value of the closed form.
  double change(const CorotatedMean& earlier, const Scene& scene) const {
    double squares = 0.0;
    for (std::size_t i = 0; i < mean_.size(); ++i) {
      for (std::size_t c = 0; c < 3; ++c)
        squares += std::pow(mean_[i][c] / count_ - earlier.mean_[i][c] / earlier.count_, 2);
    }
    return std::sqrt(squares / (3.0 * static_cast<double>(mean_.size()))) /
           CentrifugalStress(scene).centre();
  }

 private:
  std::vector<std::array<double, 3>> mean_;  ///< sums; over `count_` they are means
  int calls_ = 0;
  double count_ = 0.0;
};

struct Outcome {
  double kinetic_first = 0.0, spin_first = 0.0;  ///< after one turn, over the start
  double kinetic_last = 0.0, spin_last = 0.0;    ///< at the end
  double stress_first = 0.0;                     ///< error over the second half of the first turn
  double stress_change = 0.0;                    ///< from there to the second half of the last turn
  /// Of energy, over the first kinetic energy: what kinetic, elastic, viscous and diffusive parts
  /// leave open, and what the further line of the gradient's residue leaves open.
  double open = 0.0, imbalance = 0.0;
};

/// Runs the scene to its end, a whole number of turns.
Outcome turned(CaseRun& run, const std::string& name, const Scene& scene,
               std::optional<Simulation>& simulation) {
  simulation.emplace(scene, run.options().run);
  const Motion start(*simulation);
  const double first_energy = simulation->energy().kinetic;
  const double end = scene.stages.front().duration.value();
  CorotatedMean first, last;
  std::optional<Motion> after_turn;
  Outcome outcome;
  run.run_stage(name, *simulation, nullptr, [&](const Simulation& now) {
    const double time = now.last_step().time;
    if (time > 0.5 * turn_time && time <= turn_time) first.note(now);
    if (time > end - 0.5 * turn_time) last.note(now);
    if (!after_turn && time >= turn_time * (1.0 - 1e-9)) {
      after_turn.emplace(now);
      if (scene.dimension == 2) outcome.stress_first = first.error(now);
    }
  });
  const Motion after(*simulation);
  outcome.kinetic_first = after_turn->kinetic / start.kinetic;
  outcome.spin_first = after_turn->spin_over(start);
  outcome.kinetic_last = after.kinetic / start.kinetic;
  outcome.spin_last = after.spin_over(start);
  if (scene.dimension == 2) outcome.stress_change = last.change(first, scene);
  const EnergyBalance energy = simulation->energy();
  outcome.imbalance = energy.imbalance / first_energy;
  outcome.open =
      (energy.imbalance + energy.gradient_residue + energy.artificial_stress) / first_energy;
  return outcome;
}

Scene turning(Scene scene, double turns) {
  scene.stages.front().duration = turns * turn_time;
  return scene;
}

/// A cylinder as high as makes its three moments of inertia equal, sqrt(3) R, so that it turns
/// steadily about any axis; here about (1, 1, 1), which gives the spin all three components.
Scene cylinder_scene(Scene scene) {
  scene.dimension = 3;
  scene.gravity = {};
  Body& body = scene.bodies.front();
  auto& cylinder = std::get<Cylinder>(body.shape);
  const double layers = std::round(std::sqrt(3.0) * cylinder.radius / scene.spacing);
  cylinder.height = layers * scene.spacing;
  cylinder.centre[2] = -0.5 * cylinder.height;
  const double rate = angular_velocity / std::sqrt(3.0);
  body.velocity_field = {fmt::format("{}*(z-y)", rate), fmt::format("{}*(x-z)", rate),
                         fmt::format("{}*(y-x)", rate)};
  return scene;
}

void judge_motion(CaseRun& run, const std::string& who, const Outcome& outcome, double turns,
                  bool kept) {
  const std::string source = "losses of the method only: 95 % after ten turns";
  const auto add = [&](const std::string& name, double value, bool judged) {
    run.add(judged ? within(who + name, value, "", 1.0, 0.95, 1.0 + 1e-3, source)
                   : reported(who + name, value, ""));
  };
  add("kinetic energy after one turn", outcome.kinetic_first, kept);
  add("angular momentum after one turn", outcome.spin_first, kept);
  add(fmt::format("kinetic energy after {} turns", turns), outcome.kinetic_last, kept);
  add(fmt::format("angular momentum after {} turns", turns), outcome.spin_last, kept);
  run.add(kept ? within(who + "energy left open by kinetic, elastic, viscous, diffusion",
                        outcome.open, "", 0.0, -0.02, 0.02, "over the first kinetic energy, 2 %")
               : reported(who + "energy taken by artificial stress and gradient residue",
                          outcome.open, "", "over the first kinetic energy"));
  // Judged where there is time for a failure to be looked at: see the README.
  if (!run.short_form()) {
    run.add(within(who + "energy imbalance, every part named", outcome.imbalance, "", 0.0, -0.02,
                   0.02, "over the first kinetic energy, 2 %"));
  }
}

/// `modern`, with and without the correction of the gradient.
void modern_disc(CaseRun& run, std::optional<Simulation>& last) {
  std::vector<ErrorAtSpacing> stresses;
  Outcome finest;
  const std::vector<double> spacings = run.spacings({0.1, 0.05, 0.025});
  for (const double spacing : spacings) {
    const Scene scene = turning(run.scene_at(spacing, "modern"), 10.0);
    finest = turned(run, fmt::format("modern 2D, dx = {} m", spacing), scene, last);
    stresses.push_back({spacing, finest.stress_first});
  }
  judge_motion(run, "modern 2D: ", finest, 10.0, true);
  const double radius = CentrifugalStress(last->scene()).radius;
  judge_convergence(run, "modern 2D: rms error of co-rotated stress, first turn", stresses,
                    {spacings.back() / radius, 0.8,
                     "dx/R: the outline is known to half a spacing; first order less scatter"});
  run.add(within("modern 2D: change of co-rotated stress to the tenth turn", finest.stress_change,
                 "", 0.0, 0.0, 0.05, "goes with the square of speed: 5 % as the kinetic energy"));
  std::optional<Simulation> control;
  Scene plain = turning(run.scene_at(spacings.front(), "modern"), 2.0);
  plain.numerics.gradient_correction = false;
  const Outcome stopped = turned(run, "modern 2D, gradient not corrected", plain, control);
  run.add(within("modern 2D, gradient not corrected: kinetic energy after 2 turns",
                 stopped.kinetic_last, "", {}, 0.0, 0.95,
                 "the band above must bite: truncated sums take rotation for strain"));
}

/// `paper` has stopped after two turns.
void paper_disc(CaseRun& run, std::optional<Simulation>& last) {
  const std::vector<double> spacings =
      run.spacings(run.options().form == Form::full ? std::vector{0.1, 0.05} : std::vector{0.1});
  const double turns = run.short_form() ? 2.0 : 10.0;
  for (const double spacing : spacings) {
    const Scene scene = turning(run.scene_at(spacing, "paper"), turns);
    const std::string name = fmt::format("paper 2D, dx = {} m", spacing);
    const Outcome outcome = turned(run, name, scene, last);
    judge_motion(run, name + ": ", outcome, turns, false);
    run.add(reported(name + ": rms error of co-rotated stress, first turn", outcome.stress_first,
                     "", "the disc is slower than the closed form's"));
  }
}

void cylinder(CaseRun& run, const std::string& preset, std::optional<Simulation>& last) {
  const double turns = preset == "paper" ? 2.0 : 10.0;
  for (const double spacing : run.spacings(
           run.options().form == Form::full ? std::vector{0.2, 0.125} : std::vector{0.2})) {
    const Scene scene = turning(cylinder_scene(run.scene_at(spacing, preset)), turns);
    const std::string name = fmt::format("{} 3D, dx = {} m", preset, spacing);
    judge_motion(run, name + ": ", turned(run, name, scene, last), turns, preset != "paper");
  }
}

double outcome_of(CaseRun& run, const Scene& scene) {
  std::optional<Simulation> simulation;
  return turned(run, "disc", turning(scene, 1.0), simulation).stress_first;
}

}  // namespace

const ErrorProblem disc_rotation_problem{
    "rms error of co-rotated stress in the first turn", {0.2, 0.1, 0.05, 0.025}, outcome_of};

void disc_rotation(CaseRun& run) {
  std::optional<Simulation> last;
  for (const std::string& preset : run.presets()) {
    if (!run.short_form()) cylinder(run, preset, last);
    if (preset == "paper") {
      paper_disc(run, last);
    } else {
      modern_disc(run, last);
    }
  }
  run.finish(&*last);
}

}  // namespace scarp::validation
