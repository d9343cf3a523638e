// SPDX-License-Identifier: BSD-3-Clause
/// Stages of a run.
#include "engine/stages/stages.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "engine/parallel.hpp"
#include "engine/particles/each_slot.hpp"
#include "engine/setup.hpp"
#include "engine/state.hpp"
#include "engine/watch/watch.hpp"
#include "kernels/pair/force_correction.hpp"

namespace scarp {
namespace {

/// Heights of particles' centres along gravity; without gravity along the last axis. Lost soil
/// counts only where all is lost.
class Heights {
 public:
  explicit Heights(const State& state) : state_(state) {
    const Vec3& g = state.scene.gravity;
    const double size = std::sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]);
    for (int a = 0; a < state.scene.dimension; ++a) {
      up_[static_cast<std::size_t>(a)] =
          size > 0.0 ? -g[static_cast<std::size_t>(a)] / size : (a == state.scene.dimension - 1);
    }
    const double all = state.reduction->sum_of(static_cast<double>(state.particles.count()));
    all_lost_ = static_cast<double>(state.lost.particles) == all;
  }
  bool counts(std::int64_t slot) const { return all_lost_ || !state_.is_lost(slot); }
  double operator[](std::int64_t slot) const {
    double up = 0.0;
    for (int a = 0; a < state_.scene.dimension; ++a)
      up += up_[static_cast<std::size_t>(a)] * state_.particles.component(Field::position, a)[slot];
    return up;
  }

 private:
  const State& state_;
  Vec3 up_{};
  bool all_lost_ = false;
};

/// Of each particle of this part of the soil, and its material.
std::vector<double> own_levels(const State& state) {
  const Heights heights(state);
  std::vector<double> found;
  for (const ParticleGroup& group : state.particles.groups()) {
    for (std::int64_t k = group.first; k < group.end(); ++k) {
      if (heights.counts(k))
        found.insert(found.end(), {heights[k], static_cast<double>(group.material)});
    }
  }
  return found;
}

/// Of all parts.
std::vector<std::pair<double, std::size_t>> levels(const State& state) {
  std::vector<double> found = own_levels(state);
  state.reduction->gather(found);
  std::vector<std::pair<double, std::size_t>> levels(found.size() / 2);
  for (std::size_t k = 0; k < levels.size(); ++k)
    levels[k] = {found[2 * k], static_cast<std::size_t>(found[2 * k + 1])};
  return levels;
}

/// The tallest stretch of soil without a gap along gravity beyond 2h, across which nothing acts:
/// what hangs in the air is no part of the ground below.
struct Stretch {
  double height = 0.0;   ///< [m]
  double passage = 0.0;  ///< of a wave at the speed in its slowest material [s]
};

using Levels = std::vector<std::pair<double, std::size_t>>;

/// Scaled inertia on soft soil swings more slowly than a wave crosses either of them. Equation: I2;
/// passage^2 = 2 int s rho F dz, F the integral of dz/M from the bottom to z: Dunkerley's sum, H/c
/// where the soil is uniform. For levels [first, end) of a stretch of this height.
double scaled_passage(const Scene& scene, const Levels& all, std::size_t first, std::size_t end,
                      double height) {
  const double layer = height / static_cast<double>(end - first);
  double compliance = 0.0, sum = 0.0;
  for (std::size_t i = first; i < end; ++i) {
    const Material& material = scene.materials[all[i].second];
    const double own = layer / material.model.moduli().wave_modulus();
    sum += material.mass_scaling * material.density * layer * (compliance + 0.5 * own);
    compliance += own;
  }
  return std::sqrt(2.0 * sum);
}

Stretch tallest_stretch(const State& state) {
  Levels all = levels(state);
  std::sort(all.begin(), all.end());
  Stretch tallest;
  for (std::size_t first = 0, k = 0; k < all.size(); ++k) {
    const bool ends =
        k + 1 == all.size() || all[k + 1].first - all[k].first > 2.0 * state.smoothing_length;
    if (!ends) continue;
    double slowest = std::numeric_limits<double>::infinity();
    for (std::size_t i = first; i <= k; ++i) {
      slowest = std::min(slowest, state.scene.materials[all[i].second].sound_speed());
    }
    const double height = all[k].first - all[first].first + state.particles.largest_spacing();
    tallest.height = std::max(tallest.height, height);
    tallest.passage = std::max(tallest.passage, height / slowest);
    if (state.scaling.scales_mass) {
      tallest.passage =
          std::max(tallest.passage, scaled_passage(state.scene, all, first, k + 1, height));
    }
    first = k + 1;
  }
  return tallest;
}

/// Of particles and walls [m/s].
double fastest(const State& state) {
  double speed = fastest_soil(state);
  for (const Vec3& v : state.boundary.velocity)
    speed = std::max(speed, std::hypot(v[0], v[1], v[2]));
  return speed;
}

void update_walls(State& state, const std::string& stage) {
  bool removed = false;
  for (std::size_t w = 0; w < state.scene.walls.size(); ++w) {
    const Wall& wall = state.scene.walls[w];
    if (wall.removed_at == stage && state.boundary.stands[w]) {
      state.boundary.stands[w] = false;
      removed = true;
    }
  }
  if (removed) place_walls(state);
  // A wall moves from the start of its stage on; a wall without one from the first stage.
  for (std::size_t w = 0; w < state.scene.walls.size(); ++w) {
    const Wall& wall = state.scene.walls[w];
    bool moves = wall.moves_from.empty();
    for (std::size_t s = 0; s <= state.stage.index; ++s)
      moves |= state.scene.stages[s].name == wall.moves_from;
    state.boundary.velocity[w] = moves && state.boundary.stands[w] ? wall.velocity : Vec3{};
  }
}

}  // namespace

