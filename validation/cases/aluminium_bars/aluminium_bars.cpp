// SPDX-License-Identifier: BSD-3-Clause
/// Final surface and failure line of a collapsed stack of bars against the experiment.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/errors.hpp"
#include "validation/case_list.hpp"
#include "validation/column_collapse.hpp"
#include "validation/convergence.hpp"
#include "validation/deposit.hpp"

namespace scarp::validation {
namespace {

constexpr double column_width = 0.01;    ///< [m]
constexpr double moved = 1e-3;           ///< displacement in x of moved soil [m]
constexpr double bar_diameter = 1.5e-3;  ///< of the thicker bars [m]

Profile published(const std::string& name) {
  return read_profile(data_folder() / "cases/aluminium_bars" / name);
}

struct Deposit {
  double lost = 0.0;               ///< share of the soil that went through a wall
  double surface_error = 0.0;      ///< area between the surfaces over the area of the deposit
  double line_distance = 0.0;      ///< of the published failure line from that of the run [m]
  double line_distance_5 = 0.0;    ///< the same for soil moved by five times as much [m]
  double run_out = 0.0;            ///< (L - L0)/L0, L the 99.5 % quantile
  double connected_run_out = 0.0;  ///< the same to the end of the connected deposit
  double run_out_before = 0.0;     ///< the same some time before the end
  double viscous_share = 0.0;      ///< of what the collapse dissipates
  Profile surface, failure_line;
};

/// The 99.5 % quantile of the soil, at the edge of its particle [m].
double front(const Simulation& now) {
  const std::vector<double> position = now.field("position");
  std::vector<double> x;
  for (std::size_t i = 0; i < position.size(); i += 3) x.push_back(position[i]);
  return quantile(std::move(x), 0.995) + 0.5 * now.scene().spacing;
}

/// End of the soil that is held together [m].
double connected_front(const Simulation& now) {
  const std::vector<double> position = now.field("position");
  const double spacing = now.scene().spacing;
  double end = 0.0;
  for (const std::size_t i : main_body(position, 1.5 * spacing)) {
    end = std::max(end, position[3 * i] + 0.5 * spacing);
  }
  return end;
}

/// Surface of the soil that has not moved by more than `least` in x.
Profile unmoved_surface(const Simulation& fallen, double least) {
  const std::vector<double> position = fallen.field("position"),
                            displacement = fallen.field("displacement");
  std::vector<double> x;
  for (std::size_t i = 0; i < position.size(); i += 3) {
    if (displacement[i] <= least) x.push_back(position[i]);
  }
  return column_profile(x, fallen.scene().spacing, column_width);
}

Deposit measure(const Simulation& fallen) {
  const Scene& scene = fallen.scene();
  const Box& stack = std::get<Box>(scene.bodies.front().shape);
  const std::vector<double> position = fallen.field("position");
  std::vector<double> x;
  Deposit deposit;
  for (std::size_t i = 0; i < position.size(); i += 3) {
    x.push_back(position[i]);
  }
  deposit.lost = share_through_walls(position, 2, scene.spacing);
  deposit.surface = column_profile(x, scene.spacing, column_width);
  deposit.surface_error = area_between(deposit.surface, published("bui_2008_surface.csv")) /
                          (stack.maximum[0] * stack.maximum[1]);
  deposit.failure_line = unmoved_surface(fallen, moved);
  const Profile line = published("bui_2008_failure_line.csv");
  deposit.line_distance = mean_distance(line, deposit.failure_line);
  deposit.line_distance_5 = mean_distance(line, unmoved_surface(fallen, 5.0 * moved));
  deposit.run_out = front(fallen) / stack.maximum[0] - 1.0;
  deposit.connected_run_out = connected_front(fallen) / stack.maximum[0] - 1.0;
  return deposit;
}

/// Steps through both stages; the front is looked at once more sqrt(H/g) before the end.
Deposit collapse(CaseRun& run, const std::string& name, Simulation& simulation, RunWriter* writer) {
  const Scene& scene = simulation.scene();
  const double height = std::get<Box>(scene.bodies.front().shape).maximum[1];
  const double late = scene.stages.back().duration.value() - std::sqrt(height / -scene.gravity[1]);
  std::optional<double> before;
  run.run_stage(name + ", settle", simulation, writer);
  run.run_stage(name, simulation, writer, [&](const Simulation& now) {
    if (!before && now.last_step().stage_time >= late) before = front(now);
  });
  Deposit deposit = measure(simulation);
  deposit.viscous_share = viscous_share(simulation);
  deposit.run_out_before = *before / std::get<Box>(scene.bodies.front().shape).maximum[0] - 1.0;
  return deposit;
}

void judge(CaseRun& run, const std::string& who, const std::vector<double>& spacings,
           const std::vector<Deposit>& deposits, double length) {
  const Deposit& finest = deposits.back();
  // One lost grain in 800 would leave the short form without a verdict on anything else.
  const std::string lost = who + "share of the soil lost through walls";
  const double most_lost =
      std::max_element(deposits.begin(), deposits.end(), [](const Deposit& a, const Deposit& b) {
        return a.lost < b.lost;
      })->lost;
  if (run.short_form()) {
    run.add(reported(lost, most_lost, "", "judged in the main form"));
  } else {
    run.add(within(lost, most_lost, "", 0.0, 0.0, 0.0,
                   "mass is conserved; at all spacings, more than a spacing behind a wall"));
  }
  run.add(within(who + "advance of the front in the last sqrt(H/g)",
                 (finest.run_out - finest.run_out_before) * length, "m", 0.0, -spacings.back(),
                 spacings.back(), "at rest: less than a spacing"));
  std::vector<ErrorAtSpacing> errors;
  for (std::size_t k = 0; k < spacings.size(); ++k) {
    errors.push_back({spacings[k], deposits[k].surface_error});
  }
  judge_convergence(run, who + "area between surfaces over that of the deposit", errors,
                    {0.08, {}, "Bui et al. 2008: 8 %, of which 1.5 % is the digitised area"});
  const double band = 5.0 * bar_diameter;
  run.add(within(who + "mean distance of the failure lines", finest.line_distance, "m", 0.0, 0.0,
                 band, "Bui et al. 2008: half a shear band of ten bars"));
  run.add(reported(who + "the same for soil moved by 5 mm", finest.line_distance_5, "m"));
  for (std::size_t k = 0; k < spacings.size(); ++k) {
    run.add(reported(fmt::format("{}run-out (L - L0)/L0, dx = {:.4g} m", who, spacings[k]),
                     deposits[k].run_out, "",
                     fmt::format("connected deposit {:.3f}; last published point 1.21",
                                 deposits[k].connected_run_out)));
    run.add(reported(
        fmt::format(
            "{}share of the artificial viscosity in what the collapse dissipates, dx = {:.4g} m",
            who, spacings[k]),
        deposits[k].viscous_share, ""));
  }
}

double outcome_of(CaseRun& run, const Scene& scene) {
  return measure(run.solve("bars", scene)).surface_error;
}

}  // namespace

const ErrorProblem aluminium_bars_problem{
    "area between the final surface and the experiment's over that of the deposit",
    {0.01, 0.005, 0.0025, 0.00125},
    outcome_of};

void aluminium_bars(CaseRun& run) {
  const std::vector<double> spacings = run.spacings({0.005, 0.0025, 0.00125});
  std::vector<std::string> presets = run.presets();
  if (run.short_form()) presets.resize(1);
  std::optional<Simulation> shown;
  for (const std::string& preset : presets) {
    std::vector<Deposit> deposits;
    double length = 0.0;
    for (const double spacing : spacings) {
      const Scene scene = run.scene_at(spacing, preset);
      length = std::get<Box>(scene.bodies.front().shape).maximum[0];
      const std::string name = fmt::format("{}, dx = {} m", preset, spacing);
      Simulation simulation(scene, run.options().run);
      const bool show = preset == presets.front() && spacing == spacings.back();
      std::optional<RunWriter> writer;
      if (show) writer.emplace(simulation, run.folder());
      deposits.push_back(collapse(run, name, simulation, writer ? &*writer : nullptr));
      if (!show) continue;
      writer->finish(simulation, 0.0);
      shown = std::move(simulation);
    }
    judge(run, preset + ": ", spacings, deposits, length);
    write_profile(run.folder() / fmt::format("surface_{}.csv", preset), deposits.back().surface);
    write_profile(run.folder() / fmt::format("failure_line_{}.csv", preset),
                  deposits.back().failure_line);
  }
  run.finish(&*shown);
}

}  // namespace scarp::validation
