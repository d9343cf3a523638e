// SPDX-License-Identifier: BSD-3-Clause
/// What soil asleep is to the sweeps, and how everything wakes.
#include "engine/sleep/sleep.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/state.hpp"

namespace scarp {
namespace {

void all_awake(Sleep& sleep) {
  sleep.asleep = 0;
  sleep.rest.clear();
  sleep.awake = sleep.swept = sleep.packed = SlotRanges();
}

Rest& rest_of(Sleep& sleep, std::int32_t block) {
  return sleep.rest[static_cast<std::size_t>(block)];
}

/// Soil asleep that a block of `from` has for a neighbour, and that is nothing more than deep yet,
/// becomes `to`.
void mark_neighbours(Sleep& sleep, Rest from, Rest to) {
  const std::int64_t blocks = std::ssize(sleep.rest);
  for (std::int32_t block = 0; block < blocks; ++block) {
    if (rest_of(sleep, block) != Rest::deep) continue;
    const auto near = sleep.graph.soil[block];
    if (std::any_of(near.begin(), near.end(),
                    [&](std::int32_t other) { return rest_of(sleep, other) == from; }))
      rest_of(sleep, block) = to;
  }
}

/// Soil awake that soil asleep has for a neighbour.
void mark_rim(Sleep& sleep) {
  sleep.rim.assign(sleep.rest.size(), 0);
  const std::int64_t blocks = std::ssize(sleep.rest);
  for (std::int32_t block = 0; block < blocks; ++block) {
    if (rest_of(sleep, block) != Rest::edge) continue;
    for (const std::int32_t other : sleep.graph.soil[block]) {
      if (rest_of(sleep, other) == Rest::awake) sleep.rim[static_cast<std::size_t>(other)] = 1;
    }
  }
}

/// Dummies that the swept soil reads, and what they read.
void mark_walls(State& state) {
  Sleep& sleep = state.sleep;
  sleep.wall_clusters.clear();
  const auto active = state.neighbours.wall_lists.active_clusters();
  const int size = state.kernels.table->cluster_size;
  std::vector<std::uint8_t> wanted(static_cast<std::size_t>(state.boundary.walls.slots() / size));
  for (std::int64_t k = 0; k < sleep.graph.walls.size(); ++k) {
    const auto near = sleep.graph.walls[k];
    if (std::any_of(near.begin(), near.end(),
                    [&](std::int32_t block) { return rest_of(sleep, block) <= Rest::edge; }))
      wanted[static_cast<std::size_t>(active[static_cast<std::size_t>(k)])] = 1;
  }
  state.boundary.walls.add_partners(wanted, size);
  for (std::int64_t k = 0; k < sleep.graph.walls.size(); ++k) {
    const std::int32_t cluster = active[static_cast<std::size_t>(k)];
    if (wanted[static_cast<std::size_t>(cluster)] == 0) continue;
    sleep.wall_clusters.push_back(cluster);
    for (const std::int32_t block : sleep.graph.walls[k]) {
      Rest& rest = rest_of(sleep, block);
      rest = std::min(rest, Rest::read);
    }
  }
}

/// Kick-drift-kick looks at the edge when the next step begins.
bool sweeps_edge(const State& state) {
  const bool verlet = state.scene.numerics.integrator == Integrator::verlet;
  return (state.report.step + (verlet ? 0 : 1)) % steps_per_edge_look == 0;
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
  mark_neighbours(sleep, Rest::awake, Rest::edge);
  mark_neighbours(sleep, Rest::edge, Rest::read);
  mark_rim(sleep);
  mark_walls(state);
  const auto up_to = [&](Rest most) {
    std::vector<std::uint8_t> chosen(sleep.rest.size());
    std::transform(sleep.rest.begin(), sleep.rest.end(), chosen.begin(),
                   [most](Rest rest) { return rest <= most ? 1 : 0; });
    return SlotRanges(state.particles.groups(), chosen);
  };
  sleep.awake = up_to(Rest::awake);
  sleep.swept = up_to(Rest::edge);
  sleep.packed = up_to(Rest::read);
  sleep.awake_clusters.clear();
  sleep.swept_clusters.clear();
  const std::int32_t clusters = static_cast<std::int32_t>(block_size) / state.kernels.cluster_size;
  for (const std::int32_t cluster : state.neighbours.lists.active_clusters()) {
    const Rest rest = rest_of(sleep, cluster / clusters);
    if (rest <= Rest::edge) sleep.swept_clusters.push_back(cluster);
    if (rest == Rest::awake) sleep.awake_clusters.push_back(cluster);
  }
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
std::span<const std::int32_t> wall_clusters(const State& state) {
  const Sleep& sleep = state.sleep;
  return sleep.any() && !sleep.packed_all ? std::span<const std::int32_t>(sleep.wall_clusters)
                                          : state.neighbours.wall_lists.active_clusters();
}

/// What each bound leaves open, over the overburden: the change of the force that soil asleep may
/// have, the mean force that calm soil may have over the window, and the wave that is stopped.
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
