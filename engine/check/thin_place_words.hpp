// SPDX-License-Identifier: BSD-3-Clause
/// What is said of a place that is thin.
#pragma once

#include <compare>
#include <limits>
#include <string>

#include "engine/scene/scene.hpp"

namespace scarp {

inline constexpr double spacings_wanted = 2.0;  ///< across a piece

/// What a sentence is about; one for each kind.
struct ThinKind {
  int material, body, below, above;  ///< material -1: air
  auto operator<=>(const ThinKind&) const = default;
};

struct ThinPlace {
  double width = std::numeric_limits<double>::infinity();
  Vec3 place{};
  bool hole = false;
  double tapers = 0.0;  ///< length over which it thins out from two spacings to nothing, or 0 [m]
  int count = 0;
};

/// Where it is, how wide, and the spacing it needs.
std::string words_of(const Scene& scene, const ThinKind& kind, const ThinPlace& found);

}  // namespace scarp
