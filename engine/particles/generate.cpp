// SPDX-License-Identifier: BSD-3-Clause
/// Lattice fill of the bodies, column by column.
#include "engine/particles/generate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "engine/errors.hpp"
#include "engine/particles/lattice.hpp"
#include "engine/particles/particle_limit.hpp"
#include "engine/particles/shapes.hpp"
#include "engine/particles/weak_seams.hpp"
#include "engine/scene/expression.hpp"
#include "engine/stop.hpp"

namespace scarp {
namespace {

class LatticeFill {
 public:
  LatticeFill(const Scene& scene, const std::function<bool()>& stop)
      : scene_(scene),
        stop_(stop),
        up_(scene.dimension == 2 ? 1 : 2),
        limit_(most_particles(scene)),
        shapes_(column_shapes(scene)) {
    if (!shapes_.empty()) lattice_ = lattice_of(scene, shapes_[0]);
  }

  std::vector<double> estimate() {
    std::vector<double> particles(scene_.materials.size(), 0.0);
    for (std::size_t b = 0; b < shapes_.size(); ++b)
      particles.at(material_of(scene_, scene_.bodies[b])) += estimate(b);
    return particles;
  }

  Particles fill() {
    double total = 0.0;
    for (std::size_t b = 0; b < shapes_.size(); ++b) {
      // Far too many need not be counted one by one.
      total += estimate(b);
      if (total > 2.0 * limit_) too_many(shapes_[b]);
    }
    total = 0.0;
    for (std::size_t b = 0; b < shapes_.size(); ++b) total += count(b, total);
    Particles soil;
    const auto size = static_cast<std::size_t>(total);
    soil.position.reserve(size);
    soil.material.reserve(size);
    soil.velocity.reserve(size);
    for (std::size_t b = 0; b < shapes_.size(); ++b) add(b, soil);
    widen_weak_seams(scene_, lattice_.origin, soil);
    return soil;
  }

 private:
  Sites plan_sites(const ColumnShape& shape, std::size_t axis) const {
    if (axis == up_) return {0, 0};  // 2D: one row of columns
    return lattice_.inside(shape, axis, shape.minimum[axis], shape.maximum[axis]);
  }

  template <class Visit>
  void for_each_column(const ColumnShape& shape, const Visit& visit) const {
    const Sites xs = plan_sites(shape, 0), ys = plan_sites(shape, 1);
    for (std::int64_t i = xs.first; i <= xs.last; ++i) {
      stop_if_asked(stop_);
      for (std::int64_t j = ys.first; j <= ys.last; ++j) {
        if (!visit(lattice_.at(0, i), up_ == 1 ? 0.0 : lattice_.at(1, j))) return;
      }
    }
  }

  /// Vertical sites of a shape at (x, y), ascending and disjoint.
  void column_sites(const ColumnShape& shape, double x, double y, std::vector<Sites>& out) {
    ranges_.clear();
    out.clear();
    shape.sites(up_, {x, y, 0.0}, ranges_);
    for (const Range& range : ranges_) {
      const Sites sites = lattice_.inside(shape, up_, range.low, range.high);
      if (sites.count() > 0) out.push_back(sites);
    }
    std::sort(out.begin(), out.end(),
              [](const Sites& a, const Sites& b) { return a.first < b.first; });
    std::size_t kept = 0;
    for (std::size_t k = 1; k < out.size(); ++k) {
      if (out[k].first <= out[kept].last + 1) {
        out[kept].last = std::max(out[kept].last, out[k].last);
      } else {
        out[++kept] = out[k];
      }
    }
    if (!out.empty()) out.resize(kept + 1);
  }

  /// About how many particles a body has that no earlier one owns.
  double estimate(std::size_t body) {
    constexpr double most_columns = 20000.0;
    const ColumnShape& shape = shapes_[body];
    const Sites xs = plan_sites(shape, 0), ys = plan_sites(shape, 1);
    const auto across = static_cast<double>(ys.count());
    const double columns = static_cast<double>(xs.count()) * across;
    const double stride = std::max(1.0, columns / most_columns);
    double total = 0.0;
    for (double c = 0.5 * stride; c < columns; c += stride) {
      const double i = std::floor(c / across), j = std::floor(c - i * across);
      own_sites(body, lattice_.at(0, xs.first + static_cast<std::int64_t>(i)),
                up_ == 1 ? 0.0 : lattice_.at(1, ys.first + static_cast<std::int64_t>(j)));
      for (const Sites& sites : sites_) total += stride * static_cast<double>(sites.count());
    }
    return total;
  }