double soil_height(const State& state) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  struct Range {
    double low = infinity, high = -infinity;
    void widen(const Range& more) {
      low = std::min(low, more.low);
      high = std::max(high, more.high);
    }
  } range;
  const Heights heights(state);
  for (const ParticleGroup& group : state.particles.groups()) {
    range.widen(parallel_reduce(
        state.threads, group.count, particle_chunk, Range{},
        [&](std::int64_t begin, std::int64_t end) {
          Range here;
          for (std::int64_t k = group.first + begin; k < group.first + end; ++k) {
            if (heights.counts(k)) here.widen({heights[k], heights[k]});
          }
          return here;
        },
        [](Range& total, const Range& part) { total.widen(part); }));
  }
  range.low = state.reduction->minimum_of(range.low);
  return state.reduction->maximum_of(range.high) - range.low + state.particles.largest_spacing();
}

double fastest_soil(const State& state) {
  double square = 0.0;
  for (const ParticleGroup& group : state.particles.groups()) {
    const double part = parallel_reduce(
        state.threads, group.count, particle_chunk, 0.0,
        [&](std::int64_t begin, std::int64_t end) {
          double most = 0.0;
          for (std::int64_t k = group.first + begin; k < group.first + end; ++k) {
            if (state.is_lost(k)) continue;
            double own = 0.0;
            for (int a = 0; a < state.scene.dimension; ++a) {
              const double v = state.particles.component(Field::velocity, a)[k];
              own += v * v;
            }
            most = std::max(most, own);
          }
          return most;
        },
        [](double& total, double more) { total = std::max(total, more); });
    square = std::max(square, part);
  }
  return std::sqrt(state.reduction->maximum_of(square));
}

void enter_stage(State& state) {
  const std::size_t index = state.stage.started ? state.stage.index + 1 : 0;
  if (state.stage.started && state.scene.stages[state.stage.index].reset_after)
    state.particles.reset();
  const Stage& stage = state.scene.stages[index];
  state.stage = StageClock{};
  state.stage.index = index;
  state.stage.started = true;
  update_walls(state, stage.name);
  set_material_constants(state);
  // A change is felt through the whole soil in a passage of a wave.
  const auto [height, passage] = tallest_stretch(state);
  // pi c_p / (2 H) is the circular frequency of a column's first mode: critical within a factor of
  // two.
  const bool settles = stage.until == StageEnd::rest && stage.reset_after;
  state.stage.damping = stage.damping.value_or(settles ? std::numbers::pi / (2.0 * passage) : 0.0);
  const Vec3& g = state.scene.gravity;
  const double fall = std::sqrt(height / std::max(std::hypot(g[0], g[1], g[2]), 1e-12));
  state.stage.rest_window = state.stage.damping > 0.0 ? 4.0 * passage : fall;
  if (state.scaling.scales_mass)  // what swings slowly is slow for long where it turns
    state.stage.rest_window = std::max(state.stage.rest_window, 4.0 * passage);
  state.stage.start_speed = fastest(state);
  wake_all(state);
  set_sleep_bounds(state, height, passage);
  state.clock.restart = true;
  state.clock.growth_base = 0.0;
  state.report.stage_time = 0.0;
}

void take_moment(State& state) {
  ParticleBuffers& p = state.particles;
  double *stress[6], *moment[6], *force_moment[6];
  p.components(Field::stress, stress);
  p.components(Field::moment, moment);
  p.components(Field::force_moment, force_moment);
  for (int c = 0; c < 6; ++c) {
    if (moment[c] == nullptr) continue;
    each_slot(state.threads, swept_slots(state), p.slots(),
              [&, c](std::int64_t begin, std::int64_t end) {
                std::copy(moment[c] + begin, moment[c] + end, force_moment[c] + begin);
              });
  }
  if (state.report.step > 0 || !state.start_is_geostatic) return;
  const bool flat = state.scene.dimension == 2;
  const auto read = [](double* const(&field)[6], std::int64_t k) {
    const auto value = [&](int c) { return field[c] != nullptr ? field[c][k] : 0.0; };
    return kernels::SymTensor<double>{value(0), value(1), value(2), value(3), value(4), value(5)};
  };
  for (const ParticleGroup& group : p.groups()) {
    for (std::int64_t k = group.first; k < group.end(); ++k) {
      kernels::SymTensor<double> m = read(moment, k);
      if (flat) m.zz = 1.0;
      const kernels::SymTensor<double> s =
          symmetric_part(kernels::corrected_stress(read(stress, k), m));
      const double all[6]{s.xx, s.yy, s.zz, s.xy, s.yz, s.zx};
      for (int c = 0; c < (flat ? 4 : 6); ++c) stress[c][k] = all[c];
    }
  }
}

void end_step(State& state) {
  const double dt = state.clock.time_step;
  ++state.report.step;
  ++state.limits.counts[static_cast<std::size_t>(state.report.limit)];
  state.report.time += dt;
  state.stage.time += dt;
  state.report.stage_time = state.stage.time;
  const Stage& stage = state.scene.stages[state.stage.index];
  if (state.report.limit == StepLimit::stage_end) state.stage.ended = true;
  if (stage.until == StageEnd::rest) {
    if (state.report.max_velocity >= stage.rest_velocity) {
      state.stage.calm_since = -1.0;
    } else if (state.stage.calm_since < 0.0) {
      state.stage.calm_since = state.stage.time;
    } else if (state.stage.time - state.stage.calm_since > state.stage.rest_window) {
      state.stage.ended = state.stage.reached_rest = true;
    }
  }
  if (state.stage.ended || state.report.step % steps_per_look == 0) count_lost_soil(state);
}

}  // namespace scarp
