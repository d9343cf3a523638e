// SPDX-License-Identifier: BSD-3-Clause
/// Who falls asleep and who wakes. Equation: Z1.
#include <algorithm>
#include <cmath>

#include "engine/sleep/each_block.hpp"
#include "engine/sleep/sleep.hpp"
#include "engine/state.hpp"

namespace scarp {
namespace {

/// What wakes soil is so many times what it may have when it falls asleep.
constexpr double wake_over_calm = 4.0;

/// Steps between two looks for soil that rests.
constexpr std::uint64_t steps_per_sleep_look = 8;

/// In place of a time: the particle has fallen asleep, and its force has not been summed since.
constexpr double no_force_yet = -1.0;

double square(double x) { return x * x; }

class SleepUpdate {
 public:
  explicit SleepUpdate(State& state)
      : state_(state),
        sleep_(state.sleep),
        particles_(state.particles),
        ids_(state.particles.ids()),
        now_(state.report.time) {
    particles_.components(Field::velocity, velocity_);
    particles_.components(Field::acceleration, acceleration_);
    for (const FieldRow& row : particles_.rows()) {
      if (row.field >= declared_field(0)) history_.push_back(particles_.component(row.field));
    }
  }

  /// Wakes soil at the edge of what sleeps, if its force or its neighbours say so. Returns whether
  /// any has woken.
  bool wake() {
    if (!sleep_.any()) return false;
    const double fast_square = square(wake_over_calm * sleep_.bounds.speed);
    const std::vector<std::uint8_t> fast = for_blocks([&](std::int32_t block) {
      return sleep_.rim[static_cast<std::size_t>(block)] != 0 && any_faster(block, fast_square);
    });
    const std::vector<std::uint8_t> wakes = for_blocks([&](std::int32_t block) {
      if (rest(block) != Rest::edge) return false;
      const auto near = sleep_.graph.soil[block];
      return std::any_of(
                 near.begin(), near.end(),
                 [&](std::int32_t other) { return fast[static_cast<std::size_t>(other)] != 0; }) ||
             has_lost_balance(block);
    });
    return apply(wakes, [&](std::int32_t block) { put_awake(block); });
  }

  /// Blocks that have been calm for the window, among blocks that are calm. Returns whether any has
  /// fallen asleep.
  bool fall_asleep() {
    const std::vector<std::uint8_t> calm =
        for_blocks([&](std::int32_t block) { return rest(block) != Rest::awake || look(block); });
    std::vector<std::uint8_t> falls = for_blocks([&](std::int32_t block) {
      return rest(block) == Rest::awake && calm[static_cast<std::size_t>(block)] != 0 &&
             rested(block);
    });
    if (std::none_of(falls.begin(), falls.end(), [](std::uint8_t f) { return f != 0; }))
      return false;
    ensure_block_graph(state_);
    falls = for_blocks([&](std::int32_t block) {
      const auto b = static_cast<std::size_t>(block);
      if (falls[b] == 0 || sleep_.graph.driven[b] != 0) return false;
      const auto near = sleep_.graph.soil[block];
      return std::all_of(near.begin(), near.end(), [&](std::int32_t other) {
        return calm[static_cast<std::size_t>(other)] != 0;
      });
    });
    if (sleep_.rest.empty()) sleep_.rest.assign(falls.size(), Rest::awake);
    sleep_.fallen = falls;
    return apply(falls, [&](std::int32_t block) { put_to_sleep(block); });
  }

 private:
  Rest rest(std::int32_t block) const {
    return sleep_.rest.empty() ? Rest::awake : sleep_.rest[static_cast<std::size_t>(block)];
  }

  /// Is(block) for every block, as 0 or 1.
  template <class Is>
  std::vector<std::uint8_t> for_blocks(const Is& is) const {
    const std::int64_t blocks = particles_.slots() / block_size;
    std::vector<std::uint8_t> found(static_cast<std::size_t>(blocks));
    each_block(state_.threads, blocks, [&](std::int32_t block) {
      found[static_cast<std::size_t>(block)] = is(block) ? 1 : 0;
    });
    return found;
  }
  /// Calls act(block) where chosen, in order; returns whether there was any.
  template <class Act>
  static bool apply(const std::vector<std::uint8_t>& chosen, const Act& act) {
    bool any = false;
    for (std::size_t b = 0; b < chosen.size(); ++b) {
      if (chosen[b] == 0) continue;
      act(static_cast<std::int32_t>(b));
      any = true;
    }
    return any;
  }
  /// Calls act(slot) for the particles of a block.
  template <class Act>
  void each_particle(std::int32_t block, const Act& act) const {
    const std::int64_t first = block * block_size;
    for (std::int64_t k = first; k < first + block_size; ++k) {
      if (ids_[static_cast<std::size_t>(k)] >= 0) act(k);
    }
  }

  /// Inertia over mass. Sleep takes momentum and force away, and bounds are those of soil whose
  /// inertia is its mass.
  double scaling(std::int32_t block) const {
    return particles_.group_of(block * block_size).mass_scaling;
  }
  /// Squares of what a particle has.
  double speed_square(std::int64_t k) const {
    double sum = 0.0;
    for (int a = 0; a < particles_.dimension(); ++a) sum += square(velocity_[a][k]);
    return sum;
  }
  double unbalanced_square(std::int64_t k, double scaling) const {
    double sum = 0.0;
    for (int a = 0; a < particles_.dimension(); ++a)
      sum +=
          square(scaling * acceleration_[a][k] + state_.scene.gravity[static_cast<std::size_t>(a)]);
    return sum;
  }
  bool any_faster(std::int32_t block, double bound_square) const {
    bool any = false;
    const double momentum = square(scaling(block));
    each_particle(block,
                  [&](std::int64_t k) { any = any || momentum * speed_square(k) > bound_square; });
    return any;
  }

