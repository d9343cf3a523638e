// SPDX-License-Identifier: BSD-3-Clause
/// Which grains are fast, and how far they may go.
#include "engine/neighbours/fast_grains.hpp"

#include <algorithm>
#include <cmath>

#include "engine/parallel.hpp"
#include "engine/state.hpp"

namespace scarp {
namespace {

/// Lists that serve so many steps cost little enough.
constexpr double enough_steps = 50.0;
/// Of all particles, at most, may be fast.
constexpr std::int64_t one_in = 200, most_grains = 64;
/// The entries that the wider reach adds, at most, as a share of all.
constexpr double added_entries = 0.05;

struct Grain {
  double speed_squared;
  std::int64_t slot;
};

/// Leaves the fastest in descending order, at most so many; ties by slot.
void keep_fastest(std::vector<Grain>& grains, std::int64_t most) {
  const auto kept = std::min<std::int64_t>(most, std::ssize(grains));
  std::partial_sort(grains.begin(), grains.begin() + kept, grains.end(),
                    [](const Grain& a, const Grain& b) {
                      return a.speed_squared > b.speed_squared ||
                             (a.speed_squared == b.speed_squared && a.slot < b.slot);
                    });
  grains.resize(static_cast<std::size_t>(kept));
}

double half_skin(const State& state) {
  return 0.5 * state.scene.numerics.skin * state.smoothing_length;
}

/// Components of a field.
struct Components {
  Components(const ParticleBuffers& particles, Field field) : dimension(particles.dimension()) {
    for (int a = 0; a < dimension; ++a) values[a] = particles.component(field, a);
  }
  double squared(std::int64_t k) const {
    double sum = 0.0;
    for (int a = 0; a < dimension; ++a) sum += values[a][k] * values[a][k];
    return sum;
  }
  double squared_from(const Components& from, std::int64_t k) const {
    double sum = 0.0;
    for (int a = 0; a < dimension; ++a) {
      const double step = values[a][k] - from.values[a][k];
      sum += step * step;
    }
    return sum;
  }
  int dimension;
  const double* values[3]{};
};

}  // namespace

bool FastGrains::among(std::int64_t slot, std::int64_t count) const {
  const auto first = std::lower_bound(slots.begin(), slots.end(), slot);
  return first != slots.end() && *first < slot + count;
}

FastGrains fast_grains(const State& state) {
  const double dt = state.clock.time_step, half = half_skin(state);
  if (!is_alone(*state.reduction) || dt <= 0.0 || half <= 0.0) return {};
  const ParticleBuffers& p = state.particles;
  // Those that use their margin up too soon; whoever is faster than the last of them too.
  const double limit = half / (enough_steps * dt);
  const std::int64_t most = std::min(most_grains, p.count() / one_in);
  if (most == 0 || state.report.max_velocity < limit) return {};
  const Components velocity(p, Field::velocity);
  std::vector<Grain> grains;
  for (const ParticleGroup& group : p.groups()) {
    const auto faster = [&](std::int64_t begin, std::int64_t end) {
      std::vector<Grain> found;
      for (std::int64_t k = group.first + begin; k < group.first + end; ++k) {
        const double speed_squared = velocity.squared(k);
        if (speed_squared > limit * limit) found.push_back({speed_squared, k});
      }
      keep_fastest(found, most + 1);  // and the next one, which is not fast
      return found;
    };
    const std::vector<Grain> of_group =
        parallel_reduce(state.threads, group.count, particle_chunk, std::vector<Grain>{}, faster,
                        [](std::vector<Grain>& all, const std::vector<Grain>& part) {
                          all.insert(all.end(), part.begin(), part.end());
                        });
    grains.insert(grains.end(), of_group.begin(), of_group.end());
  }
  if (grains.empty()) return {};
  keep_fastest(grains, most + 1);
  const double fastest = std::sqrt(grains.front().speed_squared);
  const double support = 2.0 * state.smoothing_length;
  const auto room = [&](std::int64_t count) {  // how far they may go at that cost
    const double share =
        added_entries * static_cast<double>(p.count()) / static_cast<double>(count);
    return support * (std::pow(share, 1.0 / p.dimension()) - 1.0);
  };
  // Steps until the lists are built anew, by how many are fast: the rest sets one limit, the reach
  // that many can be given the other.
  double best_steps = 2.0 * half / (fastest * dt);  // worth it if they serve twice as long
  FastGrains best;
  std::int64_t chosen = 0;
  for (std::int64_t count = 1; count <= std::min<std::int64_t>(most, std::ssize(grains)); ++count) {
    const auto next = static_cast<std::size_t>(count);
    const double rest = next < grains.size() ? std::sqrt(grains[next].speed_squared) : limit;
    const double steps = std::min(half / (rest * dt), (half + room(count)) / (fastest * dt));
    if (steps > best_steps) {
      best_steps = steps;
      chosen = count;
    }
  }
  if (chosen == 0) return {};
  best.more = best_steps * fastest * dt - half;
  for (std::int64_t k = 0; k < chosen; ++k)
    best.slots.push_back(grains[static_cast<std::size_t>(k)].slot);
  std::sort(best.slots.begin(), best.slots.end());
  return best;
}

bool margins_used_up(const State& state) {
  const FastGrains& fast = state.neighbours.fast;
  const ParticleBuffers& p = state.particles;
  const double mirrors = mirrors_move(state.scene) ? state.boundary.moved : 0.0;
  const double half = half_skin(state) - mirrors, margin = half + fast.more;
  if (half < 0.0) return true;
  const Components now(p, Field::position), built(p, Field::build_position);
  for (const std::int64_t k : fast.slots) {
    if (!(now.squared_from(built, k) <= margin * margin)) return true;
  }
  double farthest = 0.0;
  for (const ParticleGroup& group : p.groups()) {
    const auto farthest_of = [&](std::int64_t begin, std::int64_t end) {
      double most = 0.0;
      for (std::int64_t k = group.first + begin; k < group.first + end; ++k) {
        const double here = now.squared_from(built, k);
        if (!(here <= most) && !fast.among(k, 1)) most = here;
      }
      return most;
    };
    const double of_group = parallel_reduce(state.threads, group.count, particle_chunk, 0.0,
                                            farthest_of, [](double& total, double part) {
                                              if (!(part <= total)) total = part;
                                            });
    if (!(of_group <= farthest)) farthest = of_group;
  }
  return !(farthest <= half * half) || state.boundary.moved > half;
}

}  // namespace scarp
