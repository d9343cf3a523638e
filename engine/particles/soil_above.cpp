// SPDX-License-Identifier: BSD-3-Clause
/// The weight above by lattice columns, or by rays through the bodies where gravity is oblique.
#include "engine/particles/soil_above.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <exception>
#include <numeric>
#include <optional>

#include "engine/parallel.hpp"
#include "engine/particles/shapes.hpp"

namespace scarp {
namespace {

double weight_of(const Scene& scene) {
  return std::hypot(scene.gravity[0], scene.gravity[1], scene.gravity[2]);
}

/// Columns of the lattice along the one axis of gravity, from the top down.
class Columns {
 public:
  Columns(const Scene& scene, const Particles& soil, std::size_t axis)
      : scene_(scene), soil_(soil), axis_(axis), up_(scene.gravity[axis] < 0.0 ? 1.0 : -1.0) {}

  void add(std::vector<SoilAbove>& above) {
    const std::size_t count = soil_.position.size();
    std::vector<Key> keys(count);
    for (std::size_t id = 0; id < count; ++id) keys[id] = key_of(soil_.position[id]);
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return keys[a] != keys[b] ? keys[a] < keys[b] : height_of(a) > height_of(b);
    });
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t id = order[k];
      const bool continues = k > 0 && keys[id] == keys[order[k - 1]] &&
                             height_of(order[k - 1]) - height_of(id) < 1.5 * scene_.spacing;
      above[id] = continues ? below(order[k - 1], id) : top(id);
    }
  }

 private:
  using Key = std::array<std::int64_t, 2>;

  Key key_of(const Vec3& position) const {
    Key key{};
    std::size_t k = 0;
    for (std::size_t a = 0; a < static_cast<std::size_t>(scene_.dimension); ++a) {
      if (a == axis_) continue;
      key[k++] = std::llround((position[a] - soil_.position[0][a]) / scene_.spacing);
    }
    return key;
  }
  double height_of(std::size_t id) const { return up_ * soil_.position[id][axis_]; }
  double density_of(std::size_t id) const { return scene_.materials[soil_.material[id]].density; }
  double to_face(double highest, std::size_t id) const {
    return highest - height_of(id) + 0.5 * scene_.spacing;
  }

  SoilAbove top(std::size_t id) {
    surface_ = layer_ = height_of(id);
    load_ = 0.0;
    return here(id);
  }
  /// The next one under `before`. Where the material changes the layer above becomes a load: within
  /// a layer the pressure is one product, not a sum that rounds at every row.
  SoilAbove below(std::size_t before, std::size_t id) {
    if (density_of(before) != density_of(id)) {
      load_ +=
          density_of(before) * weight_of(scene_) * (to_face(layer_, before) + 0.5 * scene_.spacing);
      layer_ = height_of(id);
    }
    return here(id);
  }
  SoilAbove here(std::size_t id) const {
    return {load_ + density_of(id) * weight_of(scene_) * to_face(layer_, id),
            to_face(surface_, id)};
  }

  const Scene& scene_;
  const Particles& soil_;
  std::size_t axis_;
  double up_;
  double surface_ = 0.0, layer_ = 0.0;  ///< heights of the uppermost particles
  double load_ = 0.0;                   ///< of the layers above this one [Pa]
};

/// Rays against gravity through the bodies as they are drawn.
class Rays {
 public:
  Rays(const Scene& scene, const Vec3& direction)
      : scene_(scene), direction_(direction), shapes_(column_shapes(scene)) {
    for (const Body& body : scene.bodies) materials_.push_back(material_of(scene, body));
  }

  SoilAbove from(const Vec3& start, std::size_t material) {
    const double step = 0.5 * scene_.spacing, weight = weight_of(scene_);
    SoilAbove above;
    std::optional<std::size_t> here = material;
    double gap = 0.0;
    for (double at = 0.0; gap < scene_.spacing; at += step) {
      const std::optional<std::size_t> next = material_at(start, at + step);
      const double part = next == here ? step : change(start, at, step, here);
      const auto pass = [&](std::optional<std::size_t> through, double length, double end) {
        if (!through) {
          gap += length;
          return;
        }
        gap = 0.0;
        above.pressure += scene_.materials[*through].density * weight * length;
        above.thickness = end;
      };
      pass(here, part, at + part);
      if (next != here && gap < scene_.spacing) pass(next, step - part, at + step);
      here = next;
    }
    return above;
  }

 private:
  /// How far after `at` the material `here` ends; it does within `step`.
  double change(const Vec3& start, double at, double step, std::optional<std::size_t> here) {
    double low = 0.0, high = step;
    for (int halving = 0; halving < 8; ++halving) {
      const double middle = 0.5 * (low + high);
      (material_at(start, at + middle) == here ? low : high) = middle;
    }
    return 0.5 * (low + high);
  }

  /// Of the first body that holds the point.
  std::optional<std::size_t> material_at(const Vec3& start, double along) {
    const std::size_t up = scene_.dimension == 2 ? 1 : 2;
    Vec3 point;
    for (std::size_t a = 0; a < 3; ++a) point[a] = start[a] + along * direction_[a];
    for (std::size_t b = 0; b < shapes_.size(); ++b) {
      const ColumnShape& shape = shapes_[b];
      bool over = true;
      for (std::size_t a = 0; a < up; ++a) {
        over &= point[a] >= shape.minimum[a] - shape.tolerance &&
                point[a] <= shape.maximum[a] + shape.tolerance;
      }
      if (!over) continue;
      ranges_.clear();
      shape.column(point[0], up == 1 ? 0.0 : point[1], ranges_);
      for (const Range& range : ranges_) {
        if (point[up] >= range.low - shape.tolerance && point[up] <= range.high + shape.tolerance)
          return materials_[b];
      }
    }
    return {};
  }

  const Scene& scene_;
  Vec3 direction_;
  std::vector<ColumnShape> shapes_;
  std::vector<std::size_t> materials_;  ///< of the bodies
  std::vector<Range> ranges_;
};

}  // namespace

Vec3 upward(const Scene& scene) {
  const double weight = weight_of(scene);
  Vec3 up{};
  if (weight > 0.0) {
    for (std::size_t a = 0; a < 3; ++a) up[a] = -scene.gravity[a] / weight;
  }
  return up;
}

std::vector<SoilAbove> soil_above(const Scene& scene, const Particles& soil, int threads) {
  std::vector<SoilAbove> above(soil.position.size());
  std::vector<std::size_t> along;
  for (std::size_t a = 0; a < 3; ++a) {
    if (scene.gravity[a] != 0.0) along.push_back(a);
  }
  if (along.empty() || soil.position.empty()) return above;
  if (along.size() == 1) {
    Columns(scene, soil, along[0]).add(above);
    return above;
  }
  std::vector<std::exception_ptr> failures(above.size() / particle_chunk + 1);
  parallel_chunks(threads, static_cast<std::int64_t>(above.size()), particle_chunk,
                  [&](std::int64_t begin, std::int64_t end) {
                    try {  // each chunk has shapes of its own: their expressions keep state
                      Rays rays(scene, upward(scene));
                      for (auto id = static_cast<std::size_t>(begin);
                           id < static_cast<std::size_t>(end); ++id) {
                        above[id] = rays.from(soil.position[id], soil.material[id]);
                      }
                    } catch (...) {
                      failures[static_cast<std::size_t>(begin / particle_chunk)] =
                          std::current_exception();
                    }
                  });
  for (const std::exception_ptr& failure : failures) {
    if (failure) std::rethrow_exception(failure);
  }
  return above;
}

}  // namespace scarp