  /// Notes when particles were last stirred: too fast, out of balance, or yielding. Returns whether
  /// none is.
  bool look(std::int32_t block) {
    double* const time = particles_.component(Field::stirred_time);
    double* const then = particles_.component(Field::stirred_history);
    const double yields = yield_bound(block);
    const SleepBounds& bounds = sleep_.bounds;
    const double by_mass = scaling(block);
    bool calm = true;
    each_particle(block, [&](std::int64_t k) {
      bool stirred = !(square(by_mass) * speed_square(k) <= square(bounds.speed) &&
                       unbalanced_square(k, by_mass) <= square(bounds.acceleration));
      if (then != nullptr) {
        double history = 0.0;
        for (const double* values : history_) history += values[k];
        if (!(std::abs(history - then[k]) <= yields)) {
          then[k] = history;
          stirred = true;
        }
      }
      if (!stirred) return;
      time[k] = now_;
      calm = false;
    });
    return calm;
  }
  /// The elastic strain by the stress that a lasting change of the force over h makes.
  double yield_bound(std::int32_t block) const {
    const std::size_t material = particles_.group_of(block * block_size).material;
    return sleep_.bounds.lasting * state_.scene.materials[material].density *
           state_.smoothing_length / (scaling(block) * state_.scaling.wave_modulus[material]);
  }
  bool rested(std::int32_t block) const {
    const double* time = particles_.component(Field::stirred_time);
    bool all = true;
    bool any = false;
    each_particle(block, [&](std::int64_t k) {
      any = true;
      all = all && now_ - time[k] >= sleep_.bounds.window;
    });
    return any && all;
  }

  /// Whether the force of any particle has changed by too much since it was first summed with the
  /// particle asleep, at once or in the mean over the window; brings that mean up to date.
  bool has_lost_balance(std::int32_t block) {
    const double interval =
        static_cast<double>(steps_per_edge_look(state_.scene.dimension)) * state_.clock.time_step;
    const double weight = std::min(1.0, interval / sleep_.bounds.window);
    const double by_mass = scaling(block);
    bool lost = false;
    double* const time = particles_.component(Field::stirred_time);
    each_particle(block, [&](std::int64_t k) {
      if (time[k] == no_force_yet) {
        copy(Field::acceleration, Field::rest_acceleration, k);
        time[k] = now_;
      }
      double at_once = 0.0;
      double lasting = 0.0;
      for (int a = 0; a < particles_.dimension(); ++a) {
        double& mean = particles_.component(Field::rest_change, a)[k];
        const double change =
            by_mass * (acceleration_[a][k] - particles_.component(Field::rest_acceleration, a)[k]);
        mean += weight * (change - mean);
        at_once += change * change;
        lasting += mean * mean;
      }
      lost = lost || at_once > square(wake_over_calm * sleep_.bounds.acceleration) ||
             lasting > square(sleep_.bounds.change_at_edge());
    });
    return lost;
  }

  void put_awake(std::int32_t block) {
    double* const time = particles_.component(Field::stirred_time);
    double* const asleep = particles_.component(Field::asleep);
    each_particle(block, [&](std::int64_t k) {
      asleep[k] = 0.0;
      time[k] = now_;
      --sleep_.asleep;
    });
    sleep_.rest[static_cast<std::size_t>(block)] = Rest::awake;
  }

  /// The level before is the one that stays; what follows from a velocity is that of zero.
  void put_to_sleep(std::int32_t block) {
    const double inertia = particles_.group_of(block * block_size).inertia();
    each_particle(block, [&](std::int64_t k) {
      sleep_.kinetic += 0.5 * inertia * speed_square(k);
      for (const Field field : {Field::velocity, Field::previous_velocity, Field::diffusivity,
                                Field::strain_rate, Field::approach_rate})
        fill(field, k, 0.0);
      fill(Field::rest_change, k, 0.0);
      fill(Field::stirred_time, k, no_force_yet);
      copy(Field::density, Field::previous_density, k);
      copy(Field::stress, Field::previous_stress, k);
      fill(Field::asleep, k, 1.0);
      ++sleep_.asleep;
    });
    sleep_.rest[static_cast<std::size_t>(block)] = Rest::deep;
    sleep_.fell = true;
    sleep_.moved = std::max(sleep_.moved, state_.neighbours.moved);
  }
  void fill(Field field, std::int64_t k, double value) {
    for (int c = 0; c < component_count(row(field).rank); ++c) {
      if (double* values = particles_.component(field, c); values != nullptr) values[k] = value;
    }
  }
  void copy(Field from, Field to, std::int64_t k) {
    for (int c = 0; c < component_count(row(to).rank); ++c) {
      if (double* values = particles_.component(to, c); values != nullptr)
        values[k] = particles_.component(from, c)[k];
    }
  }

  State& state_;
  Sleep& sleep_;
  ParticleBuffers& particles_;
  const std::vector<std::int64_t>& ids_;
  double now_;
  const double *velocity_[3]{}, *acceleration_[3]{};
  std::vector<const double*> history_;
};

}  // namespace

void update_sleep(State& state) {
  if (!state.sleep.wanted()) return;
  SleepUpdate update(state);
  bool changed =
      state.report.step % steps_per_edge_look(state.scene.dimension) == 0 && update.wake();
  if (state.report.step % steps_per_sleep_look == 0) changed = update.fall_asleep() || changed;
  if (changed) classify_sleep(state);
}

}  // namespace scarp
