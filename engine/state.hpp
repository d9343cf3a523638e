// SPDX-License-Identifier: BSD-3-Clause
/// Everything a run consists of; the phases of a step are functions on it.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

#include "engine/boundary/mirror_images.hpp"
#include "engine/boundary/walls.hpp"
#include "engine/cells/cell_grid.hpp"
#include "engine/integrate/time_step.hpp"
#include "engine/neighbours/neighbour_lists.hpp"
#include "engine/particles/particle_buffers.hpp"
#include "engine/simulation.hpp"
#include "engine/sweep/narrow_records.hpp"
#include "engine/sweep/records.hpp"
#include "engine/team.hpp"
#include "kernels/isa/kernel_table.hpp"

namespace scarp {

/// A pair sweep in the precision of the run; the other one is null.
struct ChosenSweep {
  kernels::PairSweep<double> in_double = nullptr;
  kernels::PairSweep<float> mixed = nullptr;
};

/// Sweeps and passes chosen once per run.
struct ChosenKernels {
  const kernels::KernelTable* table = nullptr;
  ChosenSweep fused;     ///< Verlet
  ChosenSweep gradient;  ///< kick-drift-kick
  ChosenSweep force;     ///< kick-drift-kick, wall reactions, energies
  ChosenSweep fused_in_compression, force_in_compression;  ///< without artificial stress
  int cluster_size = 0;                                    ///< of the pair sweeps
  bool artificial_stress = false;
  bool correction = false;
  bool viscosity = false;
  bool diffusion = false;
};

/// Powers of the forces on the soil [W], or their time integrals [J]; see EnergyBalance.
struct ForcePowers {
  double stress = 0.0, viscous = 0.0, artificial_stress = 0.0, damping = 0.0;
  double wall = 0.0, hold = 0.0;  ///< on moving walls: by pairs, and by the faces (B4)
};

/// Energies of the present stage: integrals of powers that are sampled every few steps.
struct EnergyLedger {
  ForcePowers work;
  ForcePowers last_powers;  ///< zero when a stage begins: it mostly begins at rest
  double last_time = 0.0;
  std::uint64_t last_step = 0;
  EnergyBalance start;  ///< stored energies when the stage began
  double stress_work_start = 0.0;
};

/// Clock and control of the stages.
struct StageClock {
  std::size_t index = 0;
  bool started = false;  ///< the first stage has been entered
  bool ended = false;
  bool reached_rest = false;
  double time = 0.0;         ///< since the stage began
  double calm_since = -1.0;  ///< stage time since when the soil has been slower than rest_velocity
  double damping = 0.0;      ///< c_d in force
  double rest_window = 0.0;  ///< how long calm must last
  double start_speed = 0.0;  ///< fastest particle or wall when the stage began [m/s]
};

/// Place in the integrator's cycle.
struct StepClock {
  double time_step = 0.0;           ///< of this step
  double previous_time_step = 0.0;  ///< of the step before
  double growth_base = 0.0;         ///< last step before clipping to the end of a stage; 0: none
  int since_restart = 0;            ///< Verlet: steps since the last forward step
  bool restart = true;              ///< levels n-1 are not valid
  double step_factor = 1.0;         ///< on what the limits allow
  double kick = 0.0;                ///< time over which the last kick took the velocities
};

struct State {
  Scene scene;
  RunOptions options;
  Team team;
  int threads = 1;  ///< of this step
  ChosenKernels kernels;
  double smoothing_length = 0.0;
  double lattice_moment = 1.0;
  double particle_volume = 0.0;  ///< dx^d
  double acoustic_cfl_limit = 0.0;
  DissipationRates dissipation;

