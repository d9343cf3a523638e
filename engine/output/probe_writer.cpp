// SPDX-License-Identifier: BSD-3-Clause
/// Columns of the history tables.

#include "engine/output/probe_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

namespace scarp {
namespace {

constexpr std::array<const char*, 3> axes{"x", "y", "z"};
constexpr std::array<const char*, 6> stress_components{"xx", "yy", "zz", "xy", "yz", "zx"};

using Titles = std::vector<std::string>;

Titles moment_titles() { return {"time [s]", "stage"}; }

/// In plane strain the stress has four components that can differ from zero.
std::size_t stress_count(int dimension) { return dimension == 2 ? 4 : 6; }

Titles probe_titles(const Scene& scene) {
  const auto dimension = static_cast<std::size_t>(scene.dimension);
  Titles titles = moment_titles();
  for (const Probe& probe : scene.probes) {
    for (const auto& [quantity, unit] :
         {std::pair{"position", "m"}, {"displacement", "m"}, {"velocity", "m/s"}}) {
      for (std::size_t a = 0; a < dimension; ++a) {
        titles.push_back(fmt::format("{}.{}_{} [{}]", probe.name, quantity, axes[a], unit));
      }
    }
    for (std::size_t c = 0; c < stress_count(scene.dimension); ++c) {
      titles.push_back(fmt::format("{}.stress_{} [Pa]", probe.name, stress_components[c]));
    }
    titles.push_back(fmt::format("{}.density [kg/m3]", probe.name));
    for (const kernels::StateField& field : history_of(scene)) {
      if (field.output)
        titles.push_back(fmt::format("{}.{} [{}]", probe.name, field.name, field.unit));
    }
  }
  return titles;
}

Titles history_titles(const Scene& scene) {
  Titles titles{"time [s]",           "stage",         "step", "time_step [s]", "limit",
                "max_velocity [m/s]", "lost_particles"};
  if (soil_may_sleep(scene)) titles.emplace_back("asleep [-]");
  return titles;
}

double share_asleep(const Simulation& simulation) {
  return static_cast<double>(simulation.asleep_count()) /
         static_cast<double>(std::max<std::size_t>(1, simulation.soil_count()));
}

Titles wall_titles(const Scene& scene) {
  Titles titles = moment_titles();
  for (const Wall& wall : scene.walls) {
    for (std::size_t a = 0; a < static_cast<std::size_t>(scene.dimension); ++a) {
      titles.push_back(
          fmt::format("{}.force_{} [{}]", wall.name, axes[a], scene.dimension == 2 ? "N/m" : "N"));
    }
  }
  return titles;
}

struct EnergyColumn {
  const char* name;
  double EnergyBalance::*value;
};
constexpr std::array<EnergyColumn, 13> energy_columns{{
    {"kinetic", &EnergyBalance::kinetic},
    {"kinetic_added", &EnergyBalance::kinetic_added},
    {"potential", &EnergyBalance::potential},
    {"elastic", &EnergyBalance::elastic},
    {"plastic", &EnergyBalance::plastic},
    {"viscous", &EnergyBalance::viscous},
    {"damping", &EnergyBalance::damping},
    {"wall", &EnergyBalance::wall},
    {"artificial_stress", &EnergyBalance::artificial_stress},
    {"gradient_residue", &EnergyBalance::gradient_residue},
    {"diffusion", &EnergyBalance::diffusion},
    {"sleep", &EnergyBalance::sleep},
    {"imbalance", &EnergyBalance::imbalance},
}};

/// Columns of what the scene does not have are left out.
bool is_written(const Scene& scene, const EnergyColumn& column) {
  if (column.value == &EnergyBalance::sleep) return soil_may_sleep(scene);
  if (column.value == &EnergyBalance::kinetic_added) return scales_mass(scene);
  return true;
}

Titles energy_titles(const Scene& scene) {
  Titles titles = moment_titles();
  for (const EnergyColumn& column : energy_columns) {
    if (is_written(scene, column))
      titles.push_back(fmt::format("{} [{}]", column.name, scene.dimension == 2 ? "J/m" : "J"));
  }
  return titles;
}

std::string mark_item(const char* name) { return fmt::format("outputs/{}_bytes_and_sum", name); }

CsvFile table(const std::filesystem::path& folder, const char* name, const Snapshot* progress,
              OldTables tables, const Titles& titles) {
  const std::filesystem::path path = folder / fmt::format("{}.csv", name);
  if (progress == nullptr) return {path, titles};
  const FileMark mark = mark_from(*progress, mark_item(name));
  if (tables == OldTables::as_they_are) return CsvFile::as_it_is(path, mark.bytes, titles);
  return {path, mark};
}

}  // namespace

ProbeWriter::ProbeWriter(const Simulation& simulation, const std::filesystem::path& folder)
    : ProbeWriter(simulation, folder, nullptr, OldTables::as_recorded) {}
ProbeWriter::ProbeWriter(const Simulation& simulation, const std::filesystem::path& folder,
                         const Snapshot& progress, OldTables tables)
    : ProbeWriter(simulation, folder, &progress, tables) {}

ProbeWriter::ProbeWriter(const Simulation& simulation, const std::filesystem::path& folder,
                         const Snapshot* progress, OldTables tables)
    : history_(table(folder, "history", progress, tables, history_titles(simulation.scene()))) {
  const Scene& scene = simulation.scene();
  const auto with = [&](const char* name, const Titles& titles) {
    return table(folder, name, progress, tables, titles);
  };
  if (!scene.probes.empty()) probes_ = with("probes", probe_titles(scene));
  if (!scene.walls.empty()) walls_ = with("walls", wall_titles(scene));
  if (scene.output.energy) energy_ = with("energy", energy_titles(scene));
}

void ProbeWriter::add_progress(Snapshot& snapshot) const {
  const auto add = [&snapshot](const char* name, const CsvFile& file) {
    add_mark(snapshot, mark_item(name), file.flushed());
  };
  add("history", history_);
  if (probes_) add("probes", *probes_);
  if (walls_) add("walls", *walls_);
  if (energy_) add("energy", *energy_);
}

void ProbeWriter::write(const Simulation& simulation) {
  const Scene& scene = simulation.scene();
  const StepReport& report = simulation.last_step();
  const auto dimension = static_cast<std::size_t>(scene.dimension);
  const std::string stage = simulation.stage_index() < scene.stages.size()
                                ? scene.stages[simulation.stage_index()].name
                                : std::string("-");
  history_ << report.time << stage << static_cast<double>(report.step) << report.time_step
           << name_of(report.limit) << report.max_velocity
           << static_cast<double>(simulation.lost_soil().particles);
  if (soil_may_sleep(scene)) history_ << share_asleep(simulation);
  history_.end_row();
  if (probes_) {
    *probes_ << report.time << stage;
    for (std::size_t p = 0; p < scene.probes.size(); ++p) {
      const ProbeSample sample = simulation.probe(p);
      for (const Vec3* vector : {&sample.position, &sample.displacement, &sample.velocity}) {
        for (std::size_t a = 0; a < dimension; ++a) *probes_ << (*vector)[a];
      }
      for (std::size_t c = 0; c < stress_count(scene.dimension); ++c) *probes_ << sample.stress[c];
      *probes_ << sample.density;
      for (const double value : sample.history) *probes_ << value;
    }
    probes_->end_row();
  }
  if (walls_ && report.step > 0) {  // the first step is the first to sum forces
    const std::vector<WallReaction> reactions = simulation.wall_reactions();
    *walls_ << report.time << stage;
    for (const Wall& wall : scene.walls) {
      Vec3 force{};  // a removed wall carries nothing
      for (const WallReaction& reaction : reactions) {
        if (reaction.wall == wall.name) force = reaction.force;
      }
      for (std::size_t a = 0; a < dimension; ++a) *walls_ << force[a];
    }
    walls_->end_row();
  }
  if (energy_) {
    const EnergyBalance balance = simulation.energy();
    *energy_ << report.time << stage;
    for (const EnergyColumn& column : energy_columns) {
      if (is_written(scene, column)) *energy_ << balance.*column.value;
    }
    energy_->end_row();
  }
}

}  // namespace scarp
