// SPDX-License-Identifier: BSD-3-Clause
/// Displacement, stress and wall forces of a layer sheared between rough plates.

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <optional>

#include "validation/case_list.hpp"
#include "validation/convergence.hpp"
#include "validation/extruded.hpp"

namespace scarp::validation {
namespace {

/// Layer of height H, at rest below and drawn along at speed U above, with the damping c of the
/// scene: u_tt + c u_t = c_s^2 u_yy. Once the waves have gone, u = U t y/H - c U (H^2 y - y^3)/(6
/// c_s^2 H): the velocity is linear, the displacement but for what the damping holds back.
struct ShearedLayer {
  double height, speed, shear_modulus, damping, wave_speed, time;

  ShearedLayer(const Scene& scene, double now) : time(now) {
    const Material& soil = scene.materials.front();
    height = std::get<Box>(scene.bodies.front().shape).maximum[1];
    speed = scene.walls[1].velocity[0];
    shear_modulus = soil.model.parameter("youngs_modulus") /
                    (2.0 * (1.0 + soil.model.parameter("poisson_ratio")));
    damping = scene.stages.front().damping.value();
    wave_speed = std::sqrt(shear_modulus / soil.density);
  }
  double displacement(double y) const {
    return speed * y / height *
           (time - damping * (height * height - y * y) / (6.0 * wave_speed * wave_speed));
  }
  double stress(double y) const {
    return shear_modulus * speed / height *
           (time - damping * (height * height - 3.0 * y * y) / (6.0 * wave_speed * wave_speed));
  }
};

struct Outcome {
  double displacement =
      0.0;                ///< L2 error over the L2 norm of the exact profile, middle of the layer
  double velocity = 0.0;  ///< the same of the velocity
  double stress = 0.0;    ///< mean shear stress over the exact one, middle of the layer
  double scatter = 0.0;   ///< rms of the shear stress about the exact one, over it
  std::array<double, 2> force{};  ///< on the fixed and the moving wall, along x [N/m, 3D: N]
};

/// The middle is as wide as the layer is high; its free ends are several heights away.
Outcome measure(const Simulation& sheared) {
  const ShearedLayer exact(sheared.scene(), sheared.last_step().time);
  const std::vector<double> position = sheared.field("position"),
                            displacement = sheared.field("displacement"),
                            velocity = sheared.field("velocity"), stress = sheared.field("stress");
  double squares = 0.0, norm = 0.0, speeds = 0.0, speed_norm = 0.0, mean = 0.0, exact_mean = 0.0,
         stresses = 0.0;
  for (std::size_t i = 0; i < sheared.soil_count(); ++i) {
    if (std::fabs(position[3 * i]) > 0.5 * exact.height) continue;
    const double y = position[3 * i + 1] - displacement[3 * i + 1];
    const double u = exact.displacement(y), v = exact.speed * y / exact.height;
    squares += std::pow(displacement[3 * i] - u, 2) + std::pow(displacement[3 * i + 1], 2);
    norm += u * u;
    speeds += std::pow(velocity[3 * i] - v, 2) + std::pow(velocity[3 * i + 1], 2);
    speed_norm += v * v;
    mean += stress[6 * i + 3];
    exact_mean += exact.stress(y);
    stresses += std::pow(stress[6 * i + 3] / exact.stress(y) - 1.0, 2);
  }
  const auto count = exact_mean / exact.stress(exact.height / std::sqrt(3.0));
  Outcome outcome;
  outcome.displacement = std::sqrt(squares / norm);
  outcome.velocity = std::sqrt(speeds / speed_norm);
  outcome.stress = mean / exact_mean;
  outcome.scatter = std::sqrt(stresses / count);
  const std::vector<WallReaction> reactions = sheared.wall_reactions();
  outcome.force = {reactions[0].force[0], reactions[1].force[0]};
  return outcome;
}

/// The layer cut to a length, in 3D to four spacings of depth as well.
Scene layer(Scene scene, double length, int dimension) {
  Box& box = std::get<Box>(scene.bodies.front().shape);
  box.minimum[0] = -0.5 * length;
  box.maximum[0] = 0.5 * length;
  const double depth = 4.0 * scene.spacing;
  return dimension == 2 ? scene : extruded(std::move(scene), depth);
}

/// Force per length far from the ends, over the closed form: the ends of a long and a short layer
/// carry equally less, so that the difference of the two is free of them.
double force_ratio(const Scene& scene, double now, double longer, double shorter, double lengths,
                   bool moving) {
  const ShearedLayer exact(scene, now);
  const double depth = scene.dimension == 3 ? 4.0 * scene.spacing : 1.0;
  // The wall holds the layer back below and drags it along above.
  const double expected = moving ? -exact.stress(exact.height) : exact.stress(0.0);
  return (longer - shorter) / (lengths * depth * expected);
}

/// A layer whose walls act as if they stood up to half a spacing back is up to dx thicker: its
/// displacement errs by up to dx/H, its stress is lower by as much.
void judge(CaseRun& run, const std::string& who, double stiffness,
           const std::vector<ErrorAtSpacing>& displacements, const Outcome& finest,
           const std::array<double, 2>& forces, double layer_share) {
  judge_convergence(run, who + "L2 error of displacement", displacements,
                    {layer_share, 0.9, "dx/H: each wall is known to half a spacing"});
  if (run.options().form == Form::full) {
    run.add(within(who + "L2 error of displacement, finest spacing", displacements.back().error, "",
                   0.0, 0.0, 0.01, "1 %"));
  }
  run.add(within(who + "L2 error of velocity", finest.velocity, "", 0.0, 0.0, layer_share, "dx/H"));
  const auto add = [&](const std::string& name, double value, double exact) {
    run.add(within(
        who + name, value, "", exact, exact * (1.0 - layer_share) - 0.01 * exact, 1.01 * exact,
        stiffness == 1.0 ? "dx/H less, 1 %" : "of the lattice moment M, dx/H less, 1 %"));
  };
  add("shear stress over G gamma", finest.stress, std::sqrt(stiffness));
  run.add(reported(who + "rms scatter of shear stress", finest.scatter, ""));
  add("force on the fixed wall over G gamma", forces[0], stiffness);
  add("force on the moving wall over G gamma", forces[1], stiffness);
}

/// One preset in one dimension; `tension` keeps the preset's artificial stress.
void series(CaseRun& run, const std::string& preset, int dimension, bool tension,
            std::optional<Simulation>& last) {
  const std::string who =
      fmt::format("{} {}D{}: ", preset, dimension, tension ? "" : ", no artificial stress");
  std::vector<ErrorAtSpacing> displacements;
  Outcome finest;
  std::array<double, 2> forces{};
  double stiffness = 1.0, layer_share = 0.0;
  for (const double spacing :
       run.spacings(dimension == 2                     ? std::vector{0.1, 0.05, 0.025}
                    : run.options().form == Form::full ? std::vector{0.1, 0.05}
                                                       : std::vector{0.1})) {
    Scene scene = run.scene_at(spacing, preset);
    if (!tension) scene.numerics.artificial_stress = 0.0;
    const Box& box = std::get<Box>(scene.bodies.front().shape);
    const double length = box.maximum[0] - box.minimum[0];
    layer_share = spacing / box.maximum[1];
    const std::string name = fmt::format("{}dx = {} m", who, spacing);
    const Outcome half =
        measure(run.solve(name + ", half as long", layer(scene, 0.5 * length, dimension)));
    last = run.solve(name, layer(scene, length, dimension));
    finest = measure(*last);
    displacements.push_back({spacing, finest.displacement});
    for (const std::size_t wall : {0, 1}) {
      forces[wall] = force_ratio(last->scene(), last->last_step().time, finest.force[wall],
                                 half.force[wall], 0.5 * length, wall == 1);
    }
    if (!scene.numerics.lattice_normalisation)
      stiffness = last->lattice_moment() * last->lattice_moment();
  }
  if (preset == "paper" && tension) {
    run.add(reported(who + "L2 error of displacement", finest.displacement, "",
                     "artificial stress on the tension of shear feeds the first layers"));
    return;
  }
  judge(run, who, stiffness, displacements, finest, forces, layer_share);
}

}  // namespace

void couette(CaseRun& run) {
  std::optional<Simulation> last;
  for (const std::string& preset : run.presets()) {
    series(run, preset, 2, true, last);
    if (preset == "paper") {
      series(run, preset, 2, false, last);
    } else if (!run.short_form()) {
      series(run, preset, 3, true, last);
    }
  }
  run.finish(&*last);
}

}  // namespace scarp::validation
