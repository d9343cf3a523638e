// SPDX-License-Identifier: BSD-3-Clause
/// States that occur in runs, made by running validation scenes at set-up.
#pragma once

#include <map>
#include <string>
#include <tuple>

#include "engine/checkpoint/snapshot.hpp"
#include "engine/scene/scene_reader.hpp"
#include "engine/simulation.hpp"
#include "engine/team.hpp"

namespace scarp::bench {

/// A scene, and how far into its second stage the state is taken.
struct RealState {
  std::string name;
  std::string scene;  ///< of validation/cases/
  double spacing;     ///< [m]
  double strength_reduction;
  double stage_time;  ///< [s]
};

/// The paper's slope after a failure; a thin deposit of bars that has run out; the cuboid of sand
/// while it runs out over its base layer.
inline RealState failed_slope(double spacing) {
  return {"failed_slope/2d", "slope_2d", spacing, 1.6, 3.0};
}
inline RealState run_out_2d(double spacing) {
  return {"run_out/2d", "aluminium_bars", spacing, 1.0, 0.55};
}
inline RealState run_out_3d(double spacing) {
  return {"run_out/3d", "cuboid_3d", spacing, 1.0, 0.4};
}

/// A simulation in that state, in a stage that does not end, on so many threads. The state is made
/// once.
inline Simulation made(const RealState& wanted, const std::string& preset_name, int threads) {
  static std::map<std::tuple<std::string, double, std::string>, Snapshot> known;
  Scene scene =
      read_scene(std::string(SCARP_CASES) + "/" + wanted.scene + "/" + wanted.scene + ".toml",
                 {.preset = preset_name, .spacing = wanted.spacing});
  scene.output.energy = false;
  scene.stages[1].strength_reduction = wanted.strength_reduction;
  scene.stages[1].duration = 1e3;
  scene.stages[1].until = StageEnd::duration;
  const std::tuple key{wanted.name, wanted.spacing, preset_name};
  if (!known.contains(key)) {
    Simulation simulation(scene, RunOptions{default_threads(), {}});
    while (simulation.stage_index() == 0 || simulation.last_step().stage_time < wanted.stage_time)
      simulation.step();
    known.emplace(key, simulation.snapshot());
  }
  return Simulation(scene, known.at(key), RunOptions{threads, {}});
}

}  // namespace scarp::bench
