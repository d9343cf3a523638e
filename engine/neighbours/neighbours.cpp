// SPDX-License-Identifier: BSD-3-Clause
/// Keeps order, cells, lists and records up to date with the particles' positions.
#include "engine/neighbours/neighbours.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "engine/cells/compact_clusters.hpp"
#include "engine/parallel.hpp"
#include "engine/state.hpp"
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

void sort_particles(State& state, const std::vector<SlotRange>& ranges) {
  std::vector<std::int32_t> order(static_cast<std::size_t>(state.particles.slots()));
  std::iota(order.begin(), order.end(), 0);
  std::size_t next = 0;
  for (const SlotRange& range : ranges) {
    for (std::int64_t k = range.begin; k < range.end; ++k) {
      order[static_cast<std::size_t>(k)] = state.neighbours.soil_cells.order()[next++];
    }
    compact_clusters(state.threads, points_of(state.particles), state.kernels.cluster_size,
                     std::span(order).subspan(static_cast<std::size_t>(range.begin),
                                              static_cast<std::size_t>(range.end - range.begin)));
  }
  state.particles.permute(state.threads, order);
}

double list_reach(const State& state) {
  return (2.0 + state.scene.numerics.skin) * state.smoothing_length;
}

std::vector<SlotRange> soil_ranges(const State& state) {
  std::vector<SlotRange> ranges;
  for (const ParticleGroup& group : state.particles.groups())
    ranges.push_back({group.first, group.end()});
  return ranges;
}

void build_soil_cells(State& state, const std::vector<SlotRange>& ranges) {
  state.neighbours.soil_cells.build(state.threads, points_of(state.particles), ranges,
                                    0.5 * list_reach(state));
}

}  // namespace

void build_lists(State& state) {
  const double reach = list_reach(state), cell = 0.5 * reach;
  const std::vector<SlotRange> ranges = soil_ranges(state);
  std::vector<double> k0;
  for (const ParticleGroup& group : state.particles.groups())
    k0.push_back(state.material_constants[group.material].k0);
  build_soil_cells(state, ranges);

  const int dimension = state.scene.dimension;
  // Dummies beside a plane need the images their own stress is taken from: twice the reach of the
  // soil.
  const double image_reach = state.boundary.walls.count() > 0 ? 2.0 * reach : reach;
  const WallPlacement placement{state.boundary.stands, state.boundary.offset};
  state.boundary.images.select(
      state.scene, state.boundary.surface, placement, points_of(state.particles), ranges, k0,
      image_reach,
      hold_off_distance(state.scene.spacing) + state.scene.numerics.skin * state.smoothing_length);
  state.sweep.records.resize_images(state.boundary.images.count());
  NeighbourLists::Input input;
  input.points = points_of(state.particles);
  input.ranges = ranges;
  input.slots = state.particles.slots();
  input.soil = {&state.neighbours.soil_cells, input.points, 0};
  if (state.boundary.images.count() > 0) {
    const SlotRange images{0, state.boundary.images.count()};
    state.neighbours.image_cells.build(state.threads, state.boundary.images.points(), {&images, 1},
                                       cell);
    input.images = {&state.neighbours.image_cells, state.boundary.images.points(),
                    state.sweep.records.first_image()};
  }
  input.far_record = state.sweep.records.far_record();
  input.reach = reach;
  input.dimension = dimension;
  input.cluster_size = state.kernels.cluster_size;
  if (state.boundary.walls.count() > 0) {
    state.boundary.walls.choose_standing(state.scene, state.boundary.surface, placement);
    const SlotRange dummies = state.boundary.walls.range();
    state.neighbours.wall_cells.build(state.threads, state.boundary.walls.points(), {&dummies, 1},
                                      cell);
    input.walls = {&state.neighbours.wall_cells, state.boundary.walls.points(),
                   state.sweep.records.first_wall()};
    NeighbourLists::Input of_walls = input;
    of_walls.points = state.boundary.walls.points();
    of_walls.ranges = {&dummies, 1};
    of_walls.slots = state.boundary.walls.slots();
    of_walls.walls = {};
    of_walls.cluster_size = state.kernels.table->cluster_size;
    state.neighbours.wall_lists.build(state.threads, *state.kernels.table, of_walls);
  }
  state.neighbours.lists.build(state.threads, *state.kernels.table, input);
  for (int a = 0; a < dimension; ++a) {
    const double* from = state.particles.component(Field::position, a);
    std::copy(from, from + state.particles.slots(),
              state.particles.component(Field::build_position, a));
  }
  state.boundary.walls.mark_built();
  state.boundary.built_offset = state.boundary.offset;
  state.boundary.moved = 0.0;
  state.neighbours.valid = true;
}

void pack_soil(State& state) {
  Neighbours& neighbours = state.neighbours;
  neighbours.moved =
      std::sqrt(state.sweep.records.pack_soil(state.threads, state.particles, state.scaling));
}

bool lists_are_outdated(const State& state) {
  const Neighbours& neighbours = state.neighbours;
  const double moved = state.reduction->maximum_of(neighbours.moved);
  // Two particles, or a particle and a wall, may close the skin from both sides.
  const double skin = state.scene.numerics.skin * state.smoothing_length;
  return !neighbours.valid || moved + std::max(moved, state.boundary.moved) > skin;
}

void decide_rebuild(State& state) { state.neighbours.due = lists_are_outdated(state); }

void rebuild_lists(State& state) {
  Neighbours& neighbours = state.neighbours;
  if (!neighbours.due) return;
  if (neighbours.valid) watch_walls(state);
  if (neighbours.rebuilds % rebuilds_per_sort == 0) {
    const std::vector<SlotRange> ranges = soil_ranges(state);
    build_soil_cells(state, ranges);
    sort_particles(state, ranges);
  }
  ++neighbours.rebuilds;
  build_lists(state);
  neighbours.due = false;
  pack_soil(state);
}

void pack_images(State& state) {
  state.boundary.images.pack(state.sweep.records, state.scaling.inverse_smoothing_length,
                             state.boundary.offset, state.boundary.velocity, state.scene.gravity);
}

}  // namespace scarp
