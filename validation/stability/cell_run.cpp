// SPDX-License-Identifier: BSD-3-Clause
/// Start, margin, run, measures, verdict.
#include "validation/stability/cell_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <random>

#include "engine/check/stability_margin.hpp"
#include "engine/check/warnings.hpp"
#include "engine/errors.hpp"
#include "engine/setup.hpp"
#include "validation/stability/scenes.hpp"
#include "validation/stability/wall_passages.hpp"
#include "validation/stress_noise.hpp"

namespace scarp::validation {
namespace {

constexpr std::uint64_t steps_per_sample = 100;

/// The start of the cell's scene, with its particles displaced.
Simulation start_of(const Cell& cell, const RunOptions& options) {
  const Simulation plain(cell.scene, options);
  if (cell.displaced == 0.0 && !cell.coincident) return plain.clone();
  const Snapshot before = plain.snapshot();
  Snapshot changed;
  for (SnapshotItem item : before.items()) {
    if (item.name == "fields/position" || item.name == "fields/reference_position") {
      auto& x = std::get<std::vector<double>>(item.values);
      const std::size_t slots = item.shape[1];
      std::mt19937 random(1);
      std::uniform_real_distribution<double> share(-1.0, 1.0);
      for (std::size_t k = 0; k < plain.soil_count(); ++k) {
        for (std::size_t a = 0; a < 2; ++a)
          x[a * slots + k] += cell.displaced * cell.scene.spacing * share(random);
      }
      if (cell.coincident) {
        x[1] = x[0];
        x[slots + 1] = x[slots];
      }
    }
    changed.add(std::move(item));
  }
  return Simulation(cell.scene, changed, options);
}

/// sqrt(g H) of the soil's present height.
double falling_speed(const Simulation& simulation) {
  const std::vector<double> position = simulation.field("position");
  const Scene& scene = simulation.scene();
  const std::size_t up = upwards(scene);
  double low = position[up], high = low;
  for (std::size_t k = up; k < position.size(); k += 3) {
    low = std::min(low, position[k]);
    high = std::max(high, position[k]);
  }
  return std::sqrt(std::abs(scene.gravity[up]) * (high - low + scene.spacing));
}

class Measures {
 public:
  explicit Measures(const Simulation& simulation) : kinetic_start_(simulation.energy().kinetic) {}

  void sample(const Simulation& simulation, CellRecord& record) {
    const EnergyBalance e = simulation.energy();
    spent_ = std::max({spent_, kinetic_start_, -e.potential, std::abs(e.elastic)});
    if (spent_ > 0.0) {
      const double gain = (e.kinetic - kinetic_start_ + e.potential + e.elastic) / spent_;
      record.energy_gain = std::max(record.energy_gain, gain);
    }
    const Scene& scene = simulation.scene();
    const Stage& stage = scene.stages[simulation.stage_index()];
    const std::vector<double> density = simulation.field("density"),
                              stress = simulation.field("stress"),
                              material = simulation.field("material");
    std::vector<kernels::ModelConstants> constants;
    for (const Material& m : scene.materials)
      constants.push_back(stress_pass_constants(scene, m, stage.strength_reduction).model);
    for (std::size_t k = 0; k < density.size(); ++k) {
      const auto m = static_cast<std::size_t>(material[k]);
      const double ratio = density[k] / scene.materials[m].density;
      record.density_low = std::min(record.density_low, ratio);
      record.density_high = std::max(record.density_high, ratio);
      if (!scene.materials[m].model.yields()) continue;
      const double* s = &stress[6 * k];
      const kernels::SymTensor<double> tensor{s[0], s[1], s[2], s[3], s[4], s[5]};
      const double i1 = kernels::trace(tensor);
      const double f = scene.materials[m].model.info().yield_function(constants[m], tensor, {});
      // At the apex strength is 0: there a pascal, or round-off of the pressure, is what f is held
      // against.
      const double strength =
          std::max(kernels::root_j2(kernels::deviator(tensor)) - f, 1e-6 * std::abs(i1) + 1.0);
      record.yield_overshoot = std::max(record.yield_overshoot, f / strength);
    }
  }

