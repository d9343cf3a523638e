// SPDX-License-Identifier: BSD-3-Clause
/// Cells, order and lists: each part of a rebuild, the order's decay, and Morton against Hilbert
/// order, with and without compact clusters.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "bench/bench_main.hpp"
#include "bench/block.hpp"
#include "bench/hilbert.hpp"
#include "engine/cells/compact_clusters.hpp"
#include "engine/parallel.hpp"

namespace scarp::bench {
namespace {

PointSpan points_of(const State& state) {
  return {state.particles.component(Field::position, 0),
          state.particles.component(Field::position, 1),
          state.particles.component(Field::position, 2)};
}
SlotRange soil_of(const State& state) {
  const ParticleGroup& group = state.particles.groups().front();
  return {group.first, group.end()};
}
double cell_of(const State& state) {
  return 0.5 * (2.0 + state.scene.numerics.skin) * state.smoothing_length;
}

void count(benchmark::State& bench, const State& state) {
  bench.counters["particles_per_second"] = benchmark::Counter(
      static_cast<double>(state.particles.count()), benchmark::Counter::kIsIterationInvariantRate);
}

void keys(benchmark::State& bench, State& state) {
  const PointSpan p = points_of(state);
  const SlotRange soil = soil_of(state);
  std::vector<std::uint64_t> out(static_cast<std::size_t>(soil.end));
  for (auto _ : bench) {
    for (std::int64_t k = soil.begin; k < soil.end; ++k) {
      out[static_cast<std::size_t>(k)] = morton_key(state.neighbours.cells[Role::owned].cell_of(
          p.x[k], p.y[k], p.z != nullptr ? p.z[k] : 0.0));
    }
    benchmark::DoNotOptimize(out.data());
  }
  count(bench, state);
}

/// Keys, sort and hash table of cells, from an order that is almost right, as in a run.
void cells(benchmark::State& bench, State& state) {
  const SlotRange soil = soil_of(state);
  CellGrid grid;
  for (auto _ : bench) grid.build(state.threads, points_of(state), {&soil, 1}, cell_of(state));
  count(bench, state);
}

/// Moving every field of every particle to its new slot.
void permute(benchmark::State& bench, State& state) {
  std::vector<std::int32_t> order(static_cast<std::size_t>(state.particles.slots()));
  std::iota(order.begin(), order.end(), 0);
  for (auto _ : bench) state.particles.permute(state.threads, order);
  count(bench, state);
}

/// Cells and lists together, without sorting: what a rebuild costs.
void rebuild(benchmark::State& bench, State& state) {
  for (auto _ : bench) {
    state.neighbours.valid = false;
    state.neighbours.rebuilds = 1;  // the engine sorts at every fourth, counted from 0
    refresh_neighbours(state);
  }
  count(bench, state);
  bench.counters["entries_per_particle"] = static_cast<double>(state.neighbours.lists.entries()) /
                                           static_cast<double>(state.particles.count());
}

/// The same with a re-sort before it.
void rebuild_sorted(benchmark::State& bench, State& state) {
  for (auto _ : bench) {
    state.neighbours.valid = false;
    state.neighbours.rebuilds = 0;
    refresh_neighbours(state);
  }
  count(bench, state);
}

enum class Order { morton, hilbert, random };

/// `compact` splits blocks of the order into compact clusters, as the engine does.
void put_in_order(State& state, Order wanted, bool compact) {
  const PointSpan p = points_of(state);
  const SlotRange soil = soil_of(state);
  std::vector<std::int32_t> order(static_cast<std::size_t>(state.particles.slots()));
  std::iota(order.begin(), order.end(), 0);
  const auto begin = order.begin() + soil.begin, end = order.begin() + soil.end;
  if (wanted == Order::random) {
    std::shuffle(begin, end, std::mt19937(1));
  } else {
    std::vector<std::uint64_t> keys(order.size());
    for (std::int64_t k = soil.begin; k < soil.end; ++k) {
      std::array<std::uint32_t, 3> cell{};
      const auto of = state.neighbours.cells[Role::owned].cell_of(p.x[k], p.y[k],
                                                                  p.z != nullptr ? p.z[k] : 0.0);
      for (std::size_t a = 0; a < 3; ++a) cell[a] = static_cast<std::uint32_t>(of[a]);
      keys[static_cast<std::size_t>(k)] =
          wanted == Order::hilbert ? hilbert_key(cell, state.scene.dimension) : morton_key(of);
    }
    std::stable_sort(begin, end, [&](std::int32_t a, std::int32_t b) {
      return keys[static_cast<std::size_t>(a)] < keys[static_cast<std::size_t>(b)];
    });
  }
  if (compact)
    compact_clusters(state.threads, p, state.kernels.cluster_size, std::span(begin, end));
  state.particles.permute(state.threads, order);
  state.neighbours.valid = false;
  state.neighbours.rebuilds = 1;
  refresh_neighbours(state);
}

/// The fused sweep with the particles in a given order.
void sweep_in_order(benchmark::State& bench, const BlockOptions& options, Order order,
                    bool compact) {
  State state = block_state(options);
  put_in_order(state, order, compact);
  const auto pairs = static_cast<double>(true_pairs(state));
  for (auto _ : bench) sweep_all(state);
  count(bench, state);
  bench.counters["useful_lane_share"] =
      pairs / (static_cast<double>(state.neighbours.lists.entries()) * state.kernels.cluster_size);
}

}  // namespace

void add_all(bool /*full*/) {
  const auto add = [](const std::string& name, auto run) {
    benchmark::RegisterBenchmark(name.c_str(), run)->UseRealTime()->Unit(benchmark::kMillisecond);
  };
  struct Part {
    const char* name;
    void (*run)(benchmark::State&, State&);
  };
  for (const int dimension : {3, 2}) {
    for (const std::int64_t particles : {64'000, 1'000'000}) {
      const BlockOptions options{dimension, particles, preset("paper"), 1, {}};
      for (const Part part : {Part{"keys", keys}, Part{"cells", cells}, Part{"permute", permute},
                              Part{"rebuild", rebuild}, Part{"rebuild_sorted", rebuild_sorted}}) {
        add(fmt::format("{}/{}d/{}", part.name, dimension, particles),
            [=](benchmark::State& bench) {
              State state = block_state(options);
              part.run(bench, state);
            });
      }
      struct Arrangement {
        const char* name;
        Order order;
        bool compact;
      };
      for (const Arrangement way : {Arrangement{"morton", Order::morton, false},
                                    Arrangement{"hilbert", Order::hilbert, false},
                                    Arrangement{"morton_compact", Order::morton, true},
                                    Arrangement{"hilbert_compact", Order::hilbert, true},
                                    Arrangement{"random", Order::random, false}}) {
        if (way.order == Order::random && particles > 100'000) continue;
        add(fmt::format("sweep_in_order/{}/{}d/{}", way.name, dimension, particles),
            [=](benchmark::State& bench) {
              sweep_in_order(bench, options, way.order, way.compact);
            });
      }
    }
  }
}

}  // namespace scarp::bench
