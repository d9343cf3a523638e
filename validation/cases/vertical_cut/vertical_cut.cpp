// SPDX-License-Identifier: BSD-3-Clause
/// A vertical cut below and above its critical height.

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <optional>

#include "validation/case_list.hpp"
#include "validation/convergence.hpp"

namespace scarp::validation {
namespace {

constexpr double height = 5.0;                          // [m]
constexpr double failing_displacement = 0.01 * height;  // [m]

/// gamma H/c at the limit: the circle of Taylor for phi = 0, the plane wedge above that.
double critical_number(double friction_angle) {
  if (friction_angle == 0.0) return 3.83;
  return 4.0 * std::tan(0.25 * std::numbers::pi + 0.5 * friction_angle);
}

/// The scene with gamma H/c as given, through c, and psi = phi.
Scene cut_scene(Scene scene, double friction_angle, double number) {
  Material& clay = scene.materials.front();
  const double unit_weight = -clay.density * scene.gravity[1];
  clay.model.set("cohesion", unit_weight * height / number);
  clay.model.set("friction_angle", friction_angle);
  clay.model.set("dilation_angle", friction_angle);
  return scene;
}

/// Displacement of the upper edge at the end of the stage, or when it has passed the criterion.
double edge_displacement(CaseRun& run, const std::string& name, const Scene& scene,
                         std::optional<Simulation>& last) {
  last.emplace(scene, run.options().run);
  run.run_stage(name + ", settle", *last);
  double displacement = 0.0;
  run.run_stage(name, *last, nullptr, [&](const Simulation& now) {
    const Vec3& moved = now.probe(0).displacement;
    displacement = std::hypot(moved[0], moved[1]);
    if (displacement > 2.0 * failing_displacement) last->end_stage();
  });
  return displacement;
}

/// The wider of the two numbers fails, the narrower stands: bisection to 3 %.
double critical(CaseRun& run, const std::string& who, double friction_angle, const Scene& scene,
                std::optional<Simulation>& last) {
  double low = 0.8, high = 1.25;
  const double number = critical_number(friction_angle);
  while (high - low > 0.03) {
    const double middle = 0.5 * (low + high);
    const double displacement =
        edge_displacement(run, fmt::format("{}{:.3f} Hc", who, middle),
                          cut_scene(scene, friction_angle, middle * number), last);
    (displacement > failing_displacement ? high : low) = middle;
  }
  return 0.5 * (low + high) * number;
}

}  // namespace

void vertical_cut(CaseRun& run) {
  const std::vector<double> spacings = run.spacings({0.25, 0.125, 0.0625});
  std::optional<Simulation> last;
  for (const std::string& preset : run.presets()) {
    for (const double degrees : {0.0, 20.0}) {
      const double friction = degrees * std::numbers::pi / 180.0;
      for (const double spacing : spacings) {
        const std::string who =
            fmt::format("{}, phi = {} deg, dx = {} m: ", preset, degrees, spacing);
        const Scene scene = run.scene_at(spacing, preset);
        const double number = critical_number(friction);
        const double stands =
            edge_displacement(run, who + "0.8 Hc", cut_scene(scene, friction, 0.8 * number), last);
        const double falls = edge_displacement(run, who + "1.25 Hc",
                                               cut_scene(scene, friction, 1.25 * number), last);
        run.add(within(who + "edge displacement at 0.8 Hc", stands, "m", 0.0, 0.0,
                       failing_displacement, "stands: below 1 % of the height"));
        run.add(within(who + "edge displacement at 1.25 Hc", falls, "m", {}, failing_displacement,
                       height, "fails: over 1 % of the height"));
        if (run.short_form()) continue;
        run.add(reported(who + "critical gamma H/c", critical(run, who, friction, scene, last), "",
                         fmt::format("{:.3g} by theory; to 1.5 %", number)));
      }
    }
  }
  run.finish(&*last);
}

}  // namespace scarp::validation
