// SPDX-License-Identifier: BSD-3-Clause
/// The part of a facet that the soil can see between other walls.
#pragma once

#include <array>
#include <cstdint>

#include "engine/boundary/wall_surface.hpp"
#include "engine/scene/scene.hpp"

namespace scarp {

/// From and to, along each tangent of a facet [m].
using WalledPart = std::array<std::array<double, 2>, 2>;

/// A facet may go on behind others that stand on it or cross it: between two that face each other
/// there, which stay where they are to it, lies the part whose columns of dummies must fit. The
/// whole facet if nothing stands on it, or if what stands there leaves less than `least`.
WalledPart walled_part(std::uint32_t face, const WallSurface& surface, const Scene& scene,
                       double least);

}  // namespace scarp
