// SPDX-License-Identifier: BSD-3-Clause
/// Who falls, past which walls, over what soil.
#include "engine/watch/lost_soil.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <unordered_map>
#include <vector>

#include <fmt/format.h>

#include "engine/boundary/across.hpp"
#include "engine/boundary/facet_geometry.hpp"
#include "engine/parallel.hpp"
#include "engine/state.hpp"
#include "engine/watch/watch.hpp"

namespace scarp {

using namespace geometry;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

using Slots = std::vector<std::int64_t>;

class LostSearch {
 public:
  explicit LostSearch(const State& state)
      : state_(state),
        surface_(state.boundary.surface),
        walls_{state.boundary.stands, state.boundary.offset},
        dimension_(state.scene.dimension),
        reach_(2.0 * state.smoothing_length),
        weight_(std::sqrt(dot(state.scene.gravity, state.scene.gravity))) {
    // Half of what a fall over the reach gives, or of the speed that damping allows.
    const double damping = state.stage.damping;
    for (const ParticleGroup& group : state.particles.groups()) {
      const double g = weight_ / group.mass_scaling;
      double& at = falls_at_.emplace_back(0.5 * std::sqrt(2.0 * g * reach_));
      if (damping > 0.0) at = std::min(at, 0.5 * g / damping);
    }
    for (std::size_t w = 0; w < state.scene.walls.size(); ++w) {
      if (!state.boundary.stands[w]) continue;
      for (std::size_t a = 0; a < 3; ++a) {
        lowest_[a] = std::min(lowest_[a], surface_.extent(w).low[a] + state.boundary.offset[w][a]);
        highest_[a] =
            std::max(highest_[a], surface_.extent(w).high[a] + state.boundary.offset[w][a]);
      }
    }
  }

  Slots found() const {
    const bool falls = weight_ > 0.0;
    const Slots loose =
        falls ? select([this](std::int64_t k, auto& search) { return falls_free(k, search); })
              : select([this](std::int64_t k, auto& search) { return is_outside(k, search); });
    const bool any =
        state_.reduction->maximum_of(static_cast<double>(loose.size())) > 0.0;  // in any part
    return falls && any ? over_nothing(loose) : loose;
  }

 private:
  Vec3 vector(Field field, std::int64_t slot) const {
    Vec3 v{};
    for (int a = 0; a < dimension_; ++a)
      v[static_cast<std::size_t>(a)] = state_.particles.component(field, a)[slot];
    return v;
  }
  double down(const Vec3& v) const { return dot(v, state_.scene.gravity) / weight_; }
  /// What its weight alone accelerates a particle by.
  Vec3 fall(std::int64_t slot) const {
    return state_.particles.group_of(slot).fall(state_.scene.gravity);
  }

  /// Slots for which is(slot, search) holds and that have not been counted, in order.
  template <class Is>
  Slots select(const Is& is) const {
    Slots all, of_group;
    for (const ParticleGroup& group : state_.particles.groups()) {
      parallel_gather(state_.threads, group.count, particle_chunk, of_group,
                      [&](std::int64_t begin, std::int64_t end, Slots& chosen) {
                        FacetSearch search;
                        for (std::int64_t k = group.first + begin; k < group.first + end; ++k) {
                          if (!state_.is_lost(k) && is(k, search)) chosen.push_back(k);
                        }
                      });
      all.insert(all.end(), of_group.begin(), of_group.end());
    }
    return all;
  }

  bool falls_free(std::int64_t slot, FacetSearch& search) const {
    const Vec3 v = vector(Field::velocity, slot);
    const ParticleGroup& group = state_.particles.group_of(slot);
    if (!(down(v) > falls_at_[static_cast<std::size_t>(&group - state_.particles.groups().data())]))
      return false;
    const Vec3 x = vector(Field::position, slot);
    if (!(down(minus(x, vector(Field::reference_position, slot))) > reach_)) return false;
    return !meets_a_wall(x, v, fall(slot), search);
  }