 private:
  double kinetic_start_, spent_ = 0.0;
};

std::string most_frequent(const StepLimitCounts& counts) {
  const auto most = std::max_element(counts.begin(), counts.end());
  return step_limit_names[static_cast<std::size_t>(most - counts.begin())];
}

void find_margin(const Cell& cell, const Simulation& simulation, CellRecord& record) {
  const double cfl = cell.scene.numerics.cfl;
  MarginOptions wide;
  wide.most = std::max(2.5, 1.5 / cfl);  // beyond the closed forms of both integrators
  const StabilityMargin margin = stability_margin(simulation, wide);
  record.stable_cfl = cfl * margin.stable;
  if (margin.unstable > 0.0) record.unstable_cfl = cfl * margin.unstable;
}

void run_and_measure(const Cell& cell, const RunOptions& options, CellRecord& record) {
  Simulation simulation = start_of(cell, options);
  record.particles = static_cast<double>(simulation.soil_count());
  std::optional<Measures> measures;
  PassageWatch passages(simulation);
  double fastest = 0.0;  // of the last stage: a zigzag that yields or buckles comes to rest again
  try {
    while (simulation.scene().stages.size() > 1 && !simulation.stage_ended()) {
      simulation.step();
      passages.after_step(simulation);
    }
    if (cell.bisect) find_margin(cell, simulation, record);
    for (std::uint64_t k = 1; k <= cell.steps && !simulation.finished(); ++k) {
      simulation.step();
      passages.after_step(simulation);
      fastest = std::max(fastest, simulation.last_step().max_velocity);
      if (!measures) measures.emplace(simulation);
      if (k % steps_per_sample == 0) measures->sample(simulation, record);
    }
    simulation.require_sound();
  } catch (const SimulationInstability& instability) {
    record.verdict = Verdict::stopped;
    record.reason = instability.what();
  }
  record.steps = static_cast<double>(simulation.last_step().step);
  record.residual_velocity = simulation.last_step().max_velocity;
  record.lost = passages.passed(simulation);
  const StressNoise noise = stress_noise(simulation);
  record.noise = noise.pressure;
  record.shear_noise = noise.shear;
  record.limit = most_frequent(simulation.step_limit_counts());
  if (record.verdict == Verdict::stopped) return;
  const auto& position = simulation.field("position");
  const bool finite =
      std::all_of(position.begin(), position.end(), [](double x) { return std::isfinite(x); });
  if (!finite || record.lost > 0.0) {
    record.verdict = Verdict::failed;
    record.reason = finite ? fmt::format("{} grains passed a wall without a report", record.lost)
                           : std::string("numbers that are not finite without a report");
  } else if (cell.bisect && *record.stable_cfl < cell.scene.numerics.cfl) {
    record.verdict = Verdict::marginal;
    record.reason = fmt::format("stable up to CFL {:.3g}, {:g} in use", *record.stable_cfl,
                                cell.scene.numerics.cfl);
  } else if (cell.stands && fastest > 1e-4 * falling_speed(simulation)) {
    record.verdict = Verdict::restless;
    record.reason = fmt::format("moves at up to {:.2g} m/s, {:.2g} m/s after {} steps", fastest,
                                record.residual_velocity, simulation.last_step().step);
    for (const std::string& warning : warnings(cell.scene))
      record.reason += "; `scarp check` says: " + warning;
  }
}

}  // namespace

const char* word(Verdict verdict) {
  constexpr std::array words{"holds", "restless", "marginal", "stopped", "refused", "failed"};
  return words[static_cast<std::size_t>(verdict)];
}

CellRecord run_cell(const Cell& cell, const RunOptions& options) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  CellRecord record;
  try {
    run_and_measure(cell, options, record);
  } catch (const SceneError& error) {
    record.verdict = Verdict::refused;
    record.reason = error.what();
  }
  record.wall_s = std::chrono::duration<double>(Clock::now() - start).count();
  return record;
}

}  // namespace scarp::validation
