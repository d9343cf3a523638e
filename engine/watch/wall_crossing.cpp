// SPDX-License-Identifier: BSD-3-Clause
/// Finds grains that have passed a face from its soil side.
#include <limits>
#include <span>
#include <vector>

#include <fmt/format.h>

#include "engine/boundary/facet_geometry.hpp"
#include "engine/boundary/held_zone.hpp"
#include "engine/parallel.hpp"
#include "engine/state.hpp"
#include "engine/watch/watch.hpp"

namespace scarp {

using namespace geometry;

namespace {

struct Crossing {
  std::int64_t slot = -1;
  std::size_t wall = 0;
  double depth = 0.0;
};

Vec3 point_of(const ParticleBuffers& particles, Field field, std::int64_t slot) {
  Vec3 point{};
  for (int a = 0; a < particles.dimension(); ++a)
    point[static_cast<std::size_t>(a)] = particles.component(field, a)[slot];
  return point;
}

Crossing first_crossing(const State& state) {
  const int dimension = state.scene.dimension;
  const WallSurface& surface = state.boundary.surface;
  const std::vector<std::uint32_t> few = surface.all_if_few(state.boundary.stands);
  const WallPlacement walls{state.boundary.stands, state.boundary.offset};
  // Of a chunk, the first particle that has passed the first face that any has.
  const auto look = [&](std::int64_t begin, std::int64_t end, double lost) {
    FacetSearch search;
    Crossing first;
    std::uint32_t first_face = std::numeric_limits<std::uint32_t>::max();
    for (std::int64_t k = begin; k < end; ++k) {
      const Vec3 place = point_of(state.particles, Field::position, k),
                 built = point_of(state.particles, Field::build_position, k);
      const double reach = lost * (1.0 + 1e-6);
      const std::span<const std::uint32_t> near =
          few.empty()
              ? surface.on_way(built, state.boundary.built_offset, place, walls, reach, search)
              : few;
      for (const std::uint32_t face : near) {
        if (face >= first_face) break;
        const auto& [facet, w] = surface.faces()[face];
        const Vec3 now = minus(place, state.boundary.offset[w]);
        const Vec3 before = minus(built, state.boundary.built_offset[w]);
        if (!goes_in(facet, dimension, before, now, lost)) continue;
        first = {k, w, coordinates(facet, dimension, now).depth};
        first_face = face;
      }
    }
    return first;
  };
  for (const ParticleGroup& group : state.particles.groups()) {
    const Crossing found = parallel_reduce(
        state.threads, group.count, particle_chunk, Crossing{},
        [&](std::int64_t begin, std::int64_t end) {
          return look(group.first + begin, group.first + end,
                      held_zone::behind_face * group.spacing);
        },
        [](Crossing& total, const Crossing& part) {
          if (total.slot < 0) total = part;
        });
    if (found.slot >= 0) return found;
  }
  return {};
}

}  // namespace

void watch_walls(const State& state) {
  const Crossing found = first_crossing(state);
  if (found.slot < 0) return;
  Instability lost = at_particle(state, found.slot);
  lost.field = fmt::format("depth behind wall '{}'", state.scene.walls[found.wall].name);
  lost.unit = std::string("m");
  lost.value = found.depth;
  lost.limit = held_zone::behind_face * state.particles.group_of(found.slot).spacing;
  lost.cause = std::string(
      "a grain pressed or thrown through the face: soil too soft for its load, a gap or a sharp "
      "corner near by, or a time step too long; from here they look alike");
  lost.advice = advice_after_step_test(
      "walls that meet, a stiffer soil, a finer spacing or a no-slip face may help");
  throw SimulationInstability(lost);
}

}  // namespace scarp