  /// Whether x + v t + g t^2/2 comes through a facet, or past its edge within a spacing, at t > 0.
  bool meets_a_wall(const Vec3& x, const Vec3& v, const Vec3& g, FacetSearch& search) const {
    const auto passes_by = [&](std::size_t wall) {
      return [this, start = minus(x, walls_.offset[wall]), v, g](const AxisBox& box) {
        return passes(start, v, g, box.widened(1.5 * state_.particles.largest_spacing()));
      };
    };
    const auto found = surface_.find(passes_by, search);
    return std::any_of(found.begin(), found.end(), [&](std::uint32_t face) {
      const Facet& facet = surface_.facet(face);
      const std::size_t w = surface_.wall_of(face);
      if (!walls_.stands[w]) return false;
      const Vec3 from_wall = minus(x, walls_.offset[w]);
      // The height over the face is c + b t + a t^2.
      const double a = 0.5 * dot(g, facet.normal), b = dot(v, facet.normal),
                   c = dot(minus(from_wall, facet.origin), facet.normal);
      const std::array<double, 2> times = roots(a, b, c);
      return std::any_of(times.begin(), times.end(), [&](double t) {
        return t > 0.0 && coordinates(facet, dimension_, at_time(t, from_wall, v, g))
                              .above(facet, state_.particles.largest_spacing());
      });
    });
  }
  static Vec3 at_time(double t, const Vec3& x, const Vec3& v, const Vec3& g) {
    return plus(plus(x, t, v), 0.5 * t * t, g);
  }
  /// Whether that way is in the box at some time t > 0, or all but: it begins there or comes in
  /// through a side.
  bool passes(const Vec3& x, const Vec3& v, const Vec3& g, const AxisBox& box) const {
    const AxisBox wider =
        box.widened(0.5 * state_.particles.largest_spacing());  // far above round-off
    const auto is_inside = [&](const Vec3& point) {
      return wider.meets(AxisBox::around(point, point));
    };
    if (is_inside(x)) return true;
    for (std::size_t a = 0; a < static_cast<std::size_t>(dimension_); ++a) {
      for (const double side : {box.low[a], box.high[a]}) {
        for (const double t : roots(0.5 * g[a], v[a], x[a] - side)) {
          if (t > 0.0 && is_inside(at_time(t, x, v, g))) return true;
        }
      }
    }
    return false;
  }

  /// Of c + b t + a t^2; NaN: there is none.
  static std::array<double, 2> roots(double a, double b, double c) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    const double square = b * b - 4.0 * a * c;
    if (square < 0.0) return {none, none};
    const double q = -0.5 * (b + std::copysign(std::sqrt(square), b));  // without cancellation
    return {q != 0.0 ? c / q : none, a != 0.0 ? q / a : none};
  }

  bool is_outside(std::int64_t slot, FacetSearch& search) const {
    const Vec3 x = vector(Field::position, slot);
    bool outside = false;
    for (std::size_t a = 0; a < static_cast<std::size_t>(dimension_); ++a)
      outside |= x[a] < lowest_[a] - reach_ || x[a] > highest_[a] + reach_;
    return outside && is_behind(x, search) &&
           !meets_a_wall(x, vector(Field::velocity, slot), fall(slot), search);
  }

  /// Whether the point lies on the back of every facet that is nearest to it.
  bool is_behind(const Vec3& x, FacetSearch& search) const {
    for (double reach = reach_; std::isfinite(reach); reach *= 2.0) {
      double nearest = infinity;
      bool behind = false;
      for (const std::uint32_t face : surface_.near(x, reach, walls_, search)) {
        const auto& [facet, w] = surface_.faces()[face];
        const FacetCoordinates at = coordinates(facet, dimension_, minus(x, walls_.offset[w]));
        const double distance = at.distance(facet), tie = 1e-9 * distance;
        if (distance > nearest + tie) continue;
        behind = at.depth > 0.0 && (behind || distance < nearest - tie);
        nearest = std::min(nearest, distance);
      }
      if (nearest <= (1.0 - 1e-6) * reach) return behind;
    }
    return false;
  }

  /// Those of `loose` under which no other soil lies, within the reach to the side.
  Slots over_nothing(const Slots& loose) const {
    const Across across(state_.scene, reach_);
    // Of the columns around all loose soil; the parts tell each other which, then how deep.
    std::unordered_map<Across::Column, double, Across::Hash> deepest;
    std::vector<double> asked;
    for (const std::int64_t k : loose) {
      across.around(across.column(vector(Field::position, k)), [&](const Across::Column& column) {
        if (deepest.emplace(column, -infinity).second)
          asked.insert(asked.end(),
                       {static_cast<double>(column[0]), static_cast<double>(column[1])});
      });
    }
    state_.reduction->gather(asked);
    const auto column_at = [](const std::vector<double>& numbers, std::size_t k) {
      return Across::Column{static_cast<std::int64_t>(numbers[k]),
                            static_cast<std::int64_t>(numbers[k + 1])};
    };
    for (std::size_t k = 0; k < asked.size(); k += 2)
      deepest.emplace(column_at(asked, k), -infinity);
    take_deepest(across, loose, deepest);
    std::vector<double> of_all;
    for (const auto& [column, depth] : deepest) {
      of_all.insert(of_all.end(),
                    {static_cast<double>(column[0]), static_cast<double>(column[1]), depth});
    }
    state_.reduction->gather(of_all);
    for (std::size_t k = 0; k < of_all.size(); k += 3) {
      double& depth = deepest.at(column_at(of_all, k));
      depth = std::max(depth, of_all[k + 2]);
    }
    Slots lost;
    std::copy_if(loose.begin(), loose.end(), std::back_inserter(lost), [&](std::int64_t k) {
      const Vec3 x = vector(Field::position, k);
      bool over_soil = false;
      across.around(across.column(x), [&](const Across::Column& column) {
        const auto entry = deepest.find(column);
        over_soil |= entry != deepest.end() && entry->second > across.depth(x);
      });
      return !over_soil;
    });
    return lost;
  }

