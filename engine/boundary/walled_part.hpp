// SPDX-License-Identifier: BSD-3-Clause
/// The part of a facet that the soil can see between other walls.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/boundary/facet_index.hpp"
#include "engine/scene/scene.hpp"

namespace scarp {

/// From and to, along each tangent of a facet [m].
using WalledPart = std::array<std::array<double, 2>, 2>;

/// A facet may go on behind others that stand on it or cross it: between two that face each other
/// there, which stay where they are to it, lies the part whose columns of dummies must fit. The
/// whole facet if nothing stands on it, or if what stands there leaves less than `least`. `walls`
/// has the wall of each facet.
WalledPart walled_part(std::size_t facet, std::span<const Facet> facets,
                       std::span<const Wall* const> walls, const FacetIndex& index, int dimension,
                       double least);

}  // namespace scarp
