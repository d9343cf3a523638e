// SPDX-License-Identifier: BSD-3-Clause
/// Public entry of the library: a scene becomes particles, `step()` advances them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "engine/checkpoint/snapshot.hpp"
#include "engine/scene/scene.hpp"

namespace scarp {

/// How a run is carried out; nothing here changes the physics.
struct RunOptions {
  /// 0: as many as pay at the moment, at most what OpenMP would take (see `Team`); else exactly
  /// that many. Errors: SceneError if there are fewer cores.
  int threads = 0;
  std::string isa;  ///< "avx512", "avx2", "sse2"; empty: SCARP_ISA, else the best the machine has
  bool oversubscribe = false;  ///< allows up to 16 threads on fewer cores: slow, for tests
  /// Whether to stop: looked at before each step and within the set-up, by copies of a simulation
  /// too, in the thread that called. Cheap, and safe to call at any time; empty: never.
  std::function<bool()> stop = {};
};

/// Which bound set a time step (THEORY.md section 10): sound in the stiffest soil, approach faster
/// than that sound, acceleration, artificial viscosity, stress diffusion; or the rate at which
/// steps may grow, the end of the stage.
enum class StepLimit { acoustic, approach, force, viscous, diffusion, growth, stage_end };
inline constexpr const char* step_limit_names[]{"acoustic",  "approach", "force",    "viscous",
                                                "diffusion", "growth",   "stage_end"};
inline const char* name_of(StepLimit limit) {
  const auto index = static_cast<std::size_t>(limit);
  return index < std::size(step_limit_names) ? step_limit_names[index] : "unknown";
}
/// How many steps each limit has set.
using StepLimitCounts = std::array<std::uint64_t, std::size(step_limit_names)>;

/// What the last step did.
struct StepReport {
  std::uint64_t step = 0;
  double time = 0.0;        ///< simulated time since the start [s]
  double stage_time = 0.0;  ///< since the start of the stage [s]
  double time_step = 0.0;   ///< [s]
  StepLimit limit = StepLimit::acoustic;
  double max_velocity = 0.0;        ///< of the soil that is not lost [m/s]
  std::size_t signal_material = 0;  ///< index of the material in which signals are fastest
};

/// Energies [J, per metre of thickness in 2D]; dissipated parts are 0 unless `Output::energy`.
struct EnergyBalance {
  double kinetic = 0.0;
  double potential = 0.0;          ///< relative to the start of the stage
  double elastic = 0.0;            ///< relative to the start of the stage
  double plastic = 0.0;            ///< work of the stress on the plastic strain
  double viscous = 0.0;            ///< taken by the artificial viscosity (with the walls' share)
  double damping = 0.0;            ///< taken by F = -c_d v
  double wall = 0.0;               ///< work the soil does on walls
  double artificial_stress = 0.0;  ///< taken by the artificial stress
  double gradient_residue =
      0.0;                 ///< force power minus stress power: plain force, corrected gradient
  double diffusion = 0.0;  ///< elastic energy taken by the stress diffusion
  double imbalance = 0.0;  ///< what the lines above leave open
};

/// Soil that has left everything that could hold it (THEORY.md section 10).
struct LostSoil {
  std::uint64_t particles = 0;
  double mass = 0.0;        ///< [kg, per metre in 2D]
  std::int64_t first = -1;  ///< id of the first one; the rest is about it, when it was found
  std::uint64_t step = 0;
  double time = 0.0;  ///< [s]
  std::string stage;
  Vec3 position{};

