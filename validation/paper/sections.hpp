// SPDX-License-Identifier: BSD-3-Clause
/// Particles of a slope in the paper's coordinates, and the sections they are looked at in.
#pragma once

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "engine/simulation.hpp"
#include "validation/paper/slopes.hpp"

namespace scarp::validation {

/// A particle in the coordinates of Fig. 4: x and y in plan, z up; in the plane y is 0.
struct Grain {
  Vec3 start{}, now{};  ///< settled and present place [m]
  double moved = 0.0;   ///< displacement since the strength was cut [m]
  double strain = 0.0;
  double density = 0.0;
  double xx = 0.0, yy = 0.0, zz = 0.0, xy = 0.0;  ///< stress, tension positive [Pa]
};

/// In order of their id, from the state as it is.
std::vector<Grain> grains_of(const Simulation& simulation);

/// A vertical cut through the undeformed slope, one layer of particles thick.
struct Section {
  std::string name;
  bool diagonal = false;
  double y = 0.0;    ///< of a cut along x; its layer is the one above
  bool all = false;  ///< plane strain: everything

  bool holds(const Grain& grain, double spacing) const {
    if (all) return true;
    if (diagonal) return std::fabs(grain.start[0] - grain.start[1]) < 0.5 * spacing;
    return std::fabs(grain.start[1] - (y + 0.5 * spacing)) < 0.5 * spacing;
  }
  double along(const Vec3& place) const {
    return diagonal ? (place[0] + place[1]) / std::numbers::sqrt2 : place[0];
  }
  /// Horizontal normal stress in the section, and across it.
  double stress_along(const Grain& g) const { return diagonal ? 0.5 * (g.xx + g.yy) + g.xy : g.xx; }
  double stress_across(const Grain& g) const {
    return diagonal ? 0.5 * (g.xx + g.yy) - g.xy : g.yy;
  }
};

/// M of case 1, P and Q of the corners, the whole of a plane slope ("section").
std::vector<Section> sections_of(const Slope3d& slope);

/// What counts as having slid. The failure criterion asks for 1 % of the height; here the soil that
/// has moved with the slide is separated from what has only given way a little.
inline constexpr double slide_share = 0.04;  ///< displacement over the height of the slope
bool slides(const Grain& grain, const Slope3d& slope);

/// Above the toe, from half the run of the face behind the crest to the toe.
bool at_risk(const Grain& grain, const Slope3d& slope);

}  // namespace scarp::validation
