// SPDX-License-Identifier: BSD-3-Clause
/// Differences of energies and powers before and after a hook.
#include "engine/energy/hook_work.hpp"

#include <algorithm>
#include <cmath>

#include "engine/state.hpp"

namespace scarp {

HookMeter::Vectors HookMeter::copy(Field field) const {
  Vectors values;
  for (int a = 0; a < state_.scene.dimension; ++a) {
    const double* from = state_.particles.component(field, a);
    values[static_cast<std::size_t>(a)].assign(from, from + state_.particles.slots());
  }
  return values;
}

void HookMeter::before_change(Field field) {
  if (field == Field::acceleration) {
    if (!acceleration_) acceleration_ = copy(field);
    return;
  }
  if (field == Field::velocity && !velocity_) velocity_ = copy(field);
  const bool stores_energy = field == Field::velocity || field == Field::position ||
                             field == Field::stress || field == Field::density;
  if (stores_energy && !energy_) energy_ = mechanical_energy(state_);
}

double HookMeter::largest_change(Field field, const Vectors& before) const {
  double largest = 0.0;
  for (const ParticleGroup& group : state_.particles.groups()) {
    for (std::int64_t k = group.first; k < group.end(); ++k) {
      double square = 0.0;
      for (int a = 0; a < state_.scene.dimension; ++a) {
        const double change = state_.particles.component(field, a)[k] -
                              before[static_cast<std::size_t>(a)][static_cast<std::size_t>(k)];
        square += change * change;
      }
      largest = std::max(largest, square);
    }
  }
  return std::sqrt(largest);
}

double HookMeter::power_of_change(const Vectors& before) const {
  double power = 0.0;
  for (const ParticleGroup& group : state_.particles.groups()) {
    for (int a = 0; a < state_.scene.dimension; ++a) {
      const double* v = state_.particles.component(Field::velocity, a);
      const double* now = state_.particles.component(Field::acceleration, a);
      const double* then = before[static_cast<std::size_t>(a)].data();
      double part = 0.0;
      for (std::int64_t k = group.first; k < group.end(); ++k) part += v[k] * (now[k] - then[k]);
      power += group.inertia() * part;
    }
  }
  return power;
}

void HookMeter::enter() {
  HookWork& sum = state_.ledger.hooks;
  const auto add = [&sum](double work) {
    sum.net += work;
    sum.sum += std::abs(work);
  };
  if (energy_) add(mechanical_energy(state_) - *energy_);
  if (velocity_) sum.speed += largest_change(Field::velocity, *velocity_);
  if (acceleration_) {
    const double time = share_ * state_.clock.time_step;
    add(time * power_of_change(*acceleration_));
    sum.speed += time * largest_change(Field::acceleration, *acceleration_);
  }
}

}  // namespace scarp
