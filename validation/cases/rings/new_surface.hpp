// SPDX-License-Identifier: BSD-3-Clause
/// Cracks as the surface they make.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/simulation.hpp"

namespace scarp::validation {

/// Counts particles inside a body that have come to lie at a surface. Plane scenes of two equal
/// bodies, each taken for itself, so that touching is no healing.
class NewSurface {
 public:
  /// Notes what lies at a surface now.
  explicit NewSurface(const Simulation& start);

  /// Particles at a surface now that were inside at the start.
  std::size_t count(const Simulation& now) const;

 private:
  std::vector<bool> at_start_;
};

}  // namespace scarp::validation
