// SPDX-License-Identifier: BSD-3-Clause
/// Soil as particles, one entry each: what bodies are filled with, or what a program brings along.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/scene/scene.hpp"

namespace scarp {

/// Each stands for a volume spacing^dimension. What may be empty takes the value that is named. SI.
struct Particles {
  std::vector<Vec3> position{};         ///< [m]
  std::vector<Vec3> velocity{};         ///< [m/s]; empty: at rest
  std::vector<std::size_t> material{};  ///< index into Scene::materials; empty: the first
  std::vector<std::int64_t> id{};       ///< permanent, 0 or more, each once; empty: 0, 1, 2, ...
  /// xx, yy, zz, xy, yz, zx, tension positive [Pa]; empty: what the scene's initial stress says.
  std::vector<std::array<double, 6>> stress{};
  std::vector<double> density{};  ///< [kg/m3]; empty: the reference density of the material
};

/// The same with everything in place but stress and density. Errors: SceneError if there are no
/// particles, if arrays differ in length, if a value is not finite, a material is not the scene's,
/// an id is negative or comes twice, or if particles without stress are to have that of the weight
/// above, for which a scene needs bodies.
Particles completed(const Scene& scene, Particles particles);

}  // namespace scarp
