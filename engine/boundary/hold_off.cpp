// SPDX-License-Identifier: BSD-3-Clause
/// Keeps grains from passing a face.
#include <array>

#include "engine/boundary/facet_geometry.hpp"
#include "engine/parallel.hpp"
#include "engine/state.hpp"

namespace scarp {

using namespace geometry;

namespace {

/// Distances to the face, in spacings, between which a grain may not go deeper. Soil that is packed
/// keeps half a spacing from the face: only a grain that its own pair forces do not hold gets here.
constexpr double nearest = 0.25, deepest = -0.5;

/// Where faces meet at an acute angle, what one takes away may point towards the other.
constexpr int most_passes = 8;

}  // namespace

double hold_off_distance(double spacing) { return nearest * spacing; }

/// Equation: B4; the velocity towards the face, relative to it, becomes zero. Pair sums alone let
/// single grains of a thin front sink: their stress goes to zero with every bounce at the apex.
void hold_off_faces(State& state) {
  if (state.walls.count() == 0 && state.images.count() == 0) return;
  const kernels::NeighbourView lists = state.lists.view();
  const std::int64_t size = state.kernels.cluster_size;
  const int dimension = state.scene.dimension;
  const double spacing = state.scene.spacing;
  std::array<const double*, 3> position{};
  std::array<double*, 3> velocity{};
  for (int a = 0; a < dimension; ++a) {
    position[static_cast<std::size_t>(a)] = state.particles.component(Field::position, a);
    velocity[static_cast<std::size_t>(a)] = state.particles.component(Field::velocity, a);
  }
  const auto hold = [&](std::int64_t k) {
    Vec3 x{}, v{};
    for (std::size_t a = 0; a < static_cast<std::size_t>(dimension); ++a) {
      x[a] = position[a][k];
      v[a] = velocity[a][k];
    }
    std::uint64_t held = 0;
    int faces = 2;
    for (int pass = 0; pass < most_passes && faces > 1; ++pass) {
      faces = 0;
      for (std::size_t w = 0; w < state.scene.walls.size(); ++w) {
        if (!state.wall_stands[w]) continue;
        const Vec3 from_wall = minus(x, state.wall_offset[w]);
        for (const Facet& facet : state.scene.walls[w].facets) {
          const FacetCoordinates at = coordinates(facet, dimension, from_wall);
          if (at.depth < -nearest * spacing || at.depth > -deepest * spacing) continue;
          const double approach = -dot(minus(v, state.wall_velocity[w]), facet.normal);
          if (approach <= 0.0 || !at.above(facet, 0.0)) continue;
          v = plus(v, approach, facet.normal);
          held = 1;
          ++faces;
        }
      }
    }
    for (std::size_t a = 0; held != 0 && a < static_cast<std::size_t>(dimension); ++a)
      velocity[a][k] = v[a];
    return held;
  };
  const auto run = [&](std::int64_t begin, std::int64_t end) {
    std::uint64_t held = 0;
    for (std::int64_t cluster = begin; cluster < end; ++cluster) {
      const bool has_dummies = lists.wall_begin[cluster] != lists.soil_begin[cluster + 1];
      if (!has_dummies && !state.images.is_close(cluster * size, size)) continue;
      for (std::int64_t k = cluster * size; k < (cluster + 1) * size; ++k) held += hold(k);
    }
    return held;
  };
  state.holds += parallel_reduce(state.threads, state.lists.clusters(), particle_chunk / size,
                                 std::uint64_t{0}, run,
                                 [](std::uint64_t& total, std::uint64_t part) { total += part; });
}

}  // namespace scarp
