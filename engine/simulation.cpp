// SPDX-License-Identifier: BSD-3-Clause
/// Public entry of the library: read-outs, and the step.
#include "engine/simulation.hpp"

#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "engine/checkpoint/state_snapshot.hpp"
#include "engine/errors.hpp"
#include "engine/particles/field_access.hpp"
#include "engine/particles/noise.hpp"
#include "engine/particles/readable.hpp"
#include "engine/particles/slots_by_id.hpp"
#include "engine/scene/nearest_name.hpp"
#include "engine/scene/vector.hpp"
#include "engine/setup.hpp"
#include "engine/state.hpp"
#include "engine/step/phase_runner.hpp"
#include "engine/step/whole_soil.hpp"
#include "engine/stop.hpp"
#include "engine/watch/watch.hpp"

namespace scarp {
namespace {

/// Empty: frames do not hold it.
std::optional<FieldInfo::Numbers> numbers_in_frames(Readout readout) {
  switch (readout) {
    case Readout::real:
      return FieldInfo::Numbers::real;
    case Readout::int32:
      return FieldInfo::Numbers::int32;
    case Readout::int64:
      return FieldInfo::Numbers::int64;
    case Readout::inside:
    case Readout::by_name:
      break;
  }
  return {};
}

/// What a Simulation owns, unless it has been moved from.
template <class Impl>
Impl& owned(const std::unique_ptr<Impl>& impl) {
  if (!impl) {
    throw Error(
        "this Simulation has been moved from and has no state any more. Try the one it was moved "
        "to.");
  }
  return *impl;
}

}  // namespace

using Member = JointCall::Member;

struct Simulation::Impl {
  explicit Impl(State made)
      : state(std::move(made)),
        runner(state.scene.numerics.integrator, state.kernels.corrects_forces()) {}
  /// From bodies or `particles`, at the start or where `snapshot` was taken.
  InCall begin(Member member, double number = 0.0, std::string_view name = {}) const {
    return {*state.reduction, {.member = member, .number = number, .name = name}};
  }
  static std::unique_ptr<Impl> make(Scene scene, RunOptions options, const Particles* particles,
                                    const Snapshot* snapshot) {
    return or_abort(options.reduction.get(), [&] {
      std::optional<InCall> call;
      if (options.reduction)
        call.emplace(*options.reduction,
                     JointCall{.member = Member::make, .scene = &scene, .snapshot = snapshot});
      if (snapshot != nullptr && options.isa.empty()) options.isa = snapshot->text("isa");
      auto impl = std::make_unique<Impl>(make_state(std::move(scene), options, particles));
      if (snapshot != nullptr) {
        apply_snapshot(impl->state, *snapshot);
      } else {
        take_part(impl->state);
      }
      return impl;
    });
  }

