// SPDX-License-Identifier: BSD-3-Clause
/// Which grains went through a wall, told from those that went round it.
#pragma once

#include <span>
#include <vector>

#include "engine/simulation.hpp"

namespace scarp::validation {

/// Follows every grain from place to place. A grain has passed a wall when it came to its back
/// through a face, within its outline, and got deeper from there than any face holds
/// (`held_zone::behind_face` spacings), wherever it went then. A grain that flies over the edge and
/// falls behind the wall has not, and one that comes back through the face before it is so deep
/// neither. Nothing of the engine's own watch over the faces is asked. Pre: walls do not move.
class WallPassages {
 public:
  WallPassages(const Scene& scene, std::span<const double> position);

  /// The grains are here now (x, y, z of each), in the stage with this index. The way from the
  /// place before counts as straight.
  void follow(std::span<const double> position, std::size_t stage);
  double passed() const;

 private:
  struct Face {
    Facet facet;
    std::size_t removed_at;  ///< index of the stage from which the wall is gone
  };
  int dimension_;
  double depth_;
  std::vector<Face> faces_;
  std::vector<double> last_;
  std::vector<bool> behind_;  ///< by face and grain: came in through it
  std::vector<bool> passed_;  ///< by grain
};

/// Feeds the places of a run to it: all that a grain can have gone a quarter of a spacing for.
class PassageWatch {
 public:
  explicit PassageWatch(const Simulation& start);
  void after_step(const Simulation& simulation);
  /// Those up to the present place.
  double passed(const Simulation& simulation);

 private:
  WallPassages passages_;
  double reach_, way_ = 0.0;  ///< [m]
};

}  // namespace scarp::validation
