// SPDX-License-Identifier: BSD-3-Clause
/// Layers of dummy particles behind the facets, closed at concave corners, cut at convex ones.
#include "engine/boundary/dummies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "engine/boundary/facet_geometry.hpp"
#include "engine/boundary/near_test.hpp"
#include "engine/errors.hpp"
#include "engine/particles/particle_limit.hpp"

namespace scarp {

using namespace geometry;

namespace {

/// Grid of sites behind one facet; columns 0 .. columns - 1 lie above it, `layers` more on each
/// side serve the corners.
struct Face {
  Facet facet;
  std::size_t wall = 0;
  bool no_slip = true;
  bool lasting = true;  ///< neither moves nor goes
  std::array<std::int64_t, 2> columns{1, 1};
  std::array<std::int64_t, 2> margin{0, 0};
  std::vector<bool> kept;
};

struct Site {
  std::int64_t u = 0, v = 0, layer = 0;
};

class DummyLayout {
 public:
  explicit DummyLayout(const Scene& scene)
      : dimension_(scene.dimension),
        spacing_(scene.spacing),
        tolerance_(1e-6 * scene.spacing),
        closest_(0.25 * scene.spacing - tolerance_),
        layers_(wall_layers(scene)),
        thickness_(static_cast<double>(layers_) * spacing_),
        placed_(0.5 * spacing_ * (1.0 - 1e-6)) {
    double sites = 0.0;
    for (std::size_t w = 0; w < scene.walls.size(); ++w) {
      for (const Facet& facet : scene.walls[w].facets) add_face(scene, w, facet, sites);
    }
    std::stable_partition(faces_.begin(), faces_.end(), [](const Face& f) { return f.lasting; });
    for (Face& face : faces_) face.kept.resize(grid_size(face));
  }

  WallDummies lay() {
    for (Face& face : faces_) {
      for_each_site(face, [&](const Site& site) {
        if (is_above(face, site)) offer(face, site, goes_through(face, site));
      });
    }
    for (Face& face : faces_) {
      for_each_site(face, [&](const Site& site) {
        if (!is_above(face, site)) offer(face, site, !closes_corner(face, site));
      });
    }
    mark_edges();
    return std::move(out_);
  }

 private:
  void add_face(const Scene& scene, std::size_t wall, const Facet& facet, double& sites) {
    Face face;
    face.facet = facet;
    face.wall = wall;
    face.no_slip = scene.walls[wall].kind == WallKind::no_slip;
    face.lasting = scene.walls[wall].velocity == Vec3{} && scene.walls[wall].removed_at.empty();
    const double lengths[2] = {facet.length_u, facet.length_v};
    double count = static_cast<double>(layers_);
    for (std::size_t a = 0; a + 1 < static_cast<std::size_t>(dimension_); ++a) {
      const double columns = std::ceil(lengths[a] / spacing_ - 1e-6);
      if (lengths[a] < spacing_ - tolerance_) {
        throw SceneError(fmt::format(
            "{}'{}': a facet is {} m long, less than the spacing {} m. Try a smaller spacing or a "
            "longer facet.",
            message_start(scene, scene.walls[wall]), scene.walls[wall].name, lengths[a], spacing_));
      }
      count *= columns + 2.0 * static_cast<double>(layers_);
      face.columns[a] = static_cast<std::int64_t>(std::min(columns, 1e15));
      face.margin[a] = layers_;
    }
    sites += count;
    if (sites > most_particles()) {
      throw SceneError(fmt::format(
          "{}'{}': with it the walls have more than {:.3g} dummy particles at spacing {} m, the "
          "most "
          "for this machine's {:.3g} GB of memory. Try a larger spacing or a smaller wall.",
          message_start(scene, scene.walls[wall]), scene.walls[wall].name, most_particles(),
          spacing_, 1e-9 * physical_memory()));
    }
    faces_.push_back(std::move(face));
  }

  static bool is_above(const Face& face, const Site& site) {
    return site.u >= 0 && site.u < face.columns[0] && site.v >= 0 && site.v < face.columns[1];
  }
  /// Above its facet and within reach of one of its edges.
  bool is_on_rim(const Face& face, const Site& site) const {
    const auto near_end = [&](std::int64_t column, std::int64_t columns) {
      return column < layers_ || column >= columns - layers_;
    };
    return is_above(face, site) && (near_end(site.u, face.columns[0]) ||
                                    (dimension_ == 3 && near_end(site.v, face.columns[1])));
  }
  static std::int64_t extent(const Face& face, std::size_t axis) {
    return face.columns[axis] + 2 * face.margin[axis];
  }
  std::size_t grid_size(const Face& face) const {
    return static_cast<std::size_t>(extent(face, 0) * extent(face, 1) * layers_);
  }
  std::size_t index(const Face& face, const Site& site) const {
    const std::int64_t u = site.u + face.margin[0], v = site.v + face.margin[1];
    return static_cast<std::size_t>((u * extent(face, 1) + v) * layers_ + site.layer);
  }

