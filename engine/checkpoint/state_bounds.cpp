// SPDX-License-Identifier: BSD-3-Clause
/// Bounds on positions and times; the rest is the watch's.
#include "engine/checkpoint/state_bounds.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "engine/checkpoint/finite_numbers.hpp"
#include "engine/errors.hpp"
#include "engine/state.hpp"
#include "engine/watch/watch.hpp"

namespace scarp {

void require_near(const Snapshot& from, const std::string& item, const State& state) {
  constexpr double sizes = 1e4;
  const ParticleBuffers& p = state.particles;
  const auto slots = static_cast<std::size_t>(p.slots());
  const std::vector<double>& stored =
      finite_numbers(from, item, static_cast<std::size_t>(state.scene.dimension) * slots);
  std::array<double, 3> low{}, high{};
  double size = p.largest_spacing();
  const auto each_axis_and_slot = [&](auto&& look) {
    for (int a = 0; a < state.scene.dimension; ++a) {
      for (const ParticleGroup& group : p.groups()) {
        for (std::int64_t k = group.first; k < group.end(); ++k)
          look(static_cast<std::size_t>(a), static_cast<std::size_t>(k));
      }
    }
  };
  low.fill(std::numeric_limits<double>::infinity());
  high.fill(-std::numeric_limits<double>::infinity());
  each_axis_and_slot([&](std::size_t a, std::size_t k) {
    const double x = p.component(Field::position, static_cast<int>(a))[k];
    low[a] = std::min(low[a], x);
    high[a] = std::max(high[a], x);
    size = std::max(size, high[a] - low[a]);
  });
  each_axis_and_slot([&](std::size_t a, std::size_t k) {
    const double x = stored[a * slots + k];
    if (x < low[a] - sizes * size || x > high[a] + sizes * size) {
      throw CheckpointError(
          fmt::format("'{}' has a particle at {:.4g} m, out of reach of the scene.", item, x));
    }
  });
}

void require_sound(const State& state) {
  const std::optional<double> duration = state.scene.stages[state.stage.index].duration;
  if (state.stage.time > state.report.time * (1.0 + 1e-9) ||
      (duration && state.stage.time > *duration * (1.0 + 1e-9)))
    throw CheckpointError("'clock/stage_time' is beyond the end of its stage.");
  if (const std::optional<Instability> found = inspect(state)) {
    throw CheckpointError(fmt::format("its state is none that a run leaves: {}", found->message()));
  }
}

}  // namespace scarp
