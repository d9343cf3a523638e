// SPDX-License-Identifier: BSD-3-Clause
/// Mirror images of the soil behind free-slip walls.
#pragma once

#include <cstdint>
#include <iterator>
#include <span>
#include <vector>

#include "engine/boundary/wall_surface.hpp"
#include "engine/cells/cell_grid.hpp"
#include "engine/neighbours/fast_grains.hpp"
#include "engine/particles/aligned_vector.hpp"
#include "engine/scene/scene.hpp"
#include "engine/sweep/records.hpp"

namespace scarp {

/// Images are chosen when the lists are built and follow their sources every step: position and
/// normal velocity (relative to the wall) reflected, stress R sigma R with R = I - 2 n n^T and the
/// weight of the soil between: 2 d rho g.n T at the distance d, T = n n^T + K0 (I - n n^T). Exact
/// planes of symmetry where gravity lies in the plane. Equation: B3. Limits: faces are flat; faces
/// that meet must do so at right angles (images of images fill the corner).
class MirrorImages {
 public:
  /// Soil that has images: slots of `ranges`, each with its `k0`, behind record `first_record`.
  struct Soil {
    PointSpan points;
    std::span<const SlotRange> ranges;
    std::span<const double> k0;
    std::int64_t first_record = 0;

    Vec3 point(std::int64_t slot) const {
      return {points.x[slot], points.y[slot], points.z != nullptr ? points.z[slot] : 0.0};
    }
  };
  /// The walls, and how far in front of them soil has images.
  struct Mirrored {
    const Scene& scene;
    const WallSurface& surface;
    const WallPlacement& walls;
    double reach;
  };
  /// Soil within `reach` in front of a standing free-slip facet and inside its footprint, then the
  /// images of images across the facets that follow. Own soil, whose records come first, is kept in
  /// mind if it is within `close` of such a facet. Both lengths are longer for `fast` grains.
  void select(int threads, const Mirrored& mirrored, const Soil& own, const Soil& ghosts,
              double close, const FastGrains& fast);

  /// The places of the images after their soil has moved; walls stand where they stood.
  void follow(const PointSpan& soil);

  std::int64_t count() const { return std::ssize(images_); }
  PointSpan points() const {
    return {position_[0].data(), position_[1].data(), position_[2].data()};
  }
  /// Those of fast grains, ascending.
  std::vector<std::int64_t> fast(int threads) const;
  std::size_t wall_of(std::int64_t image) const {
    return images_[static_cast<std::size_t>(image)].wall;
  }

  /// The soil slot that an image, or the one it is an image of, stands for.
  std::int64_t soil_of(std::int64_t image) const;

  /// Whether any of these slots was within `close` of a free-slip face at the last selection.
  bool is_close(std::int64_t slot, std::int64_t count) const;

  /// Images by how many mirrors made them; all of them, or those listed.
  struct Generations {
    bool all = true;
    std::vector<RawVector<std::int32_t>> listed;
  };
  const Generations& all() const { return all_images_; }
  /// Those of soil in marked blocks of so many slots each.
  Generations of_soil(int threads, std::span<const std::uint8_t> marked_blocks,
                      std::int64_t slots) const;

  /// Where the mirrors stand now, and what weighs on the images.
  struct Mirrors {
    double inverse_smoothing_length;
    const std::vector<Vec3>& wall_offset;
    const std::vector<Vec3>& wall_velocity;
    const Vec3& gravity;
  };
  /// Records of the images `which` from those of their sources. Pre: it holds the images that its
  /// images are images of.
  void pack(int threads, Records& records, const Mirrors& mirrors, const Generations& which) const;
  /// ... that hold T = sigma B: (R sigma R + weight)(R B R). Equation: B3, K3.
  void pack_corrected(int threads, Records& records, const Mirrors& mirrors,
                      const ParticleBuffers& soil, const ParticleBuffers& ghosts,
                      const Generations& which) const;
  /// Second lines of the images from those of their sources.
  void pack_second(int threads, Records& records, kernels::TermSet terms, int dimension) const;
  /// Notes that each image is of the material of its soil.
  void copy_material(int threads, Records& records) const;
  /// The density of the record of each source into that of its image.
  void copy_density(int threads, Records& records, const Generations& which) const;
  std::size_t bytes() const { return images_.size() * (sizeof(Image) + 3 * sizeof(double)); }

 private:
  struct Image {
    std::int64_t source;  ///< record of soil, or -1 - image
    std::uint32_t wall;
    std::uint32_t last;  ///< the highest number of the faces that it is an image in
    Vec3 normal;
    Vec3 origin;     ///< a point of the facet before its wall moved
    double lateral;  ///< K0 of the soil it is an image of
    double more;     ///< how much wider it reaches than others [m]
  };
  /// What may have images.
  struct Source {
    std::int64_t record;  ///< of soil, or -1 - image
    Vec3 place;
    Vec3 soil;  ///< where the soil is that it is an image of, or its own place
    double lateral, more;
  };
  static bool follows(const Image& image, const Vec3& place, std::uint32_t face, const Facet& facet,
                      const WallPlacement& walls);
  template <class SourceOf>
  void add_images(int threads, const Mirrored& mirrored, double close, std::int64_t sources,
                  const SourceOf& source_of);
  template <class Pack>
  void each_after_its_source(int threads, const Generations& which, const Pack& pack) const;
  std::int64_t source_record(const Records& records, std::size_t image) const;
  double pack_motion(Records& records, const Mirrors& mirrors, std::size_t image) const;

  RawVector<Image> images_;
  Generations all_images_;
  std::vector<std::int64_t> generations_;  ///< where images of soil end, images of those, and so on
  RawVector<double> position_[3];
  std::vector<std::uint8_t> close_;  ///< by soil slot; empty: none
};

}  // namespace scarp
