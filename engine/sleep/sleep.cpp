// SPDX-License-Identifier: BSD-3-Clause
/// What soil asleep is to the sweeps, and how everything wakes.
#include "engine/sleep/sleep.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <iterator>
#include <numbers>

#include "engine/sleep/each_block.hpp"
#include "engine/state.hpp"

namespace scarp {
namespace {

void all_awake(Sleep& sleep) {
  sleep.asleep = 0;
  sleep.rest.clear();
  sleep.fell = false;
  sleep.reading = Reading::all;
  sleep.awake = sleep.swept = SlotRanges();
}

Rest& rest_of(Sleep& sleep, std::int32_t block) {
  return sleep.rest[static_cast<std::size_t>(block)];
}

/// Soil asleep that a block of `from` has for a neighbour, and that is nothing more than deep yet,
/// becomes `to`.
void mark_neighbours(int threads, Sleep& sleep, Rest from, Rest to) {
  const std::vector<Rest> before = sleep.rest;
  each_block(threads, std::ssize(before), [&](std::int32_t block) {
    const auto rest_before = [&](std::int32_t b) { return before[static_cast<std::size_t>(b)]; };
    if (rest_before(block) != Rest::deep) return;
    const auto near = sleep.graph.soil[block];
    if (std::any_of(near.begin(), near.end(),
                    [&](std::int32_t other) { return rest_before(other) == from; }))
      rest_of(sleep, block) = to;
  });
}

/// Soil awake that soil asleep has for a neighbour. Several threads may mark the same.
void mark_rim(int threads, Sleep& sleep) {
  sleep.rim.assign(sleep.rest.size(), 0);
  each_block(threads, std::ssize(sleep.rest), [&](std::int32_t block) {
    if (rest_of(sleep, block) != Rest::edge) return;
    for (const std::int32_t other : sleep.graph.soil[block]) {
      if (rest_of(sleep, other) == Rest::awake)
        std::atomic_ref(sleep.rim[static_cast<std::size_t>(other)])
            .store(1, std::memory_order_relaxed);
    }
  });
}

/// Clusters of dummies that sum soil for which is(block) holds, with what their columns ask of.
template <class Is>
std::vector<std::uint8_t> walls_near(const State& state, const Is& is) {
  const auto active = state.neighbours.wall_lists.active_clusters();
  const int size = state.kernels.table->cluster_size;
  std::vector<std::uint8_t> wanted(static_cast<std::size_t>(state.boundary.walls.slots() / size));
  const BlockLists& lists = state.sleep.graph.walls;
  each_block(state.threads, lists.size(), [&](std::int32_t k) {
    const auto near = lists[k];
    if (std::any_of(near.begin(), near.end(), is))
      wanted[static_cast<std::size_t>(active[static_cast<std::size_t>(k)])] = 1;
  });
  state.boundary.walls.add_partners(wanted, size);
  return wanted;
}

/// What is read by dummies in wanted clusters and, besides these, by soil: that is in `read`, by
/// block, which then holds both. Several threads may mark the same.
SleepReads reads_of(const State& state, const std::vector<std::uint8_t>& wanted,
                    std::vector<std::uint8_t>& read) {
  SleepReads reads;
  const auto active = state.neighbours.wall_lists.active_clusters();
  const BlockLists& lists = state.sleep.graph.walls;
  parallel_gather(state.threads, lists.size(), blocks_at_once, reads.wall_clusters,
                  [&](std::int64_t begin, std::int64_t end, auto& out) {
                    for (std::int64_t k = begin; k < end; ++k) {
                      const std::int32_t cluster = active[static_cast<std::size_t>(k)];
                      if (wanted[static_cast<std::size_t>(cluster)] == 0) continue;
                      out.push_back(cluster);
                      for (const std::int32_t block : lists[k])
                        std::atomic_ref(read[static_cast<std::size_t>(block)])
                            .store(1, std::memory_order_relaxed);
                    }
                  });
  reads.wall_columns =
      state.boundary.walls.columns().active_in(wanted, state.kernels.table->cluster_size);
  reads.images = state.boundary.images.of_soil(state.threads, read, block_size);
  reads.soil = SlotRanges(state.threads, state.particles.groups(), read);
  return reads;
}

/// Kick-drift-kick looks at the edge when the next step begins.
bool sweeps_edge(const State& state) {
  const bool verlet = state.scene.numerics.integrator == Integrator::verlet;
  return (state.report.step + (verlet ? 0 : 1)) % steps_per_edge_look(state.scene.dimension) == 0;
}

/// For every sweep that reads it: that of gradients at the edge needs it in another form, and where
/// inertia is not mass its records hold the one after a sweep of forces and the other before it.
bool repacks_what_sleeps(const State& state) {
  const bool verlet = state.scene.numerics.integrator == Integrator::verlet;
  return (verlet && state.kernels.corrects_forces()) || state.scaling.scales_mass;
}

}  // namespace

void classify_sleep(State& state) {
  Sleep& sleep = state.sleep;
  if (!sleep.any()) {
    all_awake(sleep);
    return;
  }
  for (Rest& rest : sleep.rest) {
    if (rest != Rest::awake) rest = Rest::deep;
  }
  mark_neighbours(state.threads, sleep, Rest::awake, Rest::edge);
  mark_neighbours(state.threads, sleep, Rest::edge, Rest::read);
  mark_rim(state.threads, sleep);
  const auto marks = [&](const auto& is) {
    std::vector<std::uint8_t> chosen(sleep.rest.size());
    each_block(state.threads, std::ssize(chosen), [&](std::int32_t block) {
      chosen[static_cast<std::size_t>(block)] = is(block) ? 1 : 0;
    });
    return chosen;
  };
  const auto up_to = [&](Rest most) {
    return [&sleep, most](std::int32_t block) { return rest_of(sleep, block) <= most; };
  };
  const auto fell = [&](std::int32_t block) {
    return sleep.fell && sleep.fallen[static_cast<std::size_t>(block)] != 0;
  };
  const auto edge_or_fell = [&](std::int32_t block) {
    return rest_of(sleep, block) <= Rest::edge || fell(block);
  };
  const auto read_or_fell = [&](std::int32_t block) {
    return rest_of(sleep, block) <= Rest::read || fell(block);
  };
  std::vector<std::uint8_t> read_awake = marks(up_to(Rest::edge));
  sleep.awake_reads = reads_of(state, walls_near(state, up_to(Rest::awake)), read_awake);
  const auto is_read_awake = [&](std::int32_t block) {
    return read_awake[static_cast<std::size_t>(block)] != 0;
  };
  std::vector<std::uint8_t> read_edge = marks(read_or_fell);
  sleep.edge_reads = reads_of(state, walls_near(state, edge_or_fell), read_edge);
  sleep.awake_reads.packed = sleep.awake_reads.soil;
  if (repacks_what_sleeps(state)) {
    sleep.edge_reads.packed = sleep.edge_reads.soil;
  } else {
    sleep.edge_reads.packed =
        SlotRanges(state.threads, state.particles.groups(),
                   marks([&](std::int32_t block) { return is_read_awake(block) || fell(block); }));
  }
  sleep.awake = SlotRanges(state.threads, state.particles.groups(), marks(up_to(Rest::awake)));
  sleep.swept = SlotRanges(state.threads, state.particles.groups(), marks(up_to(Rest::edge)));
  const std::int32_t clusters = static_cast<std::int32_t>(block_size) / state.kernels.cluster_size;
  const auto active = state.neighbours.lists.active_clusters();
  const auto clusters_up_to = [&](Rest most, RawVector<std::int32_t>& chosen) {
    parallel_gather(state.threads, std::ssize(active), blocks_at_once * clusters, chosen,
                    [&](std::int64_t begin, std::int64_t end, auto& out) {
                      for (std::int64_t k = begin; k < end; ++k) {
                        const std::int32_t cluster = active[static_cast<std::size_t>(k)];
                        if (rest_of(sleep, cluster / clusters) <= most) out.push_back(cluster);
                      }
                    });
  };
  clusters_up_to(Rest::awake, sleep.awake_clusters);
  clusters_up_to(Rest::edge, sleep.swept_clusters);
}

void ensure_block_graph(State& state) {
  if (state.sleep.graph_valid) return;
  state.sleep.graph = make_block_graph(state);
  state.sleep.graph_valid = true;
}

std::span<const std::int32_t> awake_clusters(const State& state) {
  return state.sleep.any() ? std::span<const std::int32_t>(state.sleep.awake_clusters)
                           : state.neighbours.lists.active_clusters();
}
std::span<const std::int32_t> swept_clusters(const State& state) {
  if (!sweeps_edge(state)) return awake_clusters(state);
  return state.sleep.any() ? std::span<const std::int32_t>(state.sleep.swept_clusters)
                           : state.neighbours.lists.active_clusters();
}
const SlotRanges& swept_slots(const State& state) {
  return sweeps_edge(state) ? state.sleep.swept : state.sleep.awake;
}

/// Kick-drift-kick sums no gradient at the edge.
void choose_reading(State& state, bool for_forces, bool all) {
  Sleep& sleep = state.sleep;
  const bool both = for_forces || state.scene.numerics.integrator == Integrator::verlet;
  if (all || !sleep.any() || (for_forces && sleep.records_stale)) {
    sleep.reading = Reading::all;
    sleep.records_stale = !for_forces;
  } else {
    const bool edge = both && (sweeps_edge(state) || sleep.fell);
    sleep.reading = edge ? Reading::edge : Reading::awake;
  }
  if (for_forces) sleep.fell = false;
}

namespace {

const SleepReads* reads(const State& state) {
  const Sleep& sleep = state.sleep;
  if (!sleep.any() || sleep.reading == Reading::all) return nullptr;
  return sleep.reading == Reading::edge ? &sleep.edge_reads : &sleep.awake_reads;
}

}  // namespace

SlotRanges soil_packed(const State& state) {
  const SleepReads* read = reads(state);
  return read != nullptr ? read->packed : SlotRanges();
}
SlotRanges soil_read(const State& state) {
  const SleepReads* read = reads(state);
  return read != nullptr ? read->soil : SlotRanges();
}
Walls::Chosen walls_summed(const State& state) {
  if (const SleepReads* read = reads(state)) return {read->wall_clusters, read->wall_columns};
  return {state.neighbours.wall_lists.active_clusters(), state.boundary.walls.columns().active()};
}
const MirrorImages::Generations& images_packed(const State& state) {
  const SleepReads* read = reads(state);
  return read != nullptr ? read->images : state.boundary.images.all();
}

/// What each bound leaves open, over the overburden: the change of the stress at the edge of soil
/// asleep, the mean force that calm soil may have over the window, and the wave that is stopped.
constexpr double share_of_each = 1.0 / (1.0 + 4.0 / std::numbers::pi + 2.0 / std::numbers::pi);

void set_sleep_bounds(State& state, double height, double passage) {
  const Vec3& g = state.scene.gravity;
  const Stage& stage = state.scene.stages[state.stage.index];
  Sleep& sleep = state.sleep;
  sleep.kinetic = 0.0;
  sleep.bounds = {};
  // Critical damping of the first mode is pi/2 over the passage.
  const bool settles = stage.until == StageEnd::rest && state.stage.damping * passage > 0.5;
  if (settles || !soil_may_sleep(state.scene) || !is_alone(*state.reduction)) return;
  const double sound = height / passage;
  sleep.bounds.lasting = share_of_each * state.scene.numerics.sleep * std::hypot(g[0], g[1], g[2]);
  sleep.bounds.speed = sleep.bounds.lasting * 2.0 * passage / std::numbers::pi;
  sleep.bounds.acceleration = sleep.bounds.speed * sound / state.smoothing_length;
  sleep.bounds.window = passage;
}

void wake_all(State& state) {
  Sleep& sleep = state.sleep;
  sleep.wake_due = false;
  sleep.graph_valid = false;
  if (double* stirred = state.particles.component(Field::stirred_time); stirred != nullptr)
    std::fill_n(stirred, state.particles.slots(), state.report.time);
  if (double* asleep = state.particles.component(Field::asleep); asleep != nullptr)
    std::fill_n(asleep, state.particles.slots(), 0.0);
  all_awake(sleep);
}

void regroup_sleep(State& state) {
  Sleep& sleep = state.sleep;
  double* asleep = state.particles.component(Field::asleep);
  if (asleep == nullptr || !state.neighbours.valid) return;
  if (!is_alone(*state.reduction)) {  // it slept before it was divided
    sleep.bounds = {};
    wake_all(state);
    return;
  }
  const std::vector<std::int64_t>& ids = state.particles.ids();
  const std::int64_t blocks = state.particles.slots() / block_size;
  all_awake(sleep);
  sleep.graph_valid = false;
  if (std::none_of(asleep, asleep + state.particles.slots(), [](double a) { return a != 0.0; }))
    return;
  ensure_block_graph(state);
  sleep.rest.assign(static_cast<std::size_t>(blocks), Rest::deep);
  for (std::int64_t block = 0; block < blocks; ++block) {
    const std::int64_t first = block * block_size;
    std::int64_t particles = 0, sleepers = 0;
    for (std::int64_t k = first; k < first + block_size; ++k) {
      if (ids[static_cast<std::size_t>(k)] < 0) continue;
      ++particles;
      sleepers += asleep[k] != 0.0 ? 1 : 0;
    }
    const auto b = static_cast<std::size_t>(block);
    if (particles > 0 && (sleepers < particles || sleep.graph.driven[b] != 0)) {
      sleep.rest[b] = Rest::awake;
      std::fill_n(asleep + first, block_size, 0.0);
      sleepers = 0;
    }
    sleep.asleep += sleepers;
  }
  classify_sleep(state);
}

}  // namespace scarp