  template <class Visit>
  void for_each_site(const Face& face, const Visit& visit) const {
    for (std::int64_t layer = 0; layer < layers_; ++layer) {
      for (std::int64_t u = -face.margin[0]; u < face.columns[0] + face.margin[0]; ++u) {
        for (std::int64_t v = -face.margin[1]; v < face.columns[1] + face.margin[1]; ++v) {
          visit({u, v, layer});
        }
      }
    }
  }

  /// Columns are centred on the facet, so that a rest of its length is shared by both ends.
  double along(double length, std::int64_t columns, std::int64_t column) const {
    return 0.5 * length +
           (static_cast<double>(column) - 0.5 * static_cast<double>(columns - 1)) * spacing_;
  }
  Vec3 position(const Face& face, const Site& site, double depth) const {
    const Facet& f = face.facet;
    Vec3 p = plus(f.origin, along(f.length_u, face.columns[0], site.u), f.tangent_u);
    if (dimension_ == 3) p = plus(p, along(f.length_v, face.columns[1], site.v), f.tangent_v);
    return plus(p, -depth, f.normal);
  }
  double depth(const Site& site) const {
    return (static_cast<double>(site.layer) + 0.5) * spacing_;
  }

  /// A site above its own facet is no wall if the way to it from the face leaves the wall again:
  /// the wall is thinner than its layers, or tapers to an edge. Nor if it
  /// all but lies on another face, whose own first layer keeps half a spacing away.
  bool goes_through(const Face& face, const Site& site) const {
    const Vec3 foot = position(face, site, 0.0), point = position(face, site, depth(site));
    for (const Face& other : faces_) {
      if (&other == &face) continue;
      if (comes_out(other.facet, dimension_, foot, point, tolerance_)) return true;
      // Behind a face turned by less than 60 degrees the layers are never that close.
      if (dot(face.facet.normal, other.facet.normal) > 0.5) continue;
      const FacetCoordinates at = coordinates(other.facet, dimension_, point);
      const bool close = at.depth > -tolerance_ && at.depth < closest_;
      if (close && at.above(other.facet, tolerance_)) return true;
    }
    return false;
  }

  /// A site beyond the edges of its facet is wanted where, over each of these edges, another facet
  /// near it faces back (a concave corner), and unless it stands on the soil side of a facet or
  /// close to it. Free edges stay as they are: a footing is not made wider.
  bool closes_corner(const Face& face, const Site& site) const {
    const Vec3 point = position(face, site, depth(site));
    const Vec3 tangents[2] = {face.facet.tangent_u, face.facet.tangent_v};
    const std::int64_t columns[2] = {site.u, site.v};
    bool over[2] = {}, closed[2] = {};
    Vec3 outward[2];
    for (std::size_t a = 0; a < 2; ++a) {
      over[a] = columns[a] < 0 || columns[a] >= face.columns[a];
      outward[a] = plus({}, columns[a] < 0 ? -1.0 : 1.0, tangents[a]);
    }
    const double reach = std::sqrt(static_cast<double>(dimension_)) * thickness_;
    for (const Face& other : faces_) {
      if (&other == &face) continue;
      const FacetCoordinates at = coordinates(other.facet, dimension_, point);
      if (at.depth < closest_ && at.depth >= -thickness_ && at.above(other.facet, tolerance_)) {
        return false;
      }
      const bool below_its_layers = at.depth > thickness_ && at.above(other.facet, tolerance_);
      if (below_its_layers || at.distance(other.facet) > reach) continue;
      for (std::size_t a = 0; a < 2; ++a) {
        closed[a] = closed[a] || dot(other.facet.normal, outward[a]) < -1e-6;
      }
    }
    return (closed[0] || !over[0]) && (closed[1] || !over[1]);
  }

