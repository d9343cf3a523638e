// SPDX-License-Identifier: BSD-3-Clause
/// Rest of nearly all of the soil.

#include "validation/paper/nearly_at_rest.hpp"

#include <cmath>
#include <vector>

#include "validation/deposit.hpp"

namespace scarp::validation {

bool nearly_at_rest(const Simulation& now, double height) {
  constexpr std::uint64_t steps_per_look = 50;
  const Scene& scene = now.scene();
  if (now.stage_index() + 1 < scene.stages.size() || now.last_step().step % steps_per_look != 0)
    return false;
  const double gravity = std::hypot(scene.gravity[0], scene.gravity[1], scene.gravity[2]);
  if (now.last_step().stage_time < 3.0 * std::sqrt(height / gravity)) return false;
  const std::vector<double> velocity = now.field("velocity");
  std::vector<double> speed;
  for (std::size_t i = 0; i < velocity.size(); i += 3)
    speed.push_back(std::hypot(velocity[i], velocity[i + 1], velocity[i + 2]));
  return quantile(std::move(speed), 0.999) < scene.stages.back().rest_velocity;
}

}  // namespace scarp::validation
