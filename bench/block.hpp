// SPDX-License-Identifier: BSD-3-Clause
/// The state all benchmarks share: a free block of soil in compression on a jittered lattice.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>

#include "engine/setup.hpp"
#include "engine/step/step_phases.hpp"
#include "kernels/neighbour_block.hpp"

namespace scarp::bench {

struct BlockOptions {
  int dimension = 3;
  std::int64_t particles = 100'000;  ///< rounded to a full square or cube
  Numerics numerics = preset("paper");
  int threads = 1;
  std::string isa;
  std::optional<SoilModel> soil = {};  ///< in place of Drucker-Prager
  bool yielding = false;               ///< under a stress on the yield surface instead of within it
  bool tension = false;                ///< in uniform tension instead of compression
  bool walls = false;                  ///< no-slip base, free-slip sides
  bool energy = false;                 ///< the energy balance
};

/// Base and sides of a box; the soil is inside.
inline std::vector<Wall> box_walls(int dimension, double side) {
  const Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  std::vector<Wall> walls(2);
  walls[0].name = "base";
  walls[1].name = "sides";
  walls[1].kind = WallKind::free_slip;
  if (dimension == 2) {
    walls[0].facets = {{{}, x, {}, side, 0.0, y}};
    walls[1].facets = {{{}, y, {}, side, 0.0, x}, {{side, 0, 0}, y, {}, side, 0.0, {-1, 0, 0}}};
  } else {
    walls[0].facets = {{{}, x, y, side, side, z}};
    walls[1].facets = {{{}, y, z, side, side, x},
                       {{side, 0, 0}, y, z, side, side, {-1, 0, 0}},
                       {{}, x, z, side, side, y},
                       {{0, side, 0}, x, z, side, side, {0, -1, 0}}};
  }
  return walls;
}

/// Without plasticity.
inline SoilModel rock() { return LinearElastic{100e6, 0.3}; }

inline Scene block_scene(const BlockOptions& options) {
  Scene scene;
  scene.title = "free block";
  scene.dimension = options.dimension;
  scene.spacing = 1.0;
  scene.gravity = {};
  scene.gravity[static_cast<std::size_t>(options.dimension - 1)] = -9.81;
  scene.numerics = options.numerics;
  // Without cohesion the soil cannot come into tension while its faces let go.
  const double cohesion = options.tension ? 10e3 : 0.0;
  scene.materials = {{"soil",
                      DruckerPrager{100e6, 0.3, cohesion, 0.35, 0.15,
                                    options.dimension == 2 ? Cone::plane_strain : Cone::outer},
                      2000.0}};
  if (options.soil) scene.materials[0].model = *options.soil;
  const double side =
      std::round(std::pow(static_cast<double>(options.particles), 1.0 / options.dimension));
  scene.bodies = {{.shape = Box{{0, 0, 0}, {side, side, options.dimension == 3 ? side : 0.0}}}};
  const double pressure = options.tension ? -1e3 : 100e3;
  scene.initial_stress = InitialStress::uniform;
  const double across = options.yielding ? 0.2 * pressure : pressure;
  scene.uniform_stress = {-across, -pressure, -across, 0.0, 0.0, 0.0};
  if (options.walls) scene.walls = box_walls(options.dimension, side);
  scene.output.energy = options.energy;
  scene.stages.resize(1);
  scene.stages[0].name = "bench";
  scene.stages[0].duration = 1e9;
  return scene;
}

/// Records, and lists where they are due.
inline void refresh_neighbours(State& state) {
  for (const Phase& phase :
       {phases::pack_soil, phases::decide_rebuild, phases::rebuild_lists, phases::pack_images}) {
    phase.run(state);
  }
}

/// Positions jittered by up to 0.1 dx and velocities of 0.1 m/s, both from the particle's id, so
/// that every run sees the same block.
inline State block_state(const BlockOptions& options) {
  State state = make_state(block_scene(options), {options.threads, options.isa});
  const auto noise = [](std::int64_t id, int axis) {
    std::uint64_t x = static_cast<std::uint64_t>(id) * 3 + static_cast<std::uint64_t>(axis) + 1;
    x *= 0x9e3779b97f4a7c15u;
    x ^= x >> 31;
    x *= 0xbf58476d1ce4e5b9u;
    return static_cast<double>(x >> 11) * 0x1p-52 - 1.0;
  };
  for (const ParticleGroup& group : state.particles.groups()) {
    for (std::int64_t k = group.first; k < group.end(); ++k) {
      const std::int64_t id = state.particles.ids()[static_cast<std::size_t>(k)];
      for (int a = 0; a < options.dimension; ++a) {
        state.particles.component(Field::position, a)[k] += 0.1 * noise(id, a);
        state.particles.component(Field::velocity, a)[k] = 0.1 * noise(id, a + 7);
      }
    }
  }
  for (const Phase& phase :
       phases_of(state.scene.numerics.integrator, state.kernels.corrects_forces()).stage_start)
    phase.run(state);
  refresh_neighbours(state);
  return state;
}

/// Ordered pairs of soil particles closer than the support, counted from the lists, the particle's
/// own entry left out.
inline std::int64_t true_pairs(State& state) {
  const kernels::NeighbourView lists = state.neighbours.lists.view();
  const int size = state.kernels.cluster_size, dimension = state.scene.dimension;
  const double support = 2.0;
  std::int64_t pairs = 0;
  for (std::int64_t cluster = 0; cluster < state.neighbours.lists.clusters(); ++cluster) {
    const std::int64_t blocks = lists.wall_begin[cluster] - lists.soil_begin[cluster];
    for (std::int64_t e = 0; e < blocks * kernels::entry_block; ++e) {
      const kernels::NeighbourBlock block(lists,
                                          lists.soil_begin[cluster] + e / kernels::entry_block);
      for (int l = 0; l < size; ++l) {
        const std::int64_t i = cluster * size + l, j = block.record[e % kernels::entry_block];
        if (i == j || state.particles.ids()[static_cast<std::size_t>(i)] < 0) continue;
        double square = 0.0;
        for (int a = 0; a < dimension; ++a) {
          const double d = state.sweep.records.record(i)[a] - state.sweep.records.record(j)[a];
          square += d * d;
        }
        pairs += square < support * support;
      }
    }
  }
  return pairs;
}

}  // namespace scarp::bench
