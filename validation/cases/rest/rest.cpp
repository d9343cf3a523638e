// SPDX-License-Identifier: BSD-3-Clause
/// Soil at rest against a smooth wall, and the wall pulled away or pushed in until the soil yields.

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

#include "engine/scene/facets.hpp"
#include "validation/case_list.hpp"
#include "validation/convergence.hpp"
#include "validation/extruded.hpp"

namespace scarp::validation {
namespace {

constexpr std::size_t base = 0, retaining = 1, far = 2;  ///< walls of the scene

/// Layer of soil with a horizontal surface between smooth walls.
struct Layer {
  double unit_weight, height, length, depth, k0;

  explicit Layer(const Scene& scene) {
    const Material& soil = scene.materials.front();
    const Box& box = std::get<Box>(scene.bodies.front().shape);
    unit_weight = -soil.density * scene.gravity[1];
    height = box.maximum[1];
    length = box.maximum[0] - box.minimum[0];
    depth = scene.dimension == 3 ? box.maximum[2] : 1.0;
    k0 = soil.model.parameter("poisson_ratio") / (1.0 - soil.model.parameter("poisson_ratio"));
  }
  double thrust() const { return 0.5 * unit_weight * height * height * depth; }  ///< for K = 1 [N]
  double weight() const { return unit_weight * height * length * depth; }
};

/// Major over minor stress of yielding soil without cohesion in plane strain: 1 + 6 a w/(1 - 3 a (w
/// + b)), a = alpha_phi, b = alpha_psi, w = sqrt(1 - 3 b^2). With psi = phi that is Rankine's K_p,
/// tan^2(45 deg + phi/2); with psi = 0 it is (1 + 3 a)/(1 - 3 a), less than K_p.
double passive_coefficient(const Material& soil) {
  const auto alpha = [](double angle) {
    const double t = std::tan(angle);
    return t / std::sqrt(9.0 + 12.0 * t * t);
  };
  const double a = alpha(soil.model.parameter("friction_angle")),
               b = alpha(soil.model.parameter("dilation_angle"));
  const double w = std::sqrt(1.0 - 3.0 * b * b);
  return 1.0 + 6.0 * a * w / (1.0 - 3.0 * a * (w + b));
}

struct AtRest {
  double wall = 0.0, floor = 0.0;                   ///< force over K0 gamma H^2/2, over the weight
  double vertical = 0.0, horizontal = 0.0;          ///< stress over gamma z, K0 gamma z
  double vertical_rms = 0.0, horizontal_rms = 0.0;  ///< what is left, over gamma H, K0 gamma H
  double fastest = 0.0;                             ///< undamped, in the last half [m/s]
  double lattice_moment = 1.0;
  bool normalised = true, settled = false;
};

/// Best factor on the exact profile and the rms of the rest, over the largest value of the profile.
std::pair<double, double> against_profile(const Simulation& simulation, std::size_t component,
                                          double gradient) {
  const double height = Layer(simulation.scene()).height;
  const std::vector<double> position = simulation.field("position"),
                            stress = simulation.field("stress");
  double product = 0.0, square = 0.0, rest = 0.0;
  for (std::size_t i = 0; i < simulation.soil_count(); ++i) {
    const double exact = gradient * (height - position[3 * i + 1]);
    product += stress[6 * i + component] * exact;
    square += exact * exact;
  }
  const double factor = product / square;
  for (std::size_t i = 0; i < simulation.soil_count(); ++i) {
    rest +=
        std::pow(stress[6 * i + component] - factor * gradient * (height - position[3 * i + 1]), 2);
  }
  return {factor, std::sqrt(rest / static_cast<double>(simulation.soil_count())) /
                      std::fabs(gradient * height)};
}

/// Settles, then stands without damping.
AtRest rest_of(CaseRun& run, const std::string& name, Simulation& simulation) {
  const Layer layer(simulation.scene());
  AtRest at;
  run.run_stage(name + ", settle", simulation);
  at.settled = simulation.stage_reached_rest();
  const double half = 0.5 * simulation.scene().stages[1].duration.value();
  run.run_stage(name + ", stand", simulation, nullptr, [&](const Simulation& now) {
    if (now.last_step().stage_time > half)
      at.fastest = std::fmax(at.fastest, now.last_step().max_velocity);
  });
  const std::vector<WallReaction> reactions = simulation.wall_reactions();
  at.wall = -reactions[retaining].force[0] / (layer.k0 * layer.thrust());
  at.floor = -reactions[base].force[1] / layer.weight();
  std::tie(at.vertical, at.vertical_rms) = against_profile(simulation, 1, -layer.unit_weight);
  std::tie(at.horizontal, at.horizontal_rms) =
      against_profile(simulation, 0, -layer.k0 * layer.unit_weight);
  at.lattice_moment = simulation.lattice_moment();
  at.normalised = simulation.scene().numerics.lattice_normalisation;
  return at;
}

void judge_rest(CaseRun& run, const std::string& who, bool in_space, const AtRest& at,
                const std::vector<ErrorAtSpacing>& walls) {
  const double stress = at.normalised ? 1.0 : 1.0 / at.lattice_moment;
  const std::string profile = at.normalised ? "2 %" : "1/M of the lattice, 2 %";
  run.add(holds(who + "came to rest", at.settled, "slower than 1e-5 m/s"));
  run.add(within(who + "fastest particle without damping", at.fastest, "m/s", 0.0, 0.0, 1e-3,
                 "1 mm/s: what counts as rest"));
  run.add(within(who + "force on the base over the weight", at.floor, "", 1.0, 0.98, 1.02,
                 "equilibrium, 2 %"));
  run.add(within(who + "vertical stress over gamma z", at.vertical, "", stress, 0.98 * stress,
                 1.02 * stress, profile));
  run.add(within(who + "horizontal stress over K0 gamma z", at.horizontal, "", stress,
                 0.98 * stress, 1.02 * stress, profile));
  run.add(within(who + "rms of the rest, vertical", at.vertical_rms, "", 0.0, 0.0, 0.02,
                 "over gamma H, 2 %"));
  run.add(within(who + "rms of the rest, horizontal", at.horizontal_rms, "", 0.0, 0.0, 0.02,
                 "over K0 gamma H, 2 %"));
  // In 3D most images stand behind two walls at once and are booked to the later one.
  if (in_space) {
    run.add(reported(who + "force on the wall over K0 gamma H^2/2", at.wall, "",
                     "images behind two walls are booked to the other"));
  } else {
    judge_convergence(run, who + "force on the wall over K0 gamma H^2/2 - 1", walls,
                      {0.02, {}, "K0 = nu/(1 - nu), 2 %"});
  }
}

/// The layer cut to 2 m: where nothing varies along it, its length does not matter.
void narrow(Scene& scene) {
  std::get<Box>(scene.bodies.front().shape).maximum[0] = 2.0;
  scene.walls[far].facets = line_facets({{2, 0}, {2, 5}});
}

enum class Pressure { active, passive };

/// The wall moves until the soil yields; on a smooth base the whole layer does, and equally.
Scene yielding(Scene scene, Pressure pressure, bool smooth_base, double dilation) {
  scene.materials.front().model.set("dilation_angle", dilation);
  scene.stages.erase(scene.stages.begin() + 1);
  if (smooth_base) {
    scene.walls[base].kind = WallKind::free_slip;
    narrow(scene);
  }
  if (pressure == Pressure::passive) {
    // K_p gamma H (1 - nu^2) L/E = 21 mm brings the foot of the wall to yield.
    scene.walls[retaining].velocity[0] = 0.004;
    scene.stages.back().duration = 7.5;
  }
  return scene;
}

/// Force on the wall over that of a coefficient 1: g m y_c/L, with m and y_c mass and height of the
/// centre of mass and L the length as they are now; that is the integral of the vertical stress.
double pressure_coefficient(const Simulation& simulation) {
  const Scene& scene = simulation.scene();
  const Layer layer(scene);
  const std::vector<double> position = simulation.field("position");
  double centre = 0.0;
  for (std::size_t k = 1; k < position.size(); k += 3) centre += position[k];
  centre /= static_cast<double>(simulation.soil_count());
  const double moved = scene.walls[retaining].velocity[0] * simulation.last_step().stage_time;
  return -simulation.wall_reactions()[retaining].force[0] /
         (layer.weight() * centre / (layer.length - moved));
}

/// The same where soil that does not dilate fails along bands, with tan phi* = sin phi' on them
/// instead of the coaxial sin phi'. Source: Davis (1968), Drescher and Detournay (1993), for psi =
/// 0.
double passive_coefficient_in_bands(double coaxial) {
  const double sine = (coaxial - 1.0) / (coaxial + 1.0), angle = std::atan(sine);
  return (1.0 + std::sin(angle)) / (1.0 - std::sin(angle));
}

void judge_pressure(CaseRun& run, const std::string& preset, double spacing, Pressure pressure,
                    bool smooth_base, bool dilatant, std::optional<Simulation>& last) {
  Scene scene = run.scene_at(spacing, preset);
  const double dilation =
      dilatant ? scene.materials.front().model.parameter("friction_angle") : 0.0;
  scene = yielding(std::move(scene), pressure, smooth_base, dilation);
  const double passive = passive_coefficient(scene.materials.front());
  const double weakest = dilatant ? passive : passive_coefficient_in_bands(passive);
  const bool active = pressure == Pressure::active;
  const double expected = active ? 1.0 / passive : passive;
  const double lowest = active ? 1.0 : weakest / passive;
  const double highest = active ? passive / weakest : 1.0;
  const std::string band = dilatant ? "3 %: 2 % as at rest, 1 % for damping and wall speed"
                                    : "from coaxial flow to bands, 3 %";
  const std::string name = fmt::format("{} 2D, dx = {} m, {} pressure, {} base, psi = {}", preset,
                                       spacing, active ? "active" : "passive",
                                       smooth_base ? "smooth" : "rough", dilatant ? "phi" : "0");
  last = run.solve(name, scene);
  const auto add = [&](const std::string& what, double coefficient, bool judged) {
    const std::string title = fmt::format("{}: {} over {:.4f}", name, what, expected);
    run.add(
        judged ? within(title, coefficient / expected, "", 1.0, lowest - 0.03, highest + 0.03, band)
               : reported(title, coefficient / expected, ""));
  };
  const std::vector<double> stress = last->field("stress");
  double horizontal = 0.0, vertical = 0.0;
  for (std::size_t k = 0; k < stress.size(); k += 6) {
    horizontal += stress[k];
    vertical += stress[k + 1];
  }
  if (smooth_base) add("horizontal over vertical stress", horizontal / vertical, true);
  // The corner's images are booked to one of its walls: an error of the order of dx/H.
  add("force on the wall", pressure_coefficient(*last), !run.short_form());
}

}  // namespace

void rest(CaseRun& run) {
  // The short form keeps the finer of the two: the band of the force on the wall needs it.
  const std::vector<double> spacings =
      run.short_form() ? run.spacings({0.1}) : run.spacings({0.2, 0.1, 0.05});
  std::optional<Simulation> last;
  for (const std::string& preset : run.presets()) {
    for (const int dimension : {2, 3}) {
      if (dimension == 3 && preset == "paper" && run.short_form()) continue;
      const std::string who = fmt::format("{} {}D: ", preset, dimension);
      std::vector<ErrorAtSpacing> walls;
      AtRest finest;
      for (const double spacing : spacings) {
        if (dimension == 3 && spacing < 0.07) continue;
        Scene scene = run.scene_at(spacing, preset);
        scene.stages.pop_back();
        narrow(scene);
        scene.walls[retaining].velocity = {};
        scene.walls[retaining].moves_from.clear();
        if (dimension == 3) scene = extruded(std::move(scene), 4.0 * spacing);
        last.emplace(scene, run.options().run);
        finest = rest_of(run, fmt::format("{}dx = {} m", who, spacing), *last);
        walls.push_back({spacing, finest.wall - 1.0});
      }
      judge_rest(run, who, dimension == 3, finest, walls);
    }
    if (run.short_form() && preset == "paper") continue;  // its steps are short, its runs long
    for (const double spacing : run.spacings({0.2, 0.1})) {
      for (const Pressure pressure : {Pressure::active, Pressure::passive}) {
        for (const bool dilatant : {true, false})
          judge_pressure(run, preset, spacing, pressure, true, dilatant, last);
      }
      if (!run.short_form())
        judge_pressure(run, preset, spacing, Pressure::active, false, true, last);
    }
  }
  run.finish(&*last);
}

}  // namespace scarp::validation
