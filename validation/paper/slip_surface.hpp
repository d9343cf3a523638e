// SPDX-License-Identifier: BSD-3-Clause
/// Where the slip surface of a slide lies below the undeformed slope.
#pragma once

#include <vector>

#include "validation/paper/outcome.hpp"
#include "validation/paper/sections.hpp"

namespace scarp::validation {

/// Vertical thickness of the slide at the middle of the face, mean over three by three columns of
/// particles, 0 where nothing slides [m]: of case 1 as "slide depth at M [m]", "between" (half the
/// way to the rough side) and "at side" (along it); of corners at P, half a height "beside P" (the
/// mean of both sides) and at Q, with the elevation of slip surface and ground beside P over that
/// at P.
void measure_slip_surface(const std::vector<Grain>& grains, const Slope3d& slope, double spacing,
                          Outcome& outcome);

}  // namespace scarp::validation
