// SPDX-License-Identifier: BSD-3-Clause
/// Where the soil has sheared, held against a circle.
#pragma once

#include <vector>

#include "engine/simulation.hpp"
#include "validation/bishop.hpp"

namespace scarp::validation {

/// One ray from the circle's centre.
struct BandSection {
  double angle = 0.0;       ///< from the downward vertical, positive towards +x [rad]
  double x = 0.0, y = 0.0;  ///< of the band in the undeformed slope [m]
  double offset = 0.0;      ///< of the band from the circle, positive outwards [m]
  double strain = 0.0;      ///< greatest accumulated plastic strain on the ray [-]
};

/// Sections through the middle `share` of the arc on which a band is found: the plastic strain,
/// averaged over bins of one spacing, peaks at twice its mean on the ray or more. The band lies at
/// the strain's centre of gravity within the peak's half height. Positions are those before the
/// displacement, because Bishop's circle belongs to the undeformed slope.
std::vector<BandSection> slip_band(const Simulation& simulation, const BishopResult& bishop,
                                   int rays, double share);

}  // namespace scarp::validation
