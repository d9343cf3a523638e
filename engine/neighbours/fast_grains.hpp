// SPDX-License-Identifier: BSD-3-Clause
/// Few particles that are much faster than all others.
#pragma once

#include <cstdint>
#include <vector>

namespace scarp {

struct State;

/// Lists serve until a particle has used up its margin. One grain that flies at many times the
/// speed of the soil would have them built for everybody at every step; so the lists reach further
/// around such grains, and only around them. None where all soil is about as fast, where many
/// particles are, and in soil that is divided among processes.
struct FastGrains {
  std::vector<std::int64_t> slots;  ///< ascending, since the lists were built
  double more = 0.0;  ///< how much further they may move than the rest, half a skin [m]

  /// Whether one of these slots is fast.
  bool among(std::int64_t slot, std::int64_t count) const;
};

/// The fastest, as few as bring the most, by their speed and the last time step. Called before
/// lists are built.
FastGrains fast_grains(const State& state);

/// Whether one of the fast, or one of the others, has used up its margin since the lists were
/// built, which happens before the farthest of all has moved as far as half a skin.
bool margins_used_up(const State& state);

}  // namespace scarp
