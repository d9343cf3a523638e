// SPDX-License-Identifier: BSD-3-Clause
/// The variable time step.
#include "engine/integrate/time_step.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

#include "engine/particles/each_slot.hpp"
#include "kernels/pair/term_rows.hpp"

namespace scarp {
namespace {

struct TermLimit {
  kernels::Term term;
  StepLimit limit;
};
constexpr std::size_t limit_count =
    std::ranges::count_if(kernels::term_rows, [](const auto& row) { return row.limit != nullptr; });

/// The limits that pair terms name. Does not compile where one has no such name.
constexpr std::array<TermLimit, limit_count> limits_of_terms() {
  std::array<TermLimit, limit_count> limits{};
  std::size_t next = 0;
  for (const kernels::TermRow& row : kernels::term_rows) {
    if (row.limit == nullptr) continue;
    const auto* name = std::ranges::find(step_limit_names, std::string_view(row.limit),
                                         [](const char* known) { return std::string_view(known); });
    if (name == std::end(step_limit_names)) throw "a pair term names a limit that is not known";
    limits[next++] = {row.term, static_cast<StepLimit>(name - std::begin(step_limit_names))};
  }
  return limits;
}
constexpr std::array term_limits = limits_of_terms();

}  // namespace

StateExtremes find_extremes(int threads, const ParticleBuffers& particles, const SlotRanges& which,
                            const RecordScaling& scaling, const Vec3& gravity, double damping) {
  const int dimension = particles.dimension();
  const double *velocity[3], *acceleration[3];
  particles.components(Field::velocity, velocity);
  particles.components(Field::acceleration, acceleration);
  const double* density = particles.component(Field::density);
  const double* approach = particles.component(Field::approach_rate);
  StateExtremes result;
  for (std::size_t index = 0; index < particles.groups().size(); ++index) {
    const ParticleGroup& group = particles.groups()[index];
    const double modulus = scaling.wave_modulus[group.material];
    const Vec3 fall = group.fall(gravity);
    const auto scan = [&](std::int64_t begin, std::int64_t end) {
      StateExtremes e;
      for (std::int64_t k = begin; k < end; ++k) {
        double speed = 0.0, force = 0.0;
        for (int a = 0; a < dimension; ++a) {
          const double v = velocity[a][k];
          const double f = acceleration[a][k] + fall[static_cast<std::size_t>(a)] - damping * v;
          speed += v * v;
          force += f * f;
        }
        const double nearing = approach != nullptr ? approach[k] : 0.0;
        const double signal = std::sqrt(modulus / density[k]) + nearing;
        // One sum catches NaN and infinity of every part.
        if (!(speed + force + signal < 1e300) && e.bad_slot < 0) e.bad_slot = k;
        e.speed_squared = std::max(e.speed_squared, speed);
        e.acceleration_squared = std::max(e.acceleration_squared, force);
        e.signal_speed = std::max(e.signal_speed, signal);
        e.approach = std::max(e.approach, nearing);
      }
      return e;
    };
    const StateExtremes part = reduce_slots(
        threads, which, group, index, group.end(), StateExtremes{}, scan,
        [](StateExtremes& total, const StateExtremes& e) {
          total.speed_squared = std::max(total.speed_squared, e.speed_squared);
          total.acceleration_squared = std::max(total.acceleration_squared, e.acceleration_squared);
          total.signal_speed = std::max(total.signal_speed, e.signal_speed);
          total.approach = std::max(total.approach, e.approach);
          if (total.bad_slot < 0) total.bad_slot = e.bad_slot;
        });
    result.speed_squared = std::max(result.speed_squared, part.speed_squared);
    result.acceleration_squared = std::max(result.acceleration_squared, part.acceleration_squared);
    if (part.signal_speed > result.signal_speed) {
      result.signal_speed = part.signal_speed;
      result.signal_material = group.material;
    }
    result.approach = std::max(result.approach, part.approach);
    if (result.bad_slot < 0) result.bad_slot = part.bad_slot;
  }
  return result;
}

void join(StateExtremes& extremes, Reduction& reduction) {
  const double own = extremes.signal_speed;
  std::array<double, 4> most{extremes.speed_squared, extremes.acceleration_squared, own,
                             extremes.approach};
  reduction.maximum(most);
  // Of materials with the same signal speed the first.
  const double material = own == most[2] ? static_cast<double>(extremes.signal_material)
                                         : std::numeric_limits<double>::infinity();
  extremes = {most[0],
              most[1],
              most[2],
              most[3],
              static_cast<std::size_t>(reduction.minimum_of(material)),
              extremes.bad_slot};
}

AdmissibleStep admissible_step(const StateExtremes& extremes, const DampingRates& rates,
                               double smoothing_length, double cfl) {
  const double signal = extremes.signal_speed,
               acceleration = std::sqrt(extremes.acceleration_squared);
  const bool sound = extremes.approach <= 0.5 * signal;
  AdmissibleStep step{smoothing_length / signal, sound ? StepLimit::acoustic : StepLimit::approach};
  const auto bound = [&step](double time_step, StepLimit limit) {
    if (time_step < step.time_step) step = {time_step, limit};
  };
  if (acceleration > 0.0) bound(std::sqrt(smoothing_length / acceleration), StepLimit::force);
  // Terms with the same limit damp the same waves: their rates add up.
  std::array<double, std::size(step_limit_names)> damping{};
  for (const auto& [term, limit] : term_limits) {
    const kernels::DampingRate& rate = rates[static_cast<std::size_t>(term)];
    damping[static_cast<std::size_t>(limit)] +=
        rate.signal * signal + rate.approach * extremes.approach;
  }
  for (std::size_t limit = 0; limit < damping.size(); ++limit) {
    if (damping[limit] > 0.0)
      bound(smoothing_length / damping[limit], static_cast<StepLimit>(limit));
  }
  step.time_step *= cfl;
  return step;
}

}  // namespace scarp
