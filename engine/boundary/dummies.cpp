// SPDX-License-Identifier: BSD-3-Clause
/// Layers of dummy particles behind the facets, closed at concave corners, cut at convex ones.
#include "engine/boundary/dummies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "engine/boundary/face_grid.hpp"
#include "engine/boundary/facet_geometry.hpp"
#include "engine/boundary/near_test.hpp"
#include "engine/boundary/wall_columns.hpp"
#include "engine/boundary/wall_edges.hpp"
#include "engine/boundary/wall_surface.hpp"
#include "engine/errors.hpp"
#include "engine/particles/particle_limit.hpp"
#include "engine/scene/smoothing_choice.hpp"
#include "engine/stop.hpp"

namespace scarp {

using namespace geometry;

namespace {

/// A facet; behind a no-slip one a grid of sites.
struct Face {
  Facet facet;
  std::uint32_t number = 0;  ///< in the surface
  std::size_t wall = 0;
  bool no_slip = true;
  bool lasting = true;  ///< neither moves nor goes
  FaceGrid grid;
  std::vector<std::size_t> column;  ///< in WallDummies::columns, by column of the grid
};

class DummyLayout {
 public:
  explicit DummyLayout(const Scene& scene)
      : scene_(scene),
        dimension_(scene.dimension),
        spacing_(scene.spacing),
        reach_(corner_reach(scene)),
        tolerance_(reach_.tolerance),
        closest_(0.25 * scene.spacing - tolerance_),
        layers_(wall_layers(scene)),
        thickness_(reach_.thickness),
        farthest_(std::sqrt(static_cast<double>(dimension_)) * (thickness_ + spacing_)),
        placed_(0.5 * spacing_ * (1.0 - 1e-6)),
        most_(most_particles(scene)),
        surface_(scene) {
    double sites = 0.0;
    for (std::uint32_t k = 0; k < surface_.faces().size(); ++k) add_face(k, sites);
    std::stable_partition(faces_.begin(), faces_.end(), [](const Face& f) { return f.lasting; });
    rank_.resize(faces_.size());
    for (std::size_t k = 0; k < faces_.size(); ++k) rank_[faces_[k].number] = k;
    for (Face& face : faces_) {
      if (!face.no_slip) continue;
      const WalledPart part = walled_part(face.number, surface_, scene, spacing_);
      face.grid = FaceGrid(face.facet, part, dimension_, spacing_, layers_);
      if (has_wall_columns(scene)) face.column.assign(face.grid.columns(), no_column);
    }
  }

  WallDummies lay(const std::function<bool()>& stop) {
    for (const bool above : {true, false}) {
      for (Face& face : faces_) {
        face.grid.for_each_site([&](const Site& site) {
          stop_if_asked(stop);
          if (face.grid.is_above(site) == above) offer(face, site);
        });
      }
    }
    out_.near_edge = near_edges(scene_, surface_, out_.position, edges_);
    add_inner_points(out_, inner_height(scene_));
    return std::move(out_);
  }

 private:
  void add_face(std::uint32_t number, double& sites) {
    const Scene& scene = scene_;
    const auto& [facet, wall] = surface_.faces()[number];
    Face face;
    face.facet = facet;
    face.number = number;
    face.wall = wall;
    face.no_slip = scene.walls[wall].kind == WallKind::no_slip;
    face.lasting = scene.walls[wall].velocity == Vec3{} && scene.walls[wall].removed_at.empty();
    for (const double length : {facet.length_u, facet.length_v}) {
      if (length < spacing_ - tolerance_ && (length > 0.0 || dimension_ == 3)) {
        throw SceneError(fmt::format(
            "{}'{}': a facet is {} m long, less than the spacing {} m. Try a smaller spacing or a "
            "longer facet.",
            message_start(scene, scene.walls[wall]), scene.walls[wall].name, length, spacing_));
      }
    }
    if (face.no_slip) sites += FaceGrid::sites(facet, dimension_, spacing_, layers_);
    if (sites > most_) {
      throw SceneError(fmt::format(
          "{}'{}': with it the walls have more than {:.3g} dummy particles at spacing {} m, the "
          "most for the {:.3g} GB of memory that this process may use (control group and ulimit "
          "counted). Try a larger spacing or a smaller wall.",
          message_start(scene, scene.walls[wall]), scene.walls[wall].name, most_, spacing_,
          1e-9 * usable_memory()));
    }
    faces_.push_back(std::move(face));
  }

