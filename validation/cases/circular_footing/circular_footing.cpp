// SPDX-License-Identifier: BSD-3-Clause
/// Bearing capacity of a smooth circular footing on heavy soil against Cox's slip lines.

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "engine/output/text_file.hpp"
#include "validation/case_list.hpp"
#include "validation/convergence.hpp"

namespace scarp::validation {
namespace {

constexpr double radius = 1.0;              ///< [m]
constexpr double speed = 0.01;              ///< of the footing [m/s]
constexpr double limit_pressure = 225.6e3;  ///< Cox (1962): 141 c for gamma R/c = 10, phi = 30 deg
/// Settlement over R where the pressure is judged, the end of the push.
constexpr double judged_from = 0.0015, judged_to = 0.002;

/// The quarter of the footing in x, y >= 0, in strips one spacing wide.
Wall footing(double spacing, double level) {
  Wall wall;
  wall.name = "footing";
  wall.kind = WallKind::free_slip;
  wall.velocity = {0.0, 0.0, -speed};
  wall.moves_from = "push";
  const int strips = static_cast<int>(std::lround(radius / spacing));
  for (int k = 0; k < strips; ++k) {
    const double middle = (k + 0.5) * spacing;
    const double reach = std::sqrt(radius * radius - middle * middle);
    wall.facets.push_back({{0.0, k * spacing, level},
                           {0.0, 1.0, 0.0},
                           {1.0, 0.0, 0.0},
                           spacing,
                           reach,
                           {0.0, 0.0, -1.0}});
  }
  return wall;
}

double area(const Wall& footing) {
  double sum = 0.0;
  for (const Facet& facet : footing.facets) sum += facet.length_u * facet.length_v;
  return sum;
}

/// Mean pressure under the footing over Cox's.
struct Push {
  double before = 0.0;  ///< over a settlement just as long before
  double level = 0.0;   ///< where it is judged
};

/// Pushes the footing and writes its pressure as a table.
Push press(CaseRun& run, const std::string& name, Scene scene, std::optional<Simulation>& last) {
  const double level = std::get<Box>(scene.bodies.front().shape).maximum[2];
  scene.walls.push_back(footing(scene.spacing, level));
  const double capacity = area(scene.walls.back()) * limit_pressure;
  CsvFile table(run.folder() / (name + ".csv"),
                {"settlement over R [-]", "pressure over Cox's [-]"});
  last.emplace(scene, run.options().run);
  run.run_stage(name + ", settle", *last);
  const double start = last->last_step().time;
  std::array<double, 2> sums{}, counts{};
  double next = 0.0;
  run.run_stage(name, *last, nullptr, [&](const Simulation& now) {
    const double settlement = speed * (now.last_step().time - start) / radius;
    if (settlement < next) return;
    next += judged_to / 250.0;
    const double ratio = now.wall_reactions().back().force[2] / capacity;
    table << settlement << ratio;
    table.end_row();
    if (settlement < 2.0 * judged_from - judged_to) return;
    const std::size_t window = settlement < judged_from ? 0 : 1;
    sums[window] += ratio;
    counts[window] += 1.0;
  });
  return {sums[0] / counts[0], sums[1] / counts[1]};
}

}  // namespace

void circular_footing(CaseRun& run) {
  std::optional<Simulation> last;
  std::vector<ErrorAtSpacing> errors;
  Push push;
  for (const double spacing : run.spacings({0.2, 0.1, 1.0 / 15.0})) {
    const std::string name = fmt::format("dx_{:.3g}", spacing);
    push = press(run, name, run.scene_at(spacing, run.options().preset), last);
    errors.push_back({spacing, push.level - 1.0});
    run.add(reported(fmt::format("dx = {:.3g} m: pressure", spacing),
                     push.level * limit_pressure / 1e3, "kPa", "225.6 kPa by Cox"));
  }
  const double wider = 1.0 + 0.5 * errors.back().spacing / radius;
  run.add(within("pressure over Cox's, finest spacing", push.level, "", 1.0, 0.95,
                 1.05 * wider * wider, "5 %, and a footing wider by half a spacing all around"));
  run.add(reported("its change over 0.05 % of R", push.level / push.before - 1.0, ""));
  if (errors.size() > 1) {
    const ErrorAtSpacing coarse = errors[errors.size() - 2], fine = errors.back();
    const double limit =
        fine.error - (coarse.error - fine.error) * fine.spacing / (coarse.spacing - fine.spacing);
    run.add(within("pressure over Cox's, in a straight line to dx = 0", 1.0 + limit, "", 1.0, 0.95,
                   1.05, "5 %, as finite elements keep"));
  }
  run.add(ConvergenceSeries{"pressure over Cox's - 1", errors, observed_order(errors)});
  run.finish(&*last);
}

}  // namespace scarp::validation
