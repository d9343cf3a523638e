// SPDX-License-Identifier: BSD-3-Clause
/// All walls of a scene as one surface, to be asked what is near a point or on a way.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "engine/boundary/facet_geometry.hpp"
#include "engine/boundary/facet_index.hpp"
#include "engine/scene/scene.hpp"

namespace scarp {

/// Which walls stand at one moment, and how far each has moved; by wall.
struct WallPlacement {
  const std::vector<bool>& stands;
  const std::vector<Vec3>& offset;  ///< [m]
};

/// Faces are numbered through in the order of the walls and of the facets in each; every question
/// is answered in that order. Walls that move alike share an index, so that a question costs what
/// it finds and the logarithm of the number of faces, whatever that is, for every way of moving.
/// Answers leave out no face that is asked for and hold some that are not.
class WallSurface {
 public:
  WallSurface() = default;
  explicit WallSurface(const Scene& scene);

  const std::vector<WallFace>& faces() const { return faces_; }
  const Facet& facet(std::uint32_t face) const { return faces_[face].facet; }
  std::size_t wall_of(std::uint32_t face) const { return faces_[face].wall; }
  /// Around a wall before it moved.
  const AxisBox& extent(std::size_t wall) const { return extents_[wall]; }

  /// Faces within `reach` of a point; the first question. Answers are valid until the next one.
  /// Without a placement all walls stand where the scene draws them.
  std::span<const std::uint32_t> near(const Vec3& point, double reach, FacetSearch& search) const;
  std::span<const std::uint32_t> near(const Vec3& point, double reach, const WallPlacement& walls,
                                      FacetSearch& search) const;
  /// Faces within `reach` of a facet.
  std::span<const std::uint32_t> near(const Facet& facet, double reach, FacetSearch& search) const;
  /// The nearest point within `reach` of any face but `skipped`, where the scene draws it.
  struct Nearest {
    double distance = std::numeric_limits<double>::infinity();  ///< infinite: there is none [m]
    Vec3 point{};
    std::uint32_t face = 0;
  };
  Nearest nearest(const Vec3& point, double reach, std::uint32_t skipped,
                  FacetSearch& search) const;

  /// Faces within `reach` of the straight way from `before`, where the walls stood at
  /// `offset_before`, to `now`; the second question.
  std::span<const std::uint32_t> on_way(const Vec3& before, const std::vector<Vec3>& offset_before,
                                        const Vec3& now, const WallPlacement& walls, double reach,
                                        FacetSearch& search) const;

  /// Every standing face, in order, where they are so few that to look at each of them costs less
  /// than a question; else none. Many questions in a row may take it for the answer to each.
  std::vector<std::uint32_t> all_if_few(const std::vector<bool>& stands) const;

  /// Faces of whose box, before their wall moved, meets_of(wall)(box) holds; `wall` stands for all
  /// that move like it. Pre: as for FacetIndex::find.
  template <class MeetsOf>
  std::span<const std::uint32_t> find(const MeetsOf& meets_of, FacetSearch& search) const;

 private:
  /// Walls that move alike, and their faces.
  struct Group {
    std::size_t wall = 0;
    std::vector<std::uint32_t> faces;
    FacetIndex index;
  };
  void keep_standing(const std::vector<bool>& stands, FacetSearch& search) const;

  int dimension_ = 2;
  std::vector<WallFace> faces_;
  std::vector<AxisBox> extents_;
  std::vector<Group> groups_;
};

template <class MeetsOf>
std::span<const std::uint32_t> WallSurface::find(const MeetsOf& meets_of,
                                                 FacetSearch& search) const {
  search.found.clear();
  for (const Group& group : groups_) {
    const std::size_t first = search.found.size();
    group.index.find(meets_of(group.wall), search);
    for (std::size_t k = first; k < search.found.size(); ++k)
      search.found[k] = group.faces[search.found[k]];
  }
  std::sort(search.found.begin(), search.found.end());
  return search.found;
}

}  // namespace scarp