  /// A site above its own facet is no wall if the way to it from the face leaves the wall again:
  /// the wall is thinner than its layers, or tapers to an edge. Nor if it
  /// all but lies on another face, whose own first layer keeps half a spacing away.
  bool goes_through(const Face& face, const Site& site) const {
    const Vec3 foot = face.grid.position(site, 0.0),
               point = face.grid.position(site, face.grid.depth(site));
    if (leaves_wall(foot, point)) return true;
    for (const Face* near : near_) {
      const Face& other = *near;
      // Behind a face turned by less than 60 degrees the layers are never that close.
      if (!other.no_slip || dot(face.facet.normal, other.facet.normal) > 0.5) continue;
      const FacetCoordinates at = coordinates(other.facet, dimension_, point);
      const bool close = at.depth > -tolerance_ && at.depth < closest_;
      if (close && at.above(other.facet, tolerance_)) return true;
    }
    return false;
  }

  bool leaves_wall(const Vec3& foot, const Vec3& point) const {
    return std::any_of(near_.begin(), near_.end(), [&](const Face* face) {
      return comes_out(face->facet, dimension_, foot, point, tolerance_);
    });
  }

  /// A site beyond the edges of its facet is wanted where, over each of these edges, another facet
  /// near it faces back (a concave corner), and unless it stands on the soil side of a no-slip
  /// facet or close to it, and not behind one that closes the corner. Free edges stay as they are:
  /// a footing is not made wider. Returns whether it is wanted; `open` keeps the edges that only a
  /// free-slip face closes that need not be there.
  bool closes_corner(const Face& face, const Site& site, SmoothCorner& open) const {
    const Vec3 point = face.grid.position(site, face.grid.depth(site));
    open.over = face.grid.outward(site);
    const Wall& own = scene_.walls[face.wall];
    bool before_one = false, inside_one = false;
    for (const Face* near : near_) {
      const Face& other = *near;
      const FacetCoordinates at = coordinates(other.facet, dimension_, point);
      const bool above = at.above(other.facet, tolerance_);
      before_one =
          before_one || (other.no_slip && above && at.depth < closest_ && at.depth >= -thickness_);
      if (!reach_.is_near(other.facet, point)) continue;
      const bool may_leave = !other.no_slip && !stay_together(own, scene_.walls[other.wall]);
      for (Vec3& outward : open.over) {
        if (!CornerReach::faces_back(other.facet, outward)) continue;
        inside_one = inside_one || (above && at.depth > closest_ &&
                                    !leaves_wall(plus(point, at.depth, other.facet.normal), point));
        if (!may_leave) outward = Vec3{};
      }
    }
    if (before_one && !inside_one) return false;
    return std::all_of(open.over.begin(), open.over.end(), [&](const Vec3& outward) {
      return outward == Vec3{} || may_be_closed(own, point, outward);
    });
  }
  /// By a free-slip face that goes, or that moves against the site's own.
  bool may_be_closed(const Wall& own, const Vec3& point, const Vec3& outward) const {
    const auto in_the_way = [&](std::size_t wall) {
      return [box = way_between(scene_, reach_, point, own, scene_.walls[wall])](
                 const AxisBox& faces) { return faces.meets(box); };
    };
    const auto found = surface_.find(in_the_way, search_);
    return std::any_of(found.begin(), found.end(), [&](std::uint32_t k) {
      const Wall& wall = scene_.walls[surface_.wall_of(k)];
      return wall.kind == WallKind::free_slip && !stay_together(own, wall) &&
             CornerReach::faces_back(surface_.facet(k), outward);
    });
  }

  /// Other faces near a point, in the order of `faces_`.
  void look_around(const Face& face, const Vec3& point) {
    near_.clear();
    for (const std::uint32_t k : surface_.near(point, farthest_, search_)) {
      if (k != face.number) near_.push_back(&faces_[rank_[k]]);
    }
    std::sort(near_.begin(), near_.end());
  }

