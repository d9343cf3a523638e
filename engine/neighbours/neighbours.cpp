// SPDX-License-Identifier: BSD-3-Clause
/// Keeps order, cells, lists and records up to date with the particles' positions.
#include "engine/neighbours/neighbours.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <span>

#include "engine/cells/compact_clusters.hpp"
#include "engine/cells/radix_sort.hpp"
#include "engine/parallel.hpp"
#include "engine/scene/smoothing_choice.hpp"
#include "engine/state.hpp"
#include "engine/watch/too_light.hpp"
#include "engine/watch/watch.hpp"

namespace scarp {
namespace {

/// The state is put in Morton order at every so manieth rebuild: order decays slowly, sorting costs
/// a sweep.
constexpr std::uint64_t rebuilds_per_sort = 4;

PointSpan points_of(const ParticleBuffers& particles) {
  return {particles.component(Field::position, 0), particles.component(Field::position, 1),
          particles.component(Field::position, 2)};
}

/// Puts soil asleep ahead of the rest, so that few blocks hold both.
void put_sleepers_first(int threads, const double* asleep, std::span<std::int32_t> order) {
  RawVector<KeyedSlot> items(order.size()), scratch;
  const auto each = [&](const auto& visit) {
    parallel_chunks(
        threads, std::ssize(order), particle_chunk, [&](std::int64_t begin, std::int64_t end) {
          for (auto k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(end); ++k)
            visit(order[k], items[k]);
        });
  };
  each([asleep](std::int32_t slot, KeyedSlot& item) {
    item = {asleep[slot] != 0.0 ? 0u : 1u, slot};
  });
  sort_by_key(threads, items, scratch);
  each([](std::int32_t& slot, const KeyedSlot& item) { slot = item.slot; });
}

void sort_particles(State& state, const std::vector<SlotRange>& ranges) {
  RawVector<std::int32_t> order(static_cast<std::size_t>(state.particles.slots()));
  parallel_chunks(
      state.threads, std::ssize(order), particle_chunk, [&](std::int64_t begin, std::int64_t end) {
        std::iota(order.begin() + begin, order.begin() + end, static_cast<std::int32_t>(begin));
      });
  auto sorted = state.neighbours.cells[Role::owned].order();
  for (const SlotRange& range : ranges) {
    const auto count = static_cast<std::size_t>(range.end - range.begin);
    const std::span here = std::span(order).subspan(static_cast<std::size_t>(range.begin), count);
    parallel_chunks(state.threads, range.end - range.begin, particle_chunk,
                    [&](std::int64_t begin, std::int64_t end) {
                      std::copy(sorted.begin() + begin, sorted.begin() + end, here.begin() + begin);
                    });
    sorted = sorted.subspan(count);
    if (const double* asleep = state.particles.component(Field::asleep); asleep != nullptr)
      put_sleepers_first(state.threads, asleep, here);
    compact_clusters(state.threads, points_of(state.particles), state.kernels.cluster_size, here);
  }
  state.particles.permute(state.threads, order);
}

double list_reach(const State& state) {
  return (2.0 + state.scene.numerics.skin) * state.smoothing_length;
}

void mark_built(int threads, ParticleBuffers& particles) {
  for (int a = 0; a < particles.dimension(); ++a) {
    const double* from = particles.component(Field::position, a);
    double* to = particles.component(Field::build_position, a);
    parallel_chunks(threads, particles.slots(), particle_chunk,
                    [&](std::int64_t begin, std::int64_t end) {
                      std::copy(from + begin, from + end, to + begin);
                    });
  }
}

std::vector<SlotRange> ranges_of(const ParticleBuffers& particles) {
  std::vector<SlotRange> ranges;
  for (const ParticleGroup& group : particles.groups())
    ranges.push_back({group.first, group.end()});
  return ranges;
}

void build_soil_cells(State& state, const std::vector<SlotRange>& ranges) {
  state.neighbours.cells[Role::owned].build(state.threads, points_of(state.particles), ranges,
                                            0.5 * list_reach(state));
}

void put_material(State& state) {
  const std::vector<std::int32_t>& alike = state.scaling.alike;
  if (alike.empty()) return;
  Records& records = state.sweep.records;
  records.put_material(state.threads, Role::owned, state.particles, alike);
  records.put_material(state.threads, Role::ghost, state.ghosts, alike);
  state.boundary.images.copy_material(state.threads, records);
}

/// Dummies in reach of a particle take their stress from soil in reach of theirs; an inner point
/// (B6) takes it from soil that its column sees: half a spacing more for soil at the face.
double reach_through_walls(const Scene& scene, double reach) {
  return 2.0 * reach + (has_wall_columns(scene) ? 0.5 * scene.spacing : 0.0);
}

}  // namespace

void build_lists(State& state) {
  const double reach = list_reach(state), cell = 0.5 * reach;
  const std::vector<SlotRange> ranges = ranges_of(state.particles);
  std::vector<double> k0;
  for (const ParticleGroup& group : state.particles.groups())
    k0.push_back(state.material_constants[group.material].k0);
  build_soil_cells(state, ranges);

  const int dimension = state.scene.dimension;
  const double image_reach =
      state.boundary.walls.count() > 0 ? reach_through_walls(state.scene, reach) : reach;
  const WallPlacement placement{state.boundary.stands, state.boundary.offset};
  const std::vector<SlotRange> ghost_ranges = ranges_of(state.ghosts);
  state.boundary.images.select(
      state.threads, {state.scene, state.boundary.surface, placement, image_reach},
      {points_of(state.particles), ranges, k0, 0},
      {points_of(state.ghosts), ghost_ranges, k0, state.sweep.records.layout()[Role::ghost].first},
      hold_off_distance(state.particles.largest_spacing()) +
          state.scene.numerics.skin * state.smoothing_length,
      state.neighbours.fast);
  const MirrorImages& images = state.boundary.images;
  Walls& walls = state.boundary.walls;
  state.sweep.records.resize(state.threads, state.ghosts.slots(), images.count());
  put_material(state);
  std::vector<ParticleSource> sources;
  const FastGrains& fast = state.neighbours.fast;
  const auto add = [&](Role role, const PointSpan& points) {
    sources.push_back(
        {role, &state.neighbours.cells[role], points, state.sweep.records.layout()[role].first});
    if (role == Role::owned) sources.back().fast = fast.slots;
    if (role == Role::image) sources.back().fast = images.fast(state.threads);
  };
  const auto build_cells = [&](Role role, const PointSpan& points,
                               std::span<const SlotRange> ranges_there) {
    if (ranges_there.empty() || ranges_there.back().end == 0) return;
    state.neighbours.cells[role].build(state.threads, points, ranges_there, cell);
    add(role, points);
  };
  const SlotRange all_images{0, images.count()}, dummies = walls.dummies(), inner = walls.inner();
  add(Role::owned, points_of(state.particles));
  build_cells(Role::ghost, points_of(state.ghosts), ghost_ranges);
  build_cells(Role::image, images.points(), {&all_images, 1});
  NeighbourLists::Input input;
  input.points = points_of(state.particles);
  input.ranges = ranges;
  input.slots = state.particles.slots();
  input.far_record = state.sweep.records.layout().far_record();
  input.reach = reach;
  input.fast = fast.slots;
  input.more = fast.more;
  input.dimension = dimension;
  input.cluster_size = state.kernels.cluster_size;
  if (walls.count() > 0) {
    walls.choose_standing(state.scene, state.boundary.surface, placement);
    NeighbourLists::Input of_walls = input;
    of_walls.sources = sources;
    of_walls.points = walls.points();
    const SlotRange both[] = {dummies, inner};
    of_walls.ranges = both;
    of_walls.fast = {};
    of_walls.slots = walls.slots();
    of_walls.cluster_size = state.kernels.table->cluster_size;
    state.neighbours.wall_lists.build(state.threads, *state.kernels.table, of_walls);
    const SlotRange from_first{0, inner.end - inner.begin};
    if (walls.stand_as_built()) {
      add(Role::dummy, walls.points());
      if (from_first.end > 0) add(Role::inner, walls.inner_points());
    } else {
      build_cells(Role::dummy, walls.points(), {&dummies, 1});
      build_cells(Role::inner, walls.inner_points(), {&from_first, 1});
    }
  } else {
    state.neighbours.wall_lists = NeighbourLists();  // of walls that have gone
  }
  input.sources = sources;
  state.neighbours.lists.build(state.threads, *state.kernels.table, input);
  walls.mark_built(state.neighbours.wall_lists.active_clusters(),
                   state.kernels.table->cluster_size);
  state.boundary.built_offset = state.boundary.offset;
  state.boundary.moved = 0.0;
  state.neighbours.valid = true;
}

namespace {

StressForm form_of_forces(const State& state) {
  return state.kernels.corrects_forces() ? StressForm::corrected : StressForm::plain;
}

/// Records of soil asleep that nobody awake reads stay as the last sweep of forces had them.
void pack_as(State& state, StressForm form, bool all) {
  const Sleep& sleep = state.sleep;
  choose_reading(state, form == form_of_forces(state), all);
  const double square =
      state.sweep.records.pack(state.threads, Role::owned, state.particles, state.scaling,
                               state.kernels.slots, form, soil_packed(state));
  state.neighbours.moved = std::max(std::sqrt(square), sleep.any() ? sleep.moved : 0.0);
}

}  // namespace

void pack_soil(State& state) { pack_as(state, StressForm::plain, false); }
void pack_forces(State& state) { pack_as(state, form_of_forces(state), false); }

bool lists_are_outdated(const State& state) {
  const Neighbours& neighbours = state.neighbours;
  const double moved = state.reduction->maximum_of(neighbours.moved);
  // Two particles, or a particle and a wall, may close the skin from both sides; images move by
  // twice the way of their mirror.
  const double skin = state.scene.numerics.skin * state.smoothing_length;
  const double walls = state.boundary.moved;
  const bool closed =
      moved + (mirrors_move(state.scene) ? moved + 2.0 * walls : std::max(moved, walls)) > skin;
  return !neighbours.valid || (closed && (neighbours.fast.slots.empty() || margins_used_up(state)));
}

void decide_rebuild(State& state) { state.neighbours.due = lists_are_outdated(state); }

void rebuild_lists(State& state) {
  Neighbours& neighbours = state.neighbours;
  if (!neighbours.due) return;
  if (neighbours.valid) {
    watch_walls(state);
    watch_inertia(state);
  }
  const StressForm form = state.sweep.records.stress_form();
  deal_soil(state);
  if (neighbours.rebuilds % rebuilds_per_sort == 0) {
    const std::vector<SlotRange> ranges = ranges_of(state.particles);
    build_soil_cells(state, ranges);
    sort_particles(state, ranges);
  }
  ++neighbours.rebuilds;
  neighbours.fast = fast_grains(state);
  build_lists(state);
  mark_built(state.threads, state.particles);
  neighbours.due = false;
  state.sleep.moved = 0.0;
  regroup_sleep(state);
  pack_as(state, form, true);
}

void fit_records(State& state) {
  if (state.sweep.records.layout()[Role::owned].slots == state.particles.slots()) return;
  state.sweep.records = Records(state.particles.slots(), state.boundary.walls.dummy_slots(),
                                state.boundary.walls.inner_slots());
}

void deal_soil(State& state) {
  state.reduction->deal(state.particles, state.ghosts);
  state.changed = ghost_fields;
  fit_records(state);
}

double halo_of(const Scene& scene) {
  const double reach = (2.0 + scene.numerics.skin) * smoothing_length_of(scene);
  const bool any_dummies =
      std::any_of(scene.walls.begin(), scene.walls.end(),
                  [](const Wall& wall) { return wall.kind == WallKind::no_slip; });
  return any_dummies ? reach_through_walls(scene, reach) : reach;
}

namespace {

/// What the sweeps to come read of ghosts, as far as it has changed.
void refresh_ghosts(State& state) {
  const bool corrected = state.sweep.records.stress_form() == StressForm::corrected;
  DataSet read{Field::position, Field::velocity, Field::density, Field::stress};
  if (corrected) read = read | DataSet(Field::force_moment, Field::strain_rate);
  if (!corrected && state.kernels.slots.has(kernels::record_diffusivity))
    read = read | DataSet(Field::diffusivity);
  state.reduction->refresh(state.particles, state.ghosts, read & state.changed);
  state.changed = state.changed.without(read);
}

}  // namespace

void pack_images(State& state) {
  refresh_ghosts(state);
  Records& records = state.sweep.records;
  records.pack(state.threads, Role::ghost, state.ghosts, state.scaling, state.kernels.slots,
               records.stress_form());
  const MirrorImages::Mirrors mirrors{state.scaling.inverse_smoothing_length, state.boundary.offset,
                                      state.boundary.velocity, state.scene.gravity};
  if (records.stress_form() == StressForm::corrected) {
    state.boundary.images.pack_corrected(state.threads, records, mirrors, state.particles,
                                         state.ghosts, images_packed(state));
  } else {
    state.boundary.images.pack(state.threads, records, mirrors, images_packed(state));
  }
}

}  // namespace scarp