  ParticleBuffers particles;
  RecordScaling scaling;
  Records records;
  NarrowRecords narrow_records;          ///< of a run in mixed precision
  WallDummies dummies;                   ///< of every wall of the scene, as generated
  std::vector<Vec3> wall_offset;         ///< how far each wall has moved
  std::vector<Vec3> placed_wall_offset;  ///< when `walls` was made
  std::vector<Vec3> built_wall_offset;   ///< when the lists were built
  std::vector<bool> wall_stands;
  std::vector<Vec3> wall_velocity;  ///< now [m/s]
  std::vector<Vec3> hold_force;     ///< of the soil that faces held off in the last step (B4) [N]
  double walls_moved = 0.0;         ///< farthest since the lists were built [m]
  Walls walls;
  MirrorImages images;
  CellGrid soil_cells, image_cells, wall_cells;
  NeighbourLists lists, wall_lists;
  bool lists_valid = false;
  std::uint64_t rebuilds = 0;

  kernels::PairConstants<double> pair_constants{};
  std::vector<kernels::StressPassConstants> material_constants;
  std::vector<ProbeParticle> probe_particles;  ///< by probe

  StageClock stage;
  StepClock clock;
  StepReport report;
  EnergyLedger ledger;
  std::uint64_t density_bounds = 0;
  StepLimitCounts limit_counts{};
  std::uint64_t holds = 0;  ///< times a grain was held off a face
  LostSoil lost;
  std::vector<bool> lost_ids;  ///< by id; empty: none is lost

  bool is_lost(std::int64_t slot) const {
    return !lost_ids.empty() &&
           lost_ids[static_cast<std::size_t>(particles.ids()[static_cast<std::size_t>(slot)])];
  }
};

// Phases, in the order they appear in a step.
void refresh_neighbours(
    State& state);  ///< engine/neighbours/refresh.cpp: sort, cells, lists, records
/// Cells, images and lists of where everything stands now; `refresh_neighbours` calls it when due.
void build_lists(State& state);
void pack_records(State& state);       ///< of soil and images where they stand now
void extrapolate_walls(State& state);  ///< engine/boundary/wall_phase.cpp
void hold_off_faces(State& state);     ///< engine/boundary/hold_off.cpp
/// How near to a face that rule acts [m].
double hold_off_distance(double spacing);
void sweep_all(State& state);  ///< engine/sweep/pair_sweeps.cpp: every rate at once
void sweep_gradient(State& state);
void sweep_force(State& state);
void choose_time_step(State& state);  ///< engine/integrate/step_control.cpp
void advance_verlet(State& state);    ///< engine/integrate/verlet.cpp
void kick_half(State& state);         ///< engine/integrate/kick_drift_kick.cpp
void drift_half(State& state);
void advance_stress(State& state);
void sample_energy(State& state);  ///< engine/energy.cpp

// Stages (engine/stages.cpp).
void enter_stage(State& state, std::size_t index);
void end_step(State& state);
double soil_height(const State& state);   ///< extent along gravity of what is not lost [m]
double fastest_soil(const State& state);  ///< ... and its largest speed [m/s]

// Set-up (engine/setup.cpp).
State make_state(Scene scene, const RunOptions& options);
void place_walls(State& state);             ///< after a wall was removed
void set_material_constants(State& state);  ///< for the strength reduction of the current stage
/// Of one material; the step's own, `leap` and `plastic_share`, stay 0.
kernels::StressPassConstants stress_pass_constants(const Scene& scene, const Material& material,
                                                   double strength_reduction);
/// The instruction set asked for, else the best. Errors: SceneError.
const kernels::KernelTable& choose_table(const RunOptions& options);

// Views (engine/sweep/pair_sweeps.cpp).
kernels::PairSweepView<double> sweep_view(State& state);
kernels::ParticleView particle_view(State& state);
/// Force sweep with other lists, constants or outputs than the step's own (reactions, energies).
void sweep_force_with(State& state, const kernels::PairSweepView<double>& view);

// Read-outs (engine/energy.cpp, engine/boundary/reaction.cpp).
void start_ledger(State& state);  ///< at the start of a stage
EnergyBalance energy_balance(const State& state);
std::vector<WallReaction> wall_reactions(State& state);
std::vector<UsedFeature> used_features(const State& state);

}  // namespace scarp