  void offer(Face& face, const Site& site) {
    const Vec3 point = face.grid.position(site, face.grid.depth(site));
    look_around(face, point);
    SmoothCorner corner;
    const bool above = face.grid.is_above(site);
    if (above ? goes_through(face, site) : !closes_corner(face, site, corner)) return;
    for (const Face* other : near_) {
      if (other->grid.holds(point, tolerance_)) return;
    }
    // Sites of one face keep a spacing from each other.
    if (!near_.empty()) {
      if (placed_.has_near(point, out_.position)) return;
      placed_.put(point, out_.position.size());
    }
    face.grid.keep(site);
    const Face& owner = owner_of(face, site, point);
    corner.dummy = out_.position.size();
    if (corner.over != SmoothCorner{}.over) out_.beside_smooth.push_back(corner);
    out_.position.push_back(point);
    out_.normal.push_back(owner.facet.normal);
    out_.distance.push_back(coordinates(owner.facet, dimension_, point).depth);
    out_.wall.push_back(owner.wall);
    out_.column.push_back(&owner == &face ? column_of(face, site, corner.dummy) : no_column);
    const bool on_rim = above && face.grid.is_near_end(site, layers_);
    edges_.rim.push_back(on_rim ? &face.facet : nullptr);
    if (!above || face.grid.is_near_end(site, 2 * layers_)) edges_.near.push_back(corner.dummy);
  }

  /// Layers are offered from the face on.
  std::size_t column_of(Face& face, const Site& site, std::size_t dummy) {
    if (face.column.empty()) return no_column;
    std::size_t& column = face.column[face.grid.column(site)];
    if (site.layer == 0 && sees_inner_point(face, site)) {
      column = out_.columns.size();
      out_.columns.push_back({dummy, 0});
    }
    return column;
  }
  bool sees_inner_point(const Face& face, const Site& site) const {
    const Vec3 foot = face.grid.position(site, 0.0),
               inner = face.grid.position(site, -inner_height(scene_));
    return std::none_of(near_.begin(), near_.end(), [&](const Face* other) {
      return comes_out(other->facet, dimension_, foot, inner, tolerance_) ||
             comes_out(other->facet, dimension_, inner, foot, tolerance_);
    });
  }

  /// Among the no-slip facets the point is behind, the nearest plane. So that a removed gate leaves
  /// no hole in the base it stood on, a site above a facet asks only facets it is above, and walls
  /// that move or go take none from walls that stay.
  const Face& owner_of(const Face& face, const Site& site, const Vec3& point) const {
    const double margin = (face.grid.is_above(site) ? 0.0 : thickness_) + tolerance_;
    const Face* owner = &face;
    double nearest = face.grid.depth(site);
    for (const Face* near : near_) {
      const Face& other = *near;
      if (!other.no_slip || (face.lasting && !other.lasting)) continue;
      const FacetCoordinates at = coordinates(other.facet, dimension_, point);
      const bool behind = at.depth > tolerance_ && at.depth <= thickness_ + tolerance_ &&
                          at.above(other.facet, margin);
      if (!behind || at.depth >= nearest - tolerance_) continue;
      owner = &other;
      nearest = at.depth;
    }
    return *owner;
  }

  const Scene& scene_;
  int dimension_;
  double spacing_;
  CornerReach reach_;
  double tolerance_;
  double closest_;  ///< to another face that a site may be behind
  std::int64_t layers_;
  double thickness_;
  double farthest_;  ///< that a face is asked about: beyond its corner and beyond its layers
  NearTest placed_;
  double most_;  ///< sites that fit into memory
  WallSurface surface_;
  std::vector<Face> faces_;        ///< those of walls that neither move nor go come first
  std::vector<std::size_t> rank_;  ///< in `faces_`, by number in the surface
  mutable FacetSearch search_;     ///< scratch
  std::vector<const Face*> near_;  ///< the other faces near the site in question
  WallDummies out_;
  EdgeDummies edges_;
};

}  // namespace

int wall_layers(const Scene& scene) {
  // The layer after the last lies (layers + 1/2) dx behind the face, which must be 2h or more.
  return std::max(1, static_cast<int>(std::ceil(2.0 * smoothing_ratio_of(scene) - 0.5 - 1e-9)));
}

WallDummies generate_dummies(const Scene& scene, const std::function<bool()>& stop) {
  WallDummies dummies = DummyLayout(scene).lay(stop);
  dummies.corner_reach = corner_reach(scene);
  return dummies;
}

}  // namespace scarp
