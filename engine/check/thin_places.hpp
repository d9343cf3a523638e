// SPDX-License-Identifier: BSD-3-Clause
/// Geometry that the lattice cannot show.
#pragma once

#include <string>
#include <vector>

#include "engine/scene/scene.hpp"

namespace scarp {

/// A sentence for each kind of place where a gap in the soil (slit, crack, hole, space between two
/// bodies) or a piece of it (seam, layer, fin, lens) is narrower than two spacings: the narrowest
/// of its kind, where it is, how wide, and the spacing it needs. It has to be so for 1.5 spacings
/// along itself, or be closed all around. Faces that meet at more than 10 degrees make a natural
/// taper, such as the toe of a slope, and are not named; nor is what is shorter than that, such as
/// the neck of a notch. Lines along every axis are cut half a spacing apart and between all
/// corners; tops of height fields are known along the vertical only. Cost: bounded, whatever the
/// scene; very large scenes are looked at along fewer lines.
std::vector<std::string> thin_places(const Scene& scene);

}  // namespace scarp
