// SPDX-License-Identifier: BSD-3-Clause
/// Where a face of a wall holds grains (B4), in spacings from it.
#pragma once

namespace scarp::held_zone {

/// Nearer to the face than this a grain loses its velocity towards it. Soil that is packed keeps
/// half a spacing from a face: only a grain that its own pair forces do not hold gets here.
inline constexpr double before_face = 0.25;

/// Deeper behind the face than this nothing holds it any more: it counts as lost, and soil there
/// stands before another face.
inline constexpr double behind_face = 0.5;

}  // namespace scarp::held_zone