  /// Lowers columns to the deepest soil in them that is not loose; of a maximum the order of the
  /// threads changes nothing.
  template <class Depths>
  void take_deepest(const Across& across, const Slots& loose, Depths& deepest) const {
    for (const ParticleGroup& group : state_.particles.groups()) {
      parallel_chunks(
          state_.threads, group.count, particle_chunk, [&](std::int64_t begin, std::int64_t end) {
            for (std::int64_t k = group.first + begin; k < group.first + end; ++k) {
              if (state_.is_lost(k) || std::binary_search(loose.begin(), loose.end(), k)) continue;
              const Vec3 x = vector(Field::position, k);
              const auto column = deepest.find(across.column(x));
              if (column == deepest.end()) continue;
              const std::atomic_ref depth(column->second);
              double before = depth.load();
              while (before < across.depth(x) &&
                     !depth.compare_exchange_weak(before, across.depth(x))) {
              }
            }
          });
    }
  }

  const State& state_;
  const WallSurface& surface_;
  WallPlacement walls_;
  int dimension_;
  double reach_, weight_;
  /// By group: speed along gravity from which a particle counts as falling.
  std::vector<double> falls_at_;
  /// Of the walls that stand.
  Vec3 lowest_{infinity, infinity, infinity}, highest_{-infinity, -infinity, -infinity};
};

}  // namespace

void count_lost_soil(State& state) {
  if (state.scene.walls.empty()) return;
  const Slots found = LostSearch(state).found();
  double count = static_cast<double>(found.size()), mass = 0.0;
  for (const std::int64_t slot : found) mass += state.particles.group_of(slot).mass;
  state.reduction->sum_each({&count, &mass});
  if (count == 0.0) return;
  LostSoil& lost = state.lost;
  const auto& ids = state.particles.ids();
  const auto id_of = [&ids](std::int64_t slot) { return ids[static_cast<std::size_t>(slot)]; };
  if (lost.particles == 0) {
    // The least id: slots depend on the order in memory.
    double first = infinity;
    for (const std::int64_t slot : found) first = std::min(first, static_cast<double>(id_of(slot)));
    first = state.reduction->minimum_of(first);
    lost.first = static_cast<std::int64_t>(first);
    lost.step = state.report.step;
    lost.time = state.report.time;
    lost.stage = state.scene.stages[state.stage.index].name;
    std::vector<Vec3> position(1);
    for (const std::int64_t slot : found) {
      if (id_of(slot) != lost.first) continue;
      for (int a = 0; a < state.scene.dimension; ++a)
        position[0][static_cast<std::size_t>(a)] =
            state.particles.component(Field::position, a)[slot];
    }
    state.reduction->sum_each(position);
    lost.position = position[0];
  }
  std::vector<double> found_ids;  // all parts know them: soil goes from one to the other
  for (const std::int64_t slot : found) found_ids.push_back(static_cast<double>(id_of(slot)));
  state.reduction->gather(found_ids);
  for (const double id : found_ids) state.lost_ids.push_back(static_cast<std::int64_t>(id));
  std::sort(state.lost_ids.begin(), state.lost_ids.end());
  lost.mass += mass;
  lost.particles += static_cast<std::uint64_t>(count);
}

std::string LostSoil::message(std::size_t all) const {
  const double share = 100.0 * static_cast<double>(particles) / static_cast<double>(all);
  return fmt::format(
      "soil was lost: {} of {} particles ({:.3g} %) left all walls and soil that could hold them. "
      "The first: "
      "particle {} at ({:.6g}, {:.6g}, {:.6g}) m, found at {:.6g} s, step {} (stage '{}'). Try "
      "walls "
      "that meet, a wider base, or a floor where the soil is meant to fall.",
      particles, all, share, first, position[0], position[1], position[2], time, step, stage);
}

}  // namespace scarp
