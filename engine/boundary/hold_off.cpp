// SPDX-License-Identifier: BSD-3-Clause
/// Keeps grains from passing a face.
#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "engine/boundary/facet_geometry.hpp"
#include "engine/boundary/held_zone.hpp"
#include "engine/parallel.hpp"
#include "engine/state.hpp"

namespace scarp {

using namespace geometry;

namespace {

/// Where faces meet at an acute angle, what one takes away may point towards the other.
constexpr int most_passes = 8;

/// What the faces did in one pass.
struct Holds {
  std::uint64_t count = 0;
  std::vector<Vec3> impulse;  ///< of the soil on each wall [N s]; empty: no grain was held

  void add(std::size_t wall, std::size_t walls, const Vec3& more) {
    if (impulse.empty()) impulse.resize(walls);
    impulse[wall] = plus(impulse[wall], 1.0, more);
  }
};

void merge(Holds& total, const Holds& part) {
  total.count += part.count;
  for (std::size_t w = 0; w < part.impulse.size(); ++w)
    total.add(w, part.impulse.size(), part.impulse[w]);
}

/// Of a kick from rest the damping has taken its share.
double acceleration_over_change(const State& state) {
  const double kick = state.clock.kick;
  return (1.0 + 0.5 * state.stage.damping * kick) / kick;
}

bool halves(const State& state) {
  return state.scene.numerics.integrator == Integrator::kick_drift_kick;
}

/// Mean force of a step over the impulse of one pass. Both halves of kick-drift-kick have a pass;
/// Verlet takes the velocity over two steps and so holds off what two steps bring.
double force_over_impulse(const State& state) {
  return (halves(state) ? 0.5 : 1.0) * acceleration_over_change(state);
}

/// Way over the change of velocity. Verlet has moved the soil by 1/2 a dt^2 of what the face holds
/// off too; kick-drift-kick moves by the held velocity.
double way_over_change(const State& state) {
  const double dt = state.clock.time_step;
  return halves(state) ? 0.0 : 0.5 * dt * dt * acceleration_over_change(state);
}

}  // namespace

double hold_off_distance(double spacing) { return held_zone::before_face * spacing; }

/// Equation: B4; the velocity towards the face, relative to it, becomes zero. Pair sums alone let
/// single grains of a thin front sink: their stress goes to zero with every bounce at the apex.
void hold_off_faces(State& state) {
  if (state.boundary.walls.count() == 0 && state.boundary.images.count() == 0) return;
  const std::size_t walls = state.scene.walls.size();
  const kernels::NeighbourView lists = state.neighbours.lists.view();
  const std::int64_t size = state.kernels.cluster_size;
  const int dimension = state.scene.dimension;
  std::array<double*, 3> position{};
  std::array<double*, 3> velocity{};
  for (int a = 0; a < dimension; ++a) {
    position[static_cast<std::size_t>(a)] = state.particles.component(Field::position, a);
    velocity[static_cast<std::size_t>(a)] = state.particles.component(Field::velocity, a);
  }
  const WallSurface& surface = state.boundary.surface;
  const std::vector<std::uint32_t> few = surface.all_if_few(state.boundary.stands);
  const WallPlacement placement{state.boundary.stands, state.boundary.offset};
  const double reach = std::max(held_zone::before_face, held_zone::behind_face) *
                       state.particles.largest_spacing() * (1.0 + 1e-6);
  const double way = way_over_change(state);
  const auto hold = [&](std::int64_t k, const ParticleGroup& group, Holds& holds,
                        FacetSearch& search) {
    const double spacing = group.spacing;
    Vec3 x{}, v{};
    for (std::size_t a = 0; a < static_cast<std::size_t>(dimension); ++a) {
      x[a] = position[a][k];
      v[a] = velocity[a][k];
    }
    const std::span<const std::uint32_t> near =
        few.empty() ? surface.near(x, reach, placement, search) : few;
    bool held = false;
    int faces = 2;
    for (int pass = 0; pass < most_passes && faces > 1; ++pass) {
      faces = 0;
      for (const std::uint32_t face : near) {
        const auto& [facet, w] = surface.faces()[face];
        const FacetCoordinates at =
            coordinates(facet, dimension, minus(x, state.boundary.offset[w]));
        if (at.depth < -held_zone::before_face * spacing ||
            at.depth > held_zone::behind_face * spacing)
          continue;
        const double approach = -dot(minus(v, state.boundary.velocity[w]), facet.normal);
        if (approach <= 0.0 || !at.above(facet, 0.0)) continue;
        v = plus(v, approach, facet.normal);
        held = true;
        holds.add(w, walls, plus({}, -group.inertia() * approach, facet.normal));
        ++faces;
      }
    }
    for (std::size_t a = 0; held && a < static_cast<std::size_t>(dimension); ++a) {
      position[a][k] += way * (v[a] - velocity[a][k]);
      velocity[a][k] = v[a];
    }
    holds.count += held ? 1 : 0;
  };
  const std::span<const std::int32_t> awake = awake_clusters(state);
  const auto run = [&](std::int64_t begin, std::int64_t end) {
    Holds holds;
    FacetSearch search;
    const auto look = [&](std::int64_t cluster) {
      const bool has_dummies = lists.wall_begin[cluster] != lists.wall_end[cluster];
      if (!has_dummies && !state.boundary.images.is_close(cluster * size, size)) return;
      const ParticleGroup& group = state.particles.group_of(cluster * size);
      const std::int64_t last = std::min((cluster + 1) * size, group.end());
      for (std::int64_t k = cluster * size; k < last; ++k) hold(k, group, holds, search);
    };
    // Soil near a face is in a list or has one.
    const auto first = std::lower_bound(awake.begin(), awake.end(), begin);
    for (auto cluster = first; cluster != awake.end() && *cluster < end; ++cluster) look(*cluster);
    return holds;
  };
  const Holds all = parallel_reduce(state.threads, state.neighbours.lists.clusters(),
                                    particle_chunk / size, Holds{}, run, merge);
  state.boundary.holds += all.count;
  for (std::size_t w = 0; w < all.impulse.size(); ++w)
    state.boundary.hold_force[w] =
        plus(state.boundary.hold_force[w], force_over_impulse(state), all.impulse[w]);
}

}  // namespace scarp
