// SPDX-License-Identifier: BSD-3-Clause
/// One list of what a state consists of, for both directions.
#include "engine/checkpoint/state_snapshot.hpp"

#include <algorithm>
#include <limits>
#include <type_traits>

#include <fmt/format.h>

#include "engine/checkpoint/finite_numbers.hpp"
#include "engine/checkpoint/scene_text.hpp"
#include "engine/checkpoint/state_bounds.hpp"
#include "engine/errors.hpp"
#include "engine/setup.hpp"
#include "engine/state.hpp"

namespace scarp {
namespace {

bool kept(const FieldRow& field) {
  return field.lifetime == Lifetime::state || field.lifetime == Lifetime::step_end;
}

std::vector<int> stored_components(const FieldRow& field, int dimension) {
  std::vector<int> stored;
  for (int c = 0; c < component_count(field.rank); ++c) {
    if (stores_component(field.rank, c, dimension)) stored.push_back(c);
  }
  return stored;
}

/// Values that a scalar may have.
struct Range {
  double least, most;
};
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr Range any{-infinity, infinity}, not_negative{0.0, infinity};
/// Halved a few times by retries; programs may choose others.
constexpr Range step_factors{1e-9, 1e3};

class Taker {
 public:
  explicit Taker(Snapshot& out) : out_(out) {}
  void number(const char* name, const char* unit, double value, Range = any) {
    out_.add(name, unit, {value});
  }
  template <class T>
  void integer(const char* name, T value, std::int64_t = 0) {
    out_.add(name, std::vector<std::int64_t>{static_cast<std::int64_t>(value)});
  }

 private:
  Snapshot& out_;
};

class Putter {
 public:
  explicit Putter(const Snapshot& from) : from_(from) {}
  void number(const char* name, const char*, double& value, Range range = any) {
    value = finite_numbers(from_, name, 1).front();
    if (value < range.least || value > range.most) refuse(name, value);
  }
  template <class T>
  void integer(const char* name, T& value, std::int64_t most = most_of<T>) {
    const std::int64_t stored = from_.integers(name, 1).front();
    if (stored < 0 || stored > most) refuse(name, static_cast<double>(stored));
    value = static_cast<T>(stored);
  }

 private:
  template <class T>
  static constexpr std::int64_t most_of = std::is_same_v<T, bool> ? 1
                                          : std::is_same_v<T, int>
                                              ? std::numeric_limits<int>::max()
                                              : std::numeric_limits<std::int64_t>::max();
  [[noreturn]] static void refuse(const char* name, double value) {
    throw CheckpointError(fmt::format("'{}' is {:g}, which no run leaves.", name, value));
  }