  State state;
  PhaseRunner runner;
};

Simulation::Simulation(Scene scene, const RunOptions& options)
    : impl_(Impl::make(std::move(scene), options, nullptr, nullptr)) {}
Simulation::Simulation(Scene scene, const Snapshot& snapshot, RunOptions options)
    : impl_(Impl::make(std::move(scene), std::move(options), nullptr, &snapshot)) {}
Simulation::Simulation(Scene scene, const Particles& particles, const RunOptions& options)
    : impl_(Impl::make(std::move(scene), options, &particles, nullptr)) {}
Simulation::Simulation(Scene scene, const Particles& particles, const Snapshot& snapshot,
                       RunOptions options)
    : impl_(Impl::make(std::move(scene), std::move(options), &particles, &snapshot)) {}
Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

const StepReport& Simulation::step() {
  State& state = owned(impl_).state;
  or_abort(state.reduction.get(), [&] {
    stop_if_asked(state.options.stop);
    if (finished()) throw Error("step() after the last stage has ended: ask finished() first");
    const InCall call = impl_->begin(Member::step);
    impl_->runner.step(state);
  });
  return state.report;
}

bool Simulation::finished() const {
  const State& state = owned(impl_).state;
  return state.stage.ended && state.stage.index + 1 == state.scene.stages.size();
}
void Simulation::end_stage() { owned(impl_).state.stage.ended = true; }

void Simulation::set_following_stages(std::vector<Stage> stages) {
  State& state = owned(impl_).state;
  Scene changed = state.scene;
  changed.stages.resize(state.stage.index + 1);
  changed.stages.insert(changed.stages.end(), stages.begin(), stages.end());
  validate(changed, !state.scene.bodies.empty());
  state.scene = std::move(changed);
}

void Simulation::set_step_factor(double factor) {
  if (!(factor > 0.0) || !std::isfinite(factor)) {
    throw Error(fmt::format(
        "set_step_factor({}): a time step times that is none. Try a number above 0.", factor));
  }
  const InCall call = owned(impl_).begin(Member::set_step_factor, factor);
  impl_->state.clock.step_factor = factor;
}
double Simulation::step_factor() const { return owned(impl_).state.clock.step_factor; }

void Simulation::perturb(double speed) {
  if (!std::isfinite(speed))
    throw Error(fmt::format("perturb({}): no speed. Try a finite number of m/s.", speed));
  State& state = owned(impl_).state;
  wake_all(state);
  add_noise(state.particles, speed);
  state.clock.restart = true;
}

Simulation Simulation::clone() const {
  Simulation copy(*this);
  return copy;
}
Simulation Simulation::clone(const RunOptions& options) const {
  Simulation copy(*this);
  State& state = copy.impl_->state;
  state.team = make_team(options);
  state.options.threads = options.threads;
  state.options.oversubscribe = options.oversubscribe;
  state.options.stop = options.stop;
  return copy;
}
Simulation::Simulation(const Simulation& other)
    : impl_(std::make_unique<Impl>(owned(other.impl_))) {}

Snapshot Simulation::snapshot() const {
  const InCall call = owned(impl_).begin(Member::snapshot);
  return take_snapshot(impl_->state);
}

const Scene& Simulation::scene() const { return owned(impl_).state.scene; }
const StepReport& Simulation::last_step() const { return owned(impl_).state.report; }
std::size_t Simulation::stage_index() const { return owned(impl_).state.stage.index; }
bool Simulation::stage_ended() const { return owned(impl_).state.stage.ended; }
bool Simulation::stage_reached_rest() const { return owned(impl_).state.stage.reached_rest; }

std::size_t Simulation::soil_count() const { return owned(impl_).state.soil_count; }
std::size_t Simulation::wall_count() const {
  return static_cast<std::size_t>(owned(impl_).state.boundary.walls.dummy_count());
}

std::vector<FieldInfo> Simulation::fields() const {
  std::vector<FieldInfo> infos;
  for (const FieldRow& field : owned(impl_).state.particles.rows()) {
    const auto numbers = numbers_in_frames(field.readout);
    if (!numbers) continue;
    infos.push_back(
        {field.name, field.unit, component_count(field.rank), field.description, *numbers});
  }
  return infos;
}

std::vector<double> Simulation::field(std::string_view name) const {
  const State& state = owned(impl_).state;
  const Readable from{state.particles, state.lost_ids};
  std::string known;
  for (const FieldRow& field : state.particles.rows()) {
    if (field.readout == Readout::inside) continue;
    if (name != field.name) {
      known += (known.empty() ? "" : ", ") + std::string(field.name);
      continue;
    }
    const InCall call = impl_->begin(Member::field, 0.0, name);
    return whole_field(from, field, *state.reduction);
  }
  throw Error(fmt::format("no field '{}' in this run; there are {}", name, known));
}

FieldView Simulation::view(std::string_view name) const {
  return view_field(owned(impl_).state.particles, name);
}

void Simulation::set_field(std::string_view name, std::span<const double> values) {
  Impl& impl = owned(impl_);
  or_abort(impl.state.reduction.get(), [&] {
    write_field(impl.state.particles, name, slots_by_id(impl.state.particles), values);
    impl.runner.renew(impl.state);
  });
}

std::vector<std::int64_t> Simulation::ids() const {
  const InCall call = owned(impl_).begin(Member::ids);
  return whole_ids(impl_->state.particles, *impl_->state.reduction);
}

std::vector<double> Simulation::wall_positions() const {
  const Walls& walls = owned(impl_).state.boundary.walls;
  std::vector<double> out;
  for (std::int64_t k = 0; k < walls.dummy_count(); ++k) {
    for (const double* axis : {walls.points().x, walls.points().y, walls.points().z})
      out.push_back(axis[k]);
  }
  return out;
}

std::vector<WallFace> Simulation::wall_faces() const {
  const Boundary& boundary = owned(impl_).state.boundary;
  std::vector<WallFace> out;
  for (WallFace face : boundary.surface.faces()) {
    if (!boundary.stands[face.wall]) continue;
    face.facet.origin = geometry::plus(face.facet.origin, 1.0, boundary.offset[face.wall]);
    out.push_back(face);
  }
  return out;
}

void Simulation::require_sound() const {
  const State& state = owned(impl_).state;
  or_abort(state.reduction.get(), [&] {
    const InCall call = impl_->begin(Member::require_sound);
    if (const std::optional<Instability> found = inspect(state))
      throw SimulationInstability(*found);
  });
}

const LostSoil& Simulation::lost_soil() const { return owned(impl_).state.lost; }
std::uint64_t Simulation::asleep_count() const {
  return static_cast<std::uint64_t>(owned(impl_).state.sleep.asleep);
}
EnergyBalance Simulation::energy() const {
  const InCall call = owned(impl_).begin(Member::energy);
  return energy_balance(impl_->state);
}
std::vector<WallReaction> Simulation::wall_reactions() const {
  const InCall call = owned(impl_).begin(Member::wall_reactions);
  return scarp::wall_reactions(impl_->state);
}

ProbeSample Simulation::probe(std::size_t index) const {
  const State& state = owned(impl_).state;
  if (index >= state.probe_particles.size()) {
    throw Error(fmt::format("probe({}): the scene has {} probes. Try an index below that.", index,
                            state.probe_particles.size()));
  }
  const InCall call = impl_->begin(Member::probe, static_cast<double>(index));
  return whole_probe(state.scene, state.particles, state.probe_particles[index], *state.reduction);
}

ProbeSample Simulation::probe(std::string_view name) const {
  const std::vector<Probe>& probes = owned(impl_).state.scene.probes;
  for (std::size_t index = 0; index < probes.size(); ++index) {
    if (probes[index].name == name) return probe(index);
  }
  std::vector<std::string> names;
  for (const Probe& probe : probes) names.push_back(probe.name);
  throw Error(fmt::format("no probe '{}' in this scene. {}", name, did_you_mean(name, names)));
}

const std::vector<ProbeParticle>& Simulation::probe_particles() const {
  return owned(impl_).state.probe_particles;
}

double Simulation::spacing() const { return owned(impl_).state.particles.largest_spacing(); }
double Simulation::soil_mass() const { return owned(impl_).state.soil_mass; }
double Simulation::smoothing_length() const { return owned(impl_).state.smoothing_length; }
double Simulation::acoustic_cfl_limit() const { return owned(impl_).state.limits.acoustic_cfl; }
double Simulation::lattice_moment() const { return owned(impl_).state.lattice_moment; }
std::string Simulation::isa() const { return owned(impl_).state.kernels.table->name; }
int Simulation::threads() const { return owned(impl_).state.team.most(); }
int Simulation::threads_in_use() const { return owned(impl_).state.team.threads(); }
const RunOptions& Simulation::options() const { return owned(impl_).state.options; }
std::size_t Simulation::memory_bytes() const {
  const State& s = owned(impl_).state;
  const Boundary& b = s.boundary;
  const Neighbours& n = s.neighbours;
  std::size_t cells = 0;
  for (const CellGrid& grid : n.cells) cells += grid.bytes();
  return s.particles.bytes() + s.ghosts.bytes() + s.sweep.records.bytes() +
         s.sweep.narrow_records.bytes() + b.walls.bytes() + b.images.bytes() + n.lists.bytes() +
         n.wall_lists.bytes() + cells;
}
std::uint64_t Simulation::rebuild_count() const { return owned(impl_).state.neighbours.rebuilds; }
std::uint64_t Simulation::density_bound_count() const {
  const State& state = owned(impl_).state;
  const InCall call = impl_->begin(Member::density_bound_count);
  return static_cast<std::uint64_t>(
      state.reduction->sum_of(static_cast<double>(state.density_bounds)));
}
const StepLimitCounts& Simulation::step_limit_counts() const {
  return owned(impl_).state.limits.counts;
}
std::uint64_t Simulation::face_hold_count() const {
  const State& state = owned(impl_).state;
  const InCall call = impl_->begin(Member::face_hold_count);
  return static_cast<std::uint64_t>(
      state.reduction->sum_of(static_cast<double>(state.boundary.holds)));
}
std::vector<PhaseTime> Simulation::profile() const { return owned(impl_).runner.times(); }
std::vector<PhaseInfo> Simulation::phases() const {
  const Impl& impl = owned(impl_);
  std::vector<PhaseInfo> infos;
  for (const PhaseList list : {impl.runner.phases().stage_start, impl.runner.phases().step}) {
    for (const Phase& phase : list) infos.push_back(describe(phase, impl.state.particles));
  }
  return infos;
}
void Simulation::on_phase(std::string_view phase, When when, PhaseHook hook) {
  owned(impl_).runner.add(phase, when, std::move(hook));
}
std::vector<UsedFeature> Simulation::features() const { return used_features(owned(impl_).state); }

}  // namespace scarp
