// SPDX-License-Identifier: BSD-3-Clause
/// Public entry of the library: a scene becomes particles, `step()` advances them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/boundary/wall_reaction.hpp"
#include "engine/checkpoint/snapshot.hpp"
#include "engine/energy/energy_balance.hpp"
#include "engine/features.hpp"
#include "engine/integrate/step_report.hpp"
#include "engine/particles/field_view.hpp"
#include "engine/particles/particles.hpp"
#include "engine/particles/probe_sample.hpp"
#include "engine/run_options.hpp"
#include "engine/scene/scene.hpp"
#include "engine/step/phase_view.hpp"
#include "engine/watch/lost_soil.hpp"

namespace scarp {

/// A quantity of the particles that can be read out and written to frames.
struct FieldInfo {
  std::string name;  ///< "density", "stress", "displacement", ...
  std::string unit;
  int components = 1;  ///< 1, 3 (x, y, z) or 6 (xx, yy, zz, xy, yz, zx)
  std::string description;
  /// How frames hold it: as 32-bit floating point or as whole numbers.
  enum class Numbers { real, int32, int64 } numbers = Numbers::real;
};

/// Owns the particles of one scene. Not safe for concurrent use of one object; two objects are
/// independent. Errors: SceneError from the constructor (nothing is left behind),
/// SimulationInstability from `step()` (state stays readable), Stopped from both (from `step()`
/// before it changes anything), Error from every member of an object that has been moved from. Each
/// but the last calls `Reduction::abort` on the way.
class Simulation {
 public:
  explicit Simulation(Scene scene, const RunOptions& options = {});
  /// The soil is `particles`, in place of bodies, of which the scene then needs none. Errors:
  /// SceneError (`completed`).
  Simulation(Scene scene, const Particles& particles, const RunOptions& options = {});
  /// Goes on from a snapshot of the same scene, bit for bit with any number of threads and the
  /// snapshot's instruction set, which an empty `RunOptions::isa` means here. Forces on walls are
  /// those of the present positions until the next step. Errors: CheckpointError.
  Simulation(Scene scene, const Snapshot& snapshot, RunOptions options = {});
  Simulation(Scene scene, const Particles& particles, const Snapshot& snapshot,
             RunOptions options = {});
  ~Simulation();
  Simulation(Simulation&&) noexcept;
  Simulation& operator=(Simulation&&) noexcept;

  /// Advances one time step, entering the next stage first where one has ended.
  const StepReport& step();
  /// True when the last stage has ended.
  [[nodiscard]] bool finished() const;
  /// Ends the current stage now: the next `step()` enters the next one.
  void end_stage();
  /// Replaces the stages that follow the current one (a family of runs from one settled state).
  void set_following_stages(std::vector<Stage> stages);
  /// Multiplies every time step from now on in place of the factor before; 1 at the start. A
  /// snapshot holds it. Errors: Error unless above 0 and finite.
  void set_step_factor(double factor);
  [[nodiscard]] double step_factor() const;
  /// Adds to each velocity pseudo-random components within +-`speed` [m/s], by the particles' ids
  /// alone: noise in which an instability can grow. Errors: Error unless finite.
  void perturb(double speed);
  /// Calls the hook in every step before or after a phase, also where a stage begins; hooks of one
  /// place in the order given. A force is added to "acceleration" after "sweep_force" (Verlet:
  /// "sweep_all"): it takes part in the step's size, and the watch and the energies know its work
  /// (`EnergyBalance::hooks`). Copies keep the hooks; a snapshot does not.
  /// What a hook throws leaves `step()`. Errors: Error for a phase that the run does not have.
  void on_phase(std::string_view phase, When when, PhaseHook hook);
  /// The phases of the start of a stage, then those of a step, in their order.
  [[nodiscard]] std::vector<PhaseInfo> phases() const;
  /// An independent copy that goes on from here bit for bit.
  [[nodiscard]] Simulation clone() const;
  /// The same, with the threads and the question whether to stop of `options`; instruction set and
  /// reduction are those of this simulation. Errors: SceneError as of the constructor.
  [[nodiscard]] Simulation clone(const RunOptions& options) const;
  /// The complete state, to be kept in a file (`engine/output/checkpoint_file.hpp`); taking one
  /// changes nothing.
  [[nodiscard]] Snapshot snapshot() const;