  /// Leaves in `sites_` the sites of a body's column that no earlier body owns.
  void own_sites(std::size_t body, double x, double y) {
    column_sites(shapes_[body], x, y, sites_);
    for (std::size_t earlier = 0; earlier < body; ++earlier) {
      if (covers(shapes_[earlier], x, y)) take_away(earlier, x, y);
    }
  }

  /// Particles of a body, overlaps with others included: all that can be known without storing any.
  double count(std::size_t body, double before) {
    const ColumnShape& shape = shapes_[body];
    const double columns = static_cast<double>(plan_sites(shape, 0).count()) *
                           static_cast<double>(plan_sites(shape, 1).count());
    if (columns > limit_) too_many(shape);
    double total = 0.0;
    for_each_column(shape, [&](double x, double y) {
      column_sites(shape, x, y, sites_);
      for (const Sites& sites : sites_) total += static_cast<double>(sites.count());
      return before + total <= limit_;
    });
    if (before + total > limit_) too_many(shape);
    if (total > 0.0) return total;
    throw SceneError(fmt::format(
        "{}: holds no particle at spacing {} m. Try a larger body or a smaller spacing.",
        shape.label, scene_.spacing));
  }

  [[noreturn]] void too_many(const ColumnShape& shape) const {
    throw SceneError(fmt::format(
        "{}: with it the scene has more than {:.3g} particles at spacing {} m, the most "
        "for the {:.3g} GB of memory that this process may use (control group and ulimit counted). "
        "Try a larger spacing.",
        shape.label, limit_, scene_.spacing, 1e-9 * usable_memory()));
  }

  void add(std::size_t body, Particles& soil) {
    const ColumnShape& shape = shapes_[body];
    const std::size_t before = soil.position.size();
    const Body& made_of = scene_.bodies[body];
    const std::size_t material = material_of(scene_, made_of);
    std::vector<Expression> velocity;
    for (const std::string& text : made_of.velocity_field) velocity.emplace_back(text, "xyz");
    for_each_column(shape, [&](double x, double y) {
      own_sites(body, x, y);
      for (const Sites& sites : sites_) {
        for (std::int64_t k = sites.first; k <= sites.last; ++k) {
          Vec3 position{x, y, 0.0};
          position[up_] = lattice_.at(up_, k);
          soil.position.push_back(position);
          soil.material.push_back(material);
          soil.velocity.push_back(made_of.velocity);
          for (std::size_t a = 0; a < velocity.size(); ++a) {
            soil.velocity.back()[a] = finite_velocity(velocity[a], position, shape.label);
          }
        }
      }
      return true;
    });
    if (soil.position.size() > before) return;
    throw SceneError(
        fmt::format("{}: lies wholly inside bodies before it, to which a shared particle belongs. "
                    "Try to list it before them, or to leave it out.",
                    shape.label));
  }

  static double finite_velocity(const Expression& velocity, const Vec3& position,
                                const std::string& label) {
    const double value = velocity(position);
    if (std::isfinite(value)) return value;
    throw SceneError(fmt::format(
        "{}: its velocity_field is not finite at x = {}, y = {}, z = {}. Try one that is finite in "
        "the whole body.",
        label, position[0], position[1], position[2]));
  }

  bool covers(const ColumnShape& shape, double x, double y) const {
    const auto inside = [&](std::size_t a, double value) {
      return within(value, shape.minimum[a] + shape.begin[a], shape.maximum[a] + shape.tolerance);
    };
    return inside(0, x) && (up_ == 1 || inside(1, y));
  }

  /// Removes the sites of an earlier body from `sites_`.
  void take_away(std::size_t earlier, double x, double y) {
    column_sites(shapes_[earlier], x, y, taken_);
    for (const Sites& taken : taken_) {
      rest_.clear();
      for (const Sites& sites : sites_) {
        const Sites below{sites.first, std::min(sites.last, taken.first - 1)};
        const Sites above{std::max(sites.first, taken.last + 1), sites.last};
        if (below.count() > 0) rest_.push_back(below);
        if (above.count() > 0) rest_.push_back(above);
      }
      sites_.swap(rest_);
    }
  }

  const Scene& scene_;
  const std::function<bool()>& stop_;
  std::size_t up_;
  double limit_;
  std::vector<ColumnShape> shapes_;
  Lattice lattice_;
  std::vector<Range> ranges_;
  std::vector<Sites> sites_, taken_, rest_;
};

}  // namespace

std::vector<double> estimate_particles(const Scene& scene) {
  return LatticeFill(scene, {}).estimate();
}

Particles generate_soil(const Scene& scene, const std::function<bool()>& stop) {
  return LatticeFill(scene, stop).fill();
}

}  // namespace scarp