  /// "2 of 200 particles were lost ...", in one sentence.
  std::string message(std::size_t all) const;
};

/// Sum of the forces the soil exerts on a wall [N, per metre in 2D]: those of all pairs where the
/// particles stand now, and the mean over the last step of what no-slip faces held off (B4).
struct WallReaction {
  std::string wall;
  Vec3 force{};
};

struct ProbeSample {
  std::string probe;
  Vec3 position{};
  Vec3 displacement{};
  Vec3 velocity{};
  std::array<double, 6> stress{};  ///< xx, yy, zz, xy, yz, zx, tension positive [Pa]
  double density = 0.0;
  double accumulated_plastic_strain = 0.0;
};

/// The particle that a probe follows: the nearest one to its point at the start.
struct ProbeParticle {
  std::string probe;
  std::int64_t particle = 0;  ///< permanent id
  Vec3 start{};               ///< where it was at the start [m]
  double distance = 0.0;      ///< from the probe's point then [m]
  std::size_t tied = 1;       ///< particles that were as near, itself included
};

/// A quantity of the particles that can be read out and written to frames.
struct FieldInfo {
  std::string name;  ///< "density", "stress", "displacement", ...
  std::string unit;
  int components = 1;  ///< 1, 3 (x, y, z) or 6 (xx, yy, zz, xy, yz, zx)
  std::string description;
};

/// One way the run was specialised, for `scarp check`.
struct UsedFeature {
  std::string name;
  bool used = false;
  std::string note;  ///< why, or what leaving it out saves
};

/// Wall time of one phase of the step, over all steps so far.
struct PhaseTime {
  std::string phase;
  double seconds = 0.0;
};

/// Owns the particles of one scene. Not safe for concurrent use of one object; two objects are
/// independent. Errors: SceneError from the constructor (nothing is left behind),
/// SimulationInstability from `step()` (state stays readable), Stopped from both (from `step()`
/// before it changes anything), Error from every member of an object that has been moved from.
class Simulation {
 public:
  explicit Simulation(Scene scene, const RunOptions& options = {});
  /// Goes on from a snapshot of the same scene, bit for bit with any number of threads and the
  /// snapshot's instruction set, which an empty `RunOptions::isa` means here. Forces on walls are
  /// those of the present positions until the next step. Errors: CheckpointError.
  Simulation(Scene scene, const Snapshot& snapshot, RunOptions options = {});
  ~Simulation();
  Simulation(Simulation&&) noexcept;
  Simulation& operator=(Simulation&&) noexcept;

  /// Advances one time step, entering the next stage first where one has ended.
  const StepReport& step();
  /// True when the last stage has ended.
  bool finished() const;
  /// Ends the current stage now: the next `step()` enters the next one.
  void end_stage();
  /// Replaces the stages that follow the current one (a family of runs from one settled state).
  void set_following_stages(std::vector<Stage> stages);
  /// Multiplies every time step from now on in place of the factor before; 1 at the start. A
  /// snapshot holds it. Errors: Error unless above 0 and finite.
  void set_step_factor(double factor);
  double step_factor() const;
  /// Adds to each velocity pseudo-random components within +-`speed` [m/s], by the particles' ids
  /// alone: noise in which an instability can grow. Errors: Error unless finite.
  void perturb(double speed);
  /// An independent copy that goes on from here bit for bit.
  Simulation clone() const;
  /// The complete state, to be kept in a file (`engine/output/checkpoint_file.hpp`); taking one
  /// changes nothing.
  Snapshot snapshot() const;

  const Scene& scene() const;
  const StepReport& last_step() const;
  std::size_t stage_index() const;
  bool stage_ended() const;         ///< the current stage has reached its end
  bool stage_reached_rest() const;  ///< ... because everything came to rest, not by its time

  std::size_t soil_count() const;
  std::size_t wall_count() const;  ///< dummy particles of the walls
  std::vector<FieldInfo> fields() const;
  /// Values of the soil particles in order of their permanent id, `components` per particle, SI.
  /// Also "position", "id", "material" and "lost" (1 or 0). Throws Error for an unknown name.
  std::vector<double> field(std::string_view name) const;
  std::vector<double> wall_positions() const;  ///< 3 per dummy particle

  /// Looks at the present state as `step()` does every 50 steps. Errors: SimulationInstability.
  void require_sound() const;
  /// Soil lost so far; looked for every 50 steps and when a stage ends.
  const LostSoil& lost_soil() const;
  EnergyBalance energy() const;
  std::vector<WallReaction> wall_reactions() const;
  ProbeSample probe(std::size_t index) const;  ///< Error for an index the scene does not have
  const std::vector<ProbeParticle>& probe_particles() const;

  double smoothing_length() const;
  /// Largest CFL number for sound on the undisturbed lattice, in closed form (T1).
  double acoustic_cfl_limit() const;
  double lattice_moment() const;  ///< M of the undisturbed lattice for this smoothing function
  std::string isa() const;        ///< the instruction set in use
  int threads() const;            ///< that a step may have
  const RunOptions& options() const;
  std::size_t memory_bytes() const;           ///< state, records, walls, images, cells and lists
  std::uint64_t rebuild_count() const;        ///< of the neighbour lists so far
  std::uint64_t density_bound_count() const;  ///< how often the density bounds acted so far
  const StepLimitCounts& step_limit_counts() const;
  std::uint64_t face_hold_count() const;  ///< how often a grain was held off a face
  std::vector<UsedFeature> features() const;
  /// In order of the step; what a step does twice is one entry.
  std::vector<PhaseTime> profile() const;

 private:
  Simulation(const Simulation& other);
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace scarp