  [[nodiscard]] const Scene& scene() const;
  [[nodiscard]] const StepReport& last_step() const;
  [[nodiscard]] std::size_t stage_index() const;
  [[nodiscard]] bool stage_ended() const;  ///< the current stage has reached its end
  [[nodiscard]] bool stage_reached_rest()
      const;  ///< ... because everything came to rest, not by its time

  [[nodiscard]] std::size_t soil_count() const;
  [[nodiscard]] std::size_t wall_count() const;         ///< dummy particles of the walls
  [[nodiscard]] std::vector<FieldInfo> fields() const;  ///< what frames hold of each particle
  /// Values of the soil particles in order of their permanent id, `components` per particle, SI.
  /// Also "position" and "lost" (1 or 0). Throws Error for an unknown name.
  [[nodiscard]] std::vector<double> field(std::string_view name) const;
  /// The same without a copy, in the order of memory; "position" and what `fields` lists, but for
  /// what is computed when it is read ("displacement", "id", "material"). Error for another name.
  [[nodiscard]] FieldView view(std::string_view name) const;
  /// Replaces a field that is part of the state and not a position ("velocity", "density",
  /// "stress", a history variable) by values in the form that `field` gives; forces follow from
  /// them in the next step. The energy balance begins anew with what is set, as at the start of a
  /// stage. Errors: Error, before anything is changed, for another name, another count, and
  /// values that are not finite.
  void set_field(std::string_view name, std::span<const double> values);
  /// The permanent ids of all particles, ascending: the order of `field`.
  [[nodiscard]] std::vector<std::int64_t> ids() const;
  [[nodiscard]] std::vector<double> wall_positions() const;  ///< 3 per dummy particle
  [[nodiscard]] std::vector<WallFace> wall_faces() const;    ///< that stand, where they are now

  /// Looks at the present state as `step()` does every 50 steps. Errors: SimulationInstability.
  void require_sound() const;
  /// Soil lost so far; looked for every 50 steps and when a stage ends.
  [[nodiscard]] const LostSoil& lost_soil() const;
  /// Particles that sleep now (`Numerics::sleep`); none in a part of a soil.
  [[nodiscard]] std::uint64_t asleep_count() const;
  [[nodiscard]] EnergyBalance energy() const;
  [[nodiscard]] std::vector<WallReaction> wall_reactions() const;
  [[nodiscard]] ProbeSample probe(
      std::size_t index) const;  ///< Error for an index the scene does not have
  [[nodiscard]] ProbeSample probe(
      std::string_view name) const;  ///< Error for a name the scene does not have
  [[nodiscard]] const std::vector<ProbeParticle>& probe_particles() const;

  [[nodiscard]] double smoothing_length() const;
  [[nodiscard]] double spacing() const;    ///< of the particles, the largest of all groups [m]
  [[nodiscard]] double soil_mass() const;  ///< [kg, per metre in 2D]
  /// Largest CFL number for sound on the undisturbed lattice, in closed form (T1).
  [[nodiscard]] double acoustic_cfl_limit() const;
  [[nodiscard]] double lattice_moment()
      const;  ///< M of the undisturbed lattice for this smoothing function
  [[nodiscard]] std::string isa() const;     ///< the instruction set in use
  [[nodiscard]] int threads() const;         ///< that a step may have
  [[nodiscard]] int threads_in_use() const;  ///< that the next step has
  [[nodiscard]] const RunOptions& options() const;
  [[nodiscard]] std::size_t memory_bytes()
      const;  ///< state, records, walls, images, cells and lists
  [[nodiscard]] std::uint64_t rebuild_count() const;  ///< of the neighbour lists so far
  [[nodiscard]] std::uint64_t density_bound_count()
      const;  ///< how often the density bounds acted so far
  [[nodiscard]] const StepLimitCounts& step_limit_counts() const;
  [[nodiscard]] std::uint64_t face_hold_count() const;  ///< how often a grain was held off a face
  [[nodiscard]] std::vector<UsedFeature> features() const;
  /// In order of the step, then what only the start of a stage has; what a step does twice is one
  /// entry. A hook counts to its phase.
  [[nodiscard]] std::vector<PhaseTime> profile() const;

 private:
  Simulation(const Simulation& other);
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace scarp