  const Snapshot& from_;
};

/// The scalars of a state. `state` is const for a Taker.
template <class Archive, class AnyState>
void exchange(Archive& a, AnyState& state) {
  a.integer("clock/step", state.report.step);
  a.number("clock/time", "s", state.report.time, not_negative);
  a.number("clock/stage_time", "s", state.stage.time, not_negative);
  a.number("clock/time_step", "s", state.clock.time_step, not_negative);
  a.number("clock/previous_time_step", "s", state.clock.previous_time_step, not_negative);
  a.number("clock/growth_base", "s", state.clock.growth_base, not_negative);
  a.integer("clock/since_restart", state.clock.since_restart);
  a.integer("clock/restart", state.clock.restart);
  a.number("clock/step_factor", "", state.clock.step_factor, step_factors);
  a.number("report/stage_time", "s", state.report.stage_time, not_negative);
  a.number("report/time_step", "s", state.report.time_step, not_negative);
  a.integer("report/limit", state.report.limit, std::size(step_limit_names) - 1);
  a.integer("report/signal_material", state.report.signal_material,
            static_cast<std::int64_t>(state.scene.materials.size()) - 1);
  a.number("report/max_velocity", "m/s", state.report.max_velocity, not_negative);
  a.integer("stage/index", state.stage.index,
            static_cast<std::int64_t>(state.scene.stages.size()) - 1);
  a.integer("stage/started", state.stage.started);
  a.integer("stage/ended", state.stage.ended);
  a.integer("stage/reached_rest", state.stage.reached_rest);
  a.number("stage/calm_since", "s", state.stage.calm_since);
  a.number("stage/damping", "1/s", state.stage.damping, not_negative);
  a.number("stage/rest_window", "s", state.stage.rest_window, not_negative);
  a.number("stage/start_speed", "m/s", state.stage.start_speed, not_negative);
  a.integer("lists/valid", state.neighbours.valid);
  a.integer("lists/rebuilds", state.neighbours.rebuilds);
  a.number("lists/walls_moved", "m", state.boundary.moved, not_negative);
  a.integer("counts/density_bounds", state.density_bounds);
  a.integer("counts/face_holds", state.boundary.holds);
  for (std::size_t k = 0; k < std::size(step_limit_names); ++k)
    a.integer(fmt::format("counts/steps_by_{}", step_limit_names[k]).c_str(),
              state.limits.counts[k]);
  auto& ledger = state.ledger;
  const auto powers = [&a](const char* const(&names)[6], const char* unit, auto& p) {
    a.number(names[0], unit, p.stress);
    a.number(names[1], unit, p.viscous);
    a.number(names[2], unit, p.artificial_stress);
    a.number(names[3], unit, p.damping);
    a.number(names[4], unit, p.wall);
    a.number(names[5], unit, p.hold);
  };
  powers({"energy/work_stress", "energy/work_viscous", "energy/work_artificial_stress",
          "energy/work_damping", "energy/work_wall", "energy/work_hold"},
         "J", ledger.work);
  powers({"energy/power_stress", "energy/power_viscous", "energy/power_artificial_stress",
          "energy/power_damping", "energy/power_wall", "energy/power_hold"},
         "W", ledger.last_powers);
  a.number("energy/last_time", "s", ledger.last_time);
  a.integer("energy/last_step", ledger.last_step);
  a.number("energy/start_kinetic", "J", ledger.start.kinetic);
  a.number("energy/start_potential", "J", ledger.start.potential);
  a.number("energy/start_elastic", "J", ledger.start.elastic);
  a.number("energy/start_plastic", "J", ledger.start.plastic);
  a.number("energy/start_diffusion", "J", ledger.start.diffusion);
  a.number("energy/start_stress_work", "J", ledger.stress_work_start);
}

void take_vectors(Snapshot& out, std::string name, std::string unit,
                  const std::vector<Vec3>& from) {
  std::vector<double> flat;
  for (const Vec3& v : from) flat.insert(flat.end(), v.begin(), v.end());
  out.add({std::move(name), std::move(unit), {from.size(), 3}, std::move(flat)});
}

void put_vectors(const Snapshot& from, std::string_view name, std::vector<Vec3>& to) {
  const std::vector<double>& flat = finite_numbers(from, name, 3 * to.size());
  for (std::size_t k = 0; k < flat.size(); ++k) to[k / 3][k % 3] = flat[k];
}

void take_dummies(Snapshot& out, std::string name, const Walls& walls, bool built) {
  const auto count = static_cast<std::size_t>(walls.count());
  std::vector<double> flat;
  for (std::size_t a = 0; a < 3; ++a) {
    const double* from = built ? walls.built_position(a) : walls.position(a);
    flat.insert(flat.end(), from, from + count);
  }
  out.add({std::move(name), "m", {3, count}, std::move(flat)});
}

void put_dummies(const Snapshot& from, std::string_view name, Walls& walls) {
  walls.move_to(finite_numbers(from, name, 3 * static_cast<std::size_t>(walls.count())));
}

void take_fields(Snapshot& out, const State& state) {
  const ParticleBuffers& p = state.particles;
  const auto slots = static_cast<std::size_t>(p.slots());
  out.add({"particles/id", "", {slots}, p.ids()});
  for (const FieldRow& field : p.rows()) {
    if (!kept(field)) continue;
    const std::vector<int> components = stored_components(field, state.scene.dimension);
    std::vector<double> values;
    values.reserve(components.size() * slots);
    for (const int c : components) {
      const double* from = p.component(field.field, c);
      values.insert(values.end(), from, from + slots);
    }
    out.add({fmt::format("fields/{}", field.name),
             field.unit,
             {components.size(), slots},
             std::move(values)});
  }
}

/// `to`: the field that takes the values, of the same rank as the one they are stored under.
void put_field(const Snapshot& from, const FieldRow& stored, Field to, State& state) {
  ParticleBuffers& p = state.particles;
  const std::vector<int> components = stored_components(stored, state.scene.dimension);
  const auto slots = static_cast<std::size_t>(p.slots());
  const std::vector<double>& values =
      finite_numbers(from, fmt::format("fields/{}", stored.name), components.size() * slots);
  auto next = values.begin();
  for (const int c : components) {
    std::copy_n(next, slots, p.component(to, c));
    next += static_cast<std::ptrdiff_t>(slots);
  }
}

/// The order in memory may differ from the scene's own, but only within a material.
void put_ids(const Snapshot& from, State& state) {
  std::vector<std::int64_t>& ids = state.particles.ids();
  const std::vector<std::int64_t>& stored = from.integers("particles/id", ids.size());
  for (const ParticleGroup& group : state.particles.groups()) {
    std::vector<std::int64_t> own(ids.begin() + group.first, ids.begin() + group.end());
    std::vector<std::int64_t> other(stored.begin() + group.first, stored.begin() + group.end());
    std::sort(own.begin(), own.end());
    std::sort(other.begin(), other.end());
    const bool padded = std::equal(ids.begin() + group.end(), ids.begin() + group.padded_end(),
                                   stored.begin() + group.end());
    if (own != other || !padded) {
      throw CheckpointError(
          "'particles/id' does not list the particles of the scene. Try the scene and the program "
          "that wrote it.");
    }
  }
  ids = stored;
}

void put_walls(const Snapshot& from, State& state) {
  const std::vector<std::int64_t>& stands = from.integers("walls/stands", state.scene.walls.size());
  for (std::size_t w = 0; w < stands.size(); ++w) state.boundary.stands[w] = stands[w] != 0;
  put_vectors(from, "walls/placed_offset", state.boundary.offset);
  place_walls(state);
  put_vectors(from, "walls/velocity", state.boundary.velocity);
  put_vectors(from, "walls/hold_force", state.boundary.hold_force);
}

void take_lost(Snapshot& out, const State& state) {
  const LostSoil& lost = state.lost;
  out.add("lost/ids", state.lost_ids);
  out.add("lost/first_and_step",
          std::vector<std::int64_t>{lost.first, static_cast<std::int64_t>(lost.step)});
  out.add("lost/mass", "kg", {lost.mass});
  out.add("lost/time", "s", {lost.time});
  take_vectors(out, "lost/position", "m", {lost.position});
  out.add("lost/stage", lost.stage);
}

void put_lost(const Snapshot& from, State& state) {
  const std::vector<std::int64_t>& ids = from.integers("lost/ids");
  std::vector<std::int64_t> known = state.particles.ids();
  std::sort(known.begin(), known.end());
  std::int64_t before = -1;  // ids are not negative, and ascend here
  for (const std::int64_t id : ids) {
    if (id <= before || !std::binary_search(known.begin(), known.end(), id))
      throw CheckpointError(fmt::format("'lost/ids' holds {}, which it cannot.", id));
    before = id;
  }
  state.lost_ids = ids;
  LostSoil& lost = state.lost;
  lost.particles = ids.size();
  const std::vector<std::int64_t>& first = from.integers("lost/first_and_step", 2);
  lost.first = first[0];
  lost.step = static_cast<std::uint64_t>(first[1]);
  lost.mass = finite_numbers(from, "lost/mass", 1).front();
  lost.time = finite_numbers(from, "lost/time", 1).front();
  const std::vector<double>& position = finite_numbers(from, "lost/position", 3);
  std::copy(position.begin(), position.end(), lost.position.begin());
  lost.stage = from.text("lost/stage");
}

/// Lists depend on nothing but what stood where when they were built.
void build_lists_again(const Snapshot& from, State& state) {
  put_field(from, row(Field::build_position), Field::position, state);
  put_vectors(from, "walls/built_offset", state.boundary.offset);
  if (from.has("walls/built_position"))
    put_dummies(from, "walls/built_position", state.boundary.walls);
  build_lists(state);
}

}  // namespace

Snapshot take_snapshot(const State& state) {
  Snapshot out;
  out.add("scene", scene_text(state.scene));
  out.add("isa", std::string(state.kernels.table->name));
  Taker taker(out);
  exchange(taker, state);
  std::vector<std::int64_t> stands(state.boundary.stands.begin(), state.boundary.stands.end());
  out.add("walls/stands", std::move(stands));
  take_vectors(out, "walls/velocity", "m/s", state.boundary.velocity);
  take_vectors(out, "walls/hold_force", "N", state.boundary.hold_force);
  take_vectors(out, "walls/offset", "m", state.boundary.offset);
  take_vectors(out, "walls/placed_offset", "m", state.boundary.placed_offset);
  take_vectors(out, "walls/built_offset", "m", state.boundary.built_offset);
  if (state.boundary.walls.have_moved()) {
    take_dummies(out, "walls/position", state.boundary.walls, false);
    take_dummies(out, "walls/built_position", state.boundary.walls, true);
  }
  take_lost(out, state);
  take_fields(out, state);
  return out;
}

void apply_snapshot(State& state, const Snapshot& snapshot) {
  const std::string& stored = snapshot.text("scene");
  const std::string here = scene_text(state.scene);
  if (!only_adds_stages(stored, here)) {
    throw CheckpointError(
        fmt::format("it belongs to another scene: there {}. Try the scene it was written with.",
                    first_difference(stored, here)));
  }
  for (const FieldRow& field : state.particles.rows()) {
    if (field.check == Check::near)
      require_near(snapshot, fmt::format("fields/{}", field.name), state);
  }
  put_walls(snapshot, state);
  put_ids(snapshot, state);
  put_lost(snapshot, state);
  Putter putter(snapshot);
  exchange(putter, state);
  const bool lists_valid = state.neighbours.valid;
  const double walls_moved = state.boundary.moved;
  set_material_constants(state);
  if (lists_valid) build_lists_again(snapshot, state);
  state.neighbours.valid = lists_valid;
  state.boundary.moved = walls_moved;
  for (const FieldRow& field : state.particles.rows()) {
    if (kept(field)) put_field(snapshot, field, field.field, state);
  }
  put_vectors(snapshot, "walls/offset", state.boundary.offset);
  if (snapshot.has("walls/position")) put_dummies(snapshot, "walls/position", state.boundary.walls);
  if (state.stage.started) require_sound(state);
  if (!lists_valid) return;
  pack_soil(state);  // no step needs it, but who asks for forces on walls first
  pack_images(state);
  extrapolate_walls(state);
}

}  // namespace scarp
