// SPDX-License-Identifier: BSD-3-Clause
/// Closes gaps between walls that no grain passes.
#pragma once

#include "engine/scene/scene.hpp"

namespace scarp {

/// Lengthens every facet that ends less than a spacing short of another one, as far as it takes to
/// meet it or to stand abreast of its end, where the walls are at the start or where one slides
/// past others that stand. A grain is a spacing wide and cannot pass such a gap, but dummies,
/// images and faces would end at it. A facet that touches another, or only comes near one along a
/// part of its edge, stays as it is.
void close_narrow_gaps(Scene& scene);

}  // namespace scarp
