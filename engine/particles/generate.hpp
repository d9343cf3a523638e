// SPDX-License-Identifier: BSD-3-Clause
/// Fills the bodies of a scene with soil particles on one regular lattice.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "engine/particles/particles.hpp"
#include "engine/scene/scene.hpp"

namespace scarp {

/// Lattice points inside the bodies, body by body; each stands for a volume dx^dimension. The
/// lattice is that of `lattice_of`. A point on a face that two bodies share belongs to one of them,
/// as said at `ColumnShape`; one that lies in several bodies belongs to the first. Errors:
/// SceneError if a body holds no lattice point or the count exceeds what memory can hold. Of each:
/// position, velocity, material.
Particles generate_soil(const Scene& scene, const std::function<bool()>& stop = {});

/// About how many particles each material has, from at most 20000 columns of each body, evenly
/// spread; exact where a scene has no more, and quick however large it is.
std::vector<double> estimate_particles(const Scene& scene);

}  // namespace scarp
