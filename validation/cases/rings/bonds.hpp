// SPDX-License-Identifier: BSD-3-Clause
/// What holds together: pairs that were next neighbours at the start.
#pragma once

#include <array>
#include <vector>

#include "engine/simulation.hpp"

namespace scarp::validation {

/// Bonds between the particles of a body that lay one spacing apart at the start. In an elastic
/// body a bond is as long as its strain makes it, 1 + strain; one that has parted was torn.
class Bonds {
 public:
  /// A bond is broken at this length over the spacing: 60 % of strain, several times what bending
  /// of the rings asks for, and on the way out of each other's support.
  static constexpr double broken_length = 1.6;

  /// Those of the state as it is; each body is taken for itself. Pre: the undisturbed lattice.
  explicit Bonds(const Simulation& start);

  double longest(const Simulation& now) const;       ///< over the spacing
  double broken_share(const Simulation& now) const;  ///< of all bonds
  /// Pieces that unbroken bonds hold together.
  int pieces(const Simulation& now) const;

 private:
  /// Lengths over the spacing, in the order of `pairs_`.
  std::vector<double> lengths(const Simulation& now) const;

  double spacing_;
  std::size_t particles_;
  std::vector<std::array<std::size_t, 2>> pairs_;
};

}  // namespace scarp::validation