  /// Whether a point lies in the cell of a site that was kept; seams belong to both cells.
  bool in_kept_cell(const Face& face, const Vec3& point) const {
    const FacetCoordinates at = coordinates(face.facet, dimension_, point);
    if (at.depth < -tolerance_ || at.depth > thickness_ + tolerance_) return false;
    if (!at.above(face.facet, thickness_ + spacing_)) return false;
    const auto nearest = [&](double value, double nudge) {
      return static_cast<std::int64_t>(std::floor((value + nudge * tolerance_) / spacing_));
    };
    const double u = at.u - along(face.facet.length_u, face.columns[0], 0) + 0.5 * spacing_;
    const double v = at.v - along(face.facet.length_v, face.columns[1], 0) + 0.5 * spacing_;
    for (unsigned seam = 0; seam < 8; ++seam) {
      const auto nudge = [&](unsigned bit) { return (seam & bit) != 0U ? 1.0 : -1.0; };
      const Site site{nearest(u, nudge(1U)), dimension_ == 3 ? nearest(v, nudge(2U)) : 0,
                      nearest(at.depth, nudge(4U))};
      const bool outside = site.layer < 0 || site.layer >= layers_ || site.u < -face.margin[0] ||
                           site.u >= face.columns[0] + face.margin[0] || site.v < -face.margin[1] ||
                           site.v >= face.columns[1] + face.margin[1];
      if (!outside && face.kept[index(face, site)]) return true;
    }
    return false;
  }

  void offer(Face& face, const Site& site, bool unwanted) {
    if (unwanted) return;
    const Vec3 point = position(face, site, depth(site));
    for (const Face& other : faces_) {
      if (&other != &face && in_kept_cell(other, point)) return;
    }
    if (placed_.has_near(point, out_.position)) return;
    face.kept[index(face, site)] = true;
    placed_.put(point, out_.position.size());
    const Face& owner = owner_of(face, site, point);
    out_.position.push_back(point);
    out_.normal.push_back(owner.facet.normal);
    out_.distance.push_back(coordinates(owner.facet, dimension_, point).depth);
    out_.wall.push_back(owner.wall);
    rim_.push_back(is_on_rim(face, site) ? &face.facet : nullptr);
  }

  /// Among the facets the point is behind: no-slip before free-slip, then the nearest plane. So
  /// that a removed gate leaves no hole in the base it stood on, a site above a facet asks only
  /// facets it is above, and walls that move or go take none from walls that stay.
  const Face& owner_of(const Face& face, const Site& site, const Vec3& point) const {
    const double margin = (is_above(face, site) ? 0.0 : thickness_) + tolerance_;
    const Face* owner = &face;
    double nearest = depth(site);
    for (const Face& other : faces_) {
      const FacetCoordinates at = coordinates(other.facet, dimension_, point);
      const bool behind = at.depth > tolerance_ && at.depth <= thickness_ + tolerance_ &&
                          at.above(other.facet, margin);
      if (!behind || (face.lasting && !other.lasting)) continue;
      if (owner->no_slip && !other.no_slip) continue;
      const bool stronger = other.no_slip && !owner->no_slip;
      if (!stronger && at.depth >= nearest - tolerance_) continue;
      owner = &other;
      nearest = at.depth;
    }
    return *owner;
  }

  /// A wall ends where the next place along its face holds no dummy of any wall. As many places as
  /// there are layers are within reach of the soil there. Dummies beyond an edge close a corner.
  void mark_edges() {
    NearTest placed(0.75 * spacing_);  // joints of facets shift the columns by up to half a spacing
    for (std::size_t k = 0; k < out_.position.size(); ++k) placed.put(out_.position[k], k);
    const auto ends = [&](std::size_t k, const Vec3& tangent) {
      for (std::int64_t step = -layers_; step <= layers_; ++step) {
        const double shift = static_cast<double>(step) * spacing_;
        if (!placed.has_near(plus(out_.position[k], shift, tangent), out_.position)) return true;
      }
      return false;
    };
    for (std::size_t k = 0; k < rim_.size(); ++k) {
      const Facet* facet = rim_[k];
      out_.near_edge.push_back(
          facet != nullptr &&
          (ends(k, facet->tangent_u) || (dimension_ == 3 && ends(k, facet->tangent_v))));
    }
  }

  int dimension_;
  double spacing_;
  double tolerance_;
  double closest_;  ///< to another face that a site may be behind
  std::int64_t layers_;
  double thickness_;
  NearTest placed_;
  std::vector<Face> faces_;
  WallDummies out_;
  std::vector<const Facet*> rim_;  ///< facet whose rim each of out_ is above, if any
};

}  // namespace

int wall_layers(const Scene& scene) {
  // The layer after the last lies (layers + 1/2) dx behind the face, which must be 2h or more.
  return std::max(1,
                  static_cast<int>(std::ceil(2.0 * scene.numerics.smoothing_ratio - 0.5 - 1e-9)));
}

WallDummies generate_dummies(const Scene& scene) { return DummyLayout(scene).lay(); }

}  // namespace scarp
