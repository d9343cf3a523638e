// SPDX-License-Identifier: BSD-3-Clause
/// What a state consists of, as named arrays and back.
#include "engine/checkpoint/state_snapshot.hpp"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "engine/checkpoint/finite_numbers.hpp"
#include "engine/checkpoint/scene_text.hpp"
#include "engine/checkpoint/state_bounds.hpp"
#include "engine/checkpoint/state_scalars.hpp"
#include "engine/errors.hpp"
#include "engine/setup.hpp"
#include "engine/state.hpp"
#include "engine/step/whole_soil.hpp"

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
  out.add({std::move(name),
           "m",
           {3, static_cast<std::size_t>(walls.count())},
           built ? walls.built_positions() : walls.positions()});
}

void put_dummies(const Snapshot& from, std::string_view name, Walls& walls) {
  walls.move_to(finite_numbers(from, name, 3 * static_cast<std::size_t>(walls.count())));
}

void take_fields(Snapshot& out, const State& state) {
  const std::optional<ParticleBuffers> whole = whole_soil(state.particles, kept, *state.reduction);
  const ParticleBuffers& p = whole ? *whole : state.particles;
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

void put_field(const Snapshot& from, const FieldRow& field, State& state) {
  ParticleBuffers& p = state.particles;
  const std::vector<int> components = stored_components(field, state.scene.dimension);
  const auto slots = static_cast<std::size_t>(p.slots());
  const std::vector<double>& values =
      finite_numbers(from, fmt::format("fields/{}", field.name), components.size() * slots);
  auto next = values.begin();
  for (const int c : components) {
    std::copy_n(next, slots, p.component(field.field, c));
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
  // Of all parts; their sum counts.
  if (!state.reduction->leads()) state.boundary.hold_force.assign(stands.size(), Vec3{});
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

/// The lists reach further around fast grains, which were chosen when they were built.
void take_fast_grains(Snapshot& out, const State& state) {
  const FastGrains& fast = state.neighbours.fast;
  std::vector<std::int64_t> ids;
  for (const std::int64_t slot : fast.slots)
    ids.push_back(state.particles.ids()[static_cast<std::size_t>(slot)]);
  out.add("lists/fast_ids", std::move(ids));
  out.add("lists/fast_reach_more", "m", {fast.more});
}

void put_fast_grains(const Snapshot& from, State& state) {
  std::vector<std::int64_t> ids = from.integers("lists/fast_ids");
  std::sort(ids.begin(), ids.end());
  FastGrains& fast = state.neighbours.fast;
  fast = {};
  for (const ParticleGroup& group : state.particles.groups()) {
    for (std::int64_t k = group.first; k < group.end(); ++k) {
      if (std::binary_search(ids.begin(), ids.end(),
                             state.particles.ids()[static_cast<std::size_t>(k)]))
        fast.slots.push_back(k);
    }
  }
  if (fast.slots.size() != ids.size())
    throw CheckpointError("'lists/fast_ids' names particles that the soil does not have.");
  fast.more = finite_numbers(from, "lists/fast_reach_more", 1).front();
}

void swap_places(ParticleBuffers& p) {
  for (int a = 0; a < p.dimension(); ++a) {
    double* const position = p.component(Field::position, a);
    std::swap_ranges(position, position + p.slots(), p.component(Field::build_position, a));
  }
}

/// Lists, and which part holds which soil, depend on nothing but what stood where when they were
/// built.
void build_lists_again(const Snapshot& from, State& state) {
  swap_places(state.particles);
  take_part(state);
  deal_soil(state);
  put_vectors(from, "walls/built_offset", state.boundary.offset);
  if (from.has("walls/built_position"))
    put_dummies(from, "walls/built_position", state.boundary.walls);
  build_lists(state);
  swap_places(state.particles);
}

}  // namespace

Snapshot take_snapshot(const State& state) {
  Snapshot out;
  out.add("scene", scene_text(state.scene));
  out.add("isa", std::string(state.kernels.table->name));
  take_scalars(out, state);
  std::vector<std::int64_t> stands(state.boundary.stands.begin(), state.boundary.stands.end());
  out.add("walls/stands", std::move(stands));
  take_vectors(out, "walls/velocity", "m/s", state.boundary.velocity);
  std::vector<Vec3> hold_force = state.boundary.hold_force;
  state.reduction->sum_each(hold_force);
  take_vectors(out, "walls/hold_force", "N", hold_force);
  take_vectors(out, "walls/offset", "m", state.boundary.offset);
  take_vectors(out, "walls/placed_offset", "m", state.boundary.placed_offset);
  take_vectors(out, "walls/built_offset", "m", state.boundary.built_offset);
  if (state.boundary.walls.have_moved()) {
    take_dummies(out, "walls/position", state.boundary.walls, false);
    take_dummies(out, "walls/built_position", state.boundary.walls, true);
  }
  take_lost(out, state);
  take_fast_grains(out, state);
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
  put_fast_grains(snapshot, state);
  put_scalars(snapshot, state);
  const bool lists_valid = state.neighbours.valid;
  const double walls_moved = state.boundary.moved;
  set_material_constants(state);
  for (const FieldRow& field : state.particles.rows()) {
    if (kept(field)) put_field(snapshot, field, state);
  }
  if (lists_valid) {
    build_lists_again(snapshot, state);
  } else {
    take_part(state);
  }
  state.neighbours.valid = lists_valid;
  state.boundary.moved = walls_moved;
  put_vectors(snapshot, "walls/offset", state.boundary.offset);
  if (snapshot.has("walls/position")) put_dummies(snapshot, "walls/position", state.boundary.walls);
  if (state.stage.started) require_sound(state);
  if (!lists_valid) return;
  regroup_sleep(state);
  pack_forces(state);  // no step needs it, but who asks for forces on walls first
  pack_images(state);
  extrapolate_walls(state);
}

}  // namespace scarp
