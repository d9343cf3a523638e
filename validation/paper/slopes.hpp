// SPDX-License-Identifier: BSD-3-Clause
/// The five 3D slopes of the paper's Fig. 4 and their plane counterparts.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "engine/scene/scene.hpp"

namespace scarp::validation {

enum class SlopeShape {
  concave,         ///< case 1
  straight,        ///< case 1
  convex,          ///< case 1
  concave_corner,  ///< case 2
  convex_corner,   ///< case 2
  plane_45,        ///< plane counterpart of sections M and Q
  plane_35         ///< plane counterpart of section P: the corner's face along the diagonal
};

/// What the text of the paper leaves open; the reasons are in the README of `slope_curvature`.
struct SlopeSize {
  double height = 12.0;      ///< of the slope [m]
  double foundation = 4.0;   ///< soil below the toe [m]
  double crest = 12.0;       ///< from the back wall to the crest's edge [m]
  double toe = 16.0;         ///< from the toe to the front wall [m]
  double half_width = 12.0;  ///< of case 1, from section M to the rough side [m]
};

/// Where points of a slope lie on it. Plan coordinates as in Fig. 4, x from the back wall.
class Slope3d {
 public:
  Slope3d(SlopeShape shape, const SlopeSize& size);

  SlopeShape shape() const { return shape_; }
  bool plane() const { return shape_ >= SlopeShape::plane_45; }
  bool corner() const {
    return shape_ == SlopeShape::concave_corner || shape_ == SlopeShape::convex_corner;
  }
  const SlopeSize& size() const { return size_; }
  double length() const { return length_; }  ///< along x [m]
  double width() const;                      ///< along y [m]; 0 in the plane
  double face_run() const { return run_; }   ///< horizontal length of the face [m]

  /// Distance down the slope: `crest` at its edge, `crest + face_run` at the toe [m].
  double distance(double x, double y) const;
  double surface(double distance) const;  ///< elevation of the undeformed surface [m]
  double top() const { return size_.foundation + size_.height; }
  double lateral_section() const;  ///< y of section Q [m]

  /// The given slope with this shape in place of its body, walls and probes. Probes: M1 and M2; for
  /// corners P1, P2, Q1, Q2; in the plane "crest" and "toe".
  Scene scene(Scene base) const;

 private:
  SlopeShape shape_;
  SlopeSize size_;
  double run_, length_;
};

/// "concave corner".
std::string words(SlopeShape shape);

}  // namespace scarp::validation
