// SPDX-License-Identifier: BSD-3-Clause
/// Walls so thin that soil acts through them.
#pragma once

#include <string>
#include <vector>

#include "engine/scene/scene.hpp"

namespace scarp {

/// A sentence for each two faces that stand back to back (within 25 degrees) with soil before both,
/// nearer to each other than their layers need: 2h behind rough faces, whose dummies would take the
/// stress of the soil on the other side, 4h where one is smooth, since its images would stand
/// before the other. The narrowest place of each pair is named; `soil` is taken where it lies now.
/// (THEORY.md, section 4.) Limits: walls are looked at where the scene draws them.
std::vector<std::string> thin_walls(const Scene& scene, const std::vector<Vec3>& soil);

/// A sentence for each two faces, one of them smooth, that lie in one plane and overlap: the soil
/// there has one of them, the rough one if one is.
std::vector<std::string> doubled_walls(const Scene& scene);

}  // namespace scarp
