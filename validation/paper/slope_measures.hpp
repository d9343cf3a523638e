// SPDX-License-Identifier: BSD-3-Clause
/// What the paper's statements about its 3D slopes are measured by.
#pragma once

#include "engine/simulation.hpp"
#include "validation/paper/outcome.hpp"
#include "validation/paper/sections.hpp"
#include "validation/paper/slopes.hpp"

namespace scarp::validation {

inline constexpr double plastic_strain = 0.1;  ///< accumulated: soil counts as sheared [-]
inline constexpr double failure_share = 0.01;  ///< of the height: a probe has failed

/// Stress on the sections of the settled slope, as "section M: across, settled [Pa]" (compression
/// positive): means over the soil above the toe from half the run of the face behind the crest to
/// the toe. `across` is normal to the section, `along` horizontal in it. "side: downhill" is the
/// same soil in the third of a case 1 slope that lies along its rough side; "beside P: turn of the
/// greater pressure" the angle from the diagonal of a corner to the greater horizontal pressure
/// beside it.
void measure_settled(const Simulation& settled, const Slope3d& slope, Outcome& outcome);

/// When each probe has failed, "M1: failed after [s]"; call after each step of the slide.
void watch_probes(const Simulation& now, const Slope3d& slope, Outcome& outcome);

/// At the end of the slide: displacements of the probes, slide body, plastic zone and stress of the
/// sections, depth of the slide along the face, what is lost.
void measure_slide(const Simulation& fallen, const Slope3d& slope, Outcome& outcome);

}  // namespace scarp::validation
