// SPDX-License-Identifier: BSD-3-Clause
/// Columns of soil along gravity, and the faces that lie under them.
#include "engine/check/wall_support.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include <fmt/format.h>

#include "engine/boundary/across.hpp"
#include "engine/boundary/facet_geometry.hpp"
#include "engine/particles/shapes.hpp"

namespace scarp {

using namespace geometry;

namespace {

constexpr std::size_t most_places = 4;  ///< told at one moment

/// Which walls stand where at some time of a run.
struct Moment {
  std::vector<bool> stands;
  std::vector<Vec3> offset;
  std::string words;  ///< ", once wall 'gate' is removed (stage 'open')"
};

bool moves_in(const Scene& scene, const Wall& wall, std::size_t stage) {
  if (wall.velocity == Vec3{}) return false;
  const auto named = [&wall](const Stage& s) { return s.name == wall.moves_from; };
  const auto last = scene.stages.begin() + static_cast<std::ptrdiff_t>(stage) + 1;
  return wall.moves_from.empty() || std::any_of(scene.stages.begin(), last, named);
}

/// A common motion of all walls carries the soil along.
void take_common_motion_away(Moment& moment) {
  Vec3 common{};
  bool first = true;
  for (std::size_t w = 0; w < moment.offset.size(); ++w) {
    if (!moment.stands[w]) continue;
    if (!first && moment.offset[w] != common) return;
    common = moment.offset[w];
    first = false;
  }
  std::fill(moment.offset.begin(), moment.offset.end(), Vec3{});
}

/// The start, every removal, and the end of every stage with walls that move.
std::vector<Moment> moments(const Scene& scene) {
  const std::size_t walls = scene.walls.size();
  Moment now{std::vector<bool>(walls, true), std::vector<Vec3>(walls), {}};
  std::vector<Moment> all;
  for (std::size_t s = 0; s < scene.stages.size(); ++s) {
    const Stage& stage = scene.stages[s];
    std::string gone, moved;
    for (std::size_t w = 0; w < walls; ++w) {
      const Wall& wall = scene.walls[w];
      if (wall.removed_at == stage.name && now.stands[w]) {
        now.stands[w] = false;
        gone += fmt::format("{}'{}'", gone.empty() ? "" : ", ", wall.name);
      }
    }
    now.words =
        gone.empty() ? "" : fmt::format(" once wall {} is removed (stage '{}'),", gone, stage.name);
    if (s == 0 || !gone.empty()) all.push_back(now);
    for (std::size_t w = 0; w < walls; ++w) {
      const Wall& wall = scene.walls[w];
      if (!now.stands[w] || !moves_in(scene, wall, s)) continue;
      now.offset[w] = plus(now.offset[w], stage.duration.value_or(0.0), wall.velocity);
      moved += fmt::format("{}'{}'", moved.empty() ? "" : ", ", wall.name);
    }
    if (moved.empty()) continue;
    now.words = fmt::format(" once wall {} has moved (end of stage '{}'),", moved, stage.name);
    all.push_back(now);
  }
  for (Moment& moment : all) take_common_motion_away(moment);
  return all;
}

class Support {
 public:
  Support(const Scene& scene, const std::vector<Vec3>& soil)
      : scene_(scene),
        soil_(soil),
        across_(scene, scene.spacing),
        tolerance_(1e-6 * scene.spacing),
        told_(soil.size()) {
    for (std::size_t id = 0; id < soil.size(); ++id)
      columns_[across_.column(soil[id])].push_back(id);
  }

  /// What has nothing below it now and has not been told.
  void look(const Moment& moment, std::vector<std::string>& found) {
    Faces faces;
    for (std::size_t w = 0; w < scene_.walls.size(); ++w) {
      if (!moment.stands[w]) continue;
      for (Facet facet : scene_.walls[w].facets) {
        if (dot(facet.normal, across_.down()) > -1e-6) continue;
        facet.origin = plus(facet.origin, 1.0, moment.offset[w]);
        spread(facet, faces);
      }
    }
    std::unordered_map<Across::Column, std::vector<std::size_t>, Across::Hash> bare;
    std::size_t count = 0;
    for (const auto& [column, ids] : columns_) {
      const auto below = faces.find(column);
      for (const std::size_t id : ids) {
        if (told_[id] || (below != faces.end() && carried(soil_[id], below->second))) continue;
        told_[id] = true;
        ++count;
        bare[column].push_back(id);
      }
    }
    if (count == soil_.size()) {
      found.push_back(
          fmt::format("gravity:{} no wall lies below any of the soil: what does not hang on one "
                      "falls out of the "
                      "scene. Try a wall below; a line has its soil on the left, a plane where its "
                      "normal points.",
                      moment.words));
      return;
    }
    tell(moment, bare, found);
  }

 private:
  using Faces = std::unordered_map<Across::Column, std::vector<Facet>, Across::Hash>;
  using Ids = std::vector<std::size_t>;
  using Bare = std::unordered_map<Across::Column, Ids, Across::Hash>;

  /// Into every column with soil that the facet may lie under.
  void spread(const Facet& facet, Faces& faces) const {
    Across::Column low{}, high{};
    bool first = true;
    double cells = 1.0;
    for (const Vec3& corner : corners(facet, scene_.dimension)) {
      const Across::Column at = across_.column(corner);
      for (std::size_t a = 0; a < 2; ++a) {
        low[a] = first ? at[a] : std::min(low[a], at[a]);
        high[a] = first ? at[a] : std::max(high[a], at[a]);
      }
      first = false;
    }
    // A corner on the border of two columns may count to either.
    for (std::size_t a = 0; a < 2; ++a) {
      --low[a];
      ++high[a];
      cells *= static_cast<double>(high[a] - low[a] + 1);
    }
    if (cells > static_cast<double>(columns_.size())) {
      for (const auto& [column, ids] : columns_) {
        const bool under = column[0] >= low[0] && column[0] <= high[0] && column[1] >= low[1] &&
                           column[1] <= high[1];
        if (under) faces[column].push_back(facet);
      }
      return;
    }
    for (std::int64_t i = low[0]; i <= high[0]; ++i) {
      for (std::int64_t j = low[1]; j <= high[1]; ++j) {
        if (columns_.count({i, j}) != 0) faces[{i, j}].push_back(facet);
      }
    }
  }

  bool carried(const Vec3& point, const std::vector<Facet>& faces) const {
    return std::any_of(faces.begin(), faces.end(), [&](const Facet& facet) {
      const double way =
          dot(minus(facet.origin, point), facet.normal) / dot(across_.down(), facet.normal);
      return way > -tolerance_ &&
             coordinates(facet, scene_.dimension, plus(point, way, across_.down()))
                 .above(facet, tolerance_);
    });
  }

  /// Columns that touch are one place.
  Ids take_place(Bare& bare, Across::Column start) const {
    Ids place;
    std::vector<Across::Column> open{start};
    while (!open.empty()) {
      const Across::Column column = open.back();
      open.pop_back();
      const auto entry = bare.find(column);
      if (entry == bare.end()) continue;
      place.insert(place.end(), entry->second.begin(), entry->second.end());
      bare.erase(entry);
      across_.around(column, [&open](const Across::Column& next) { open.push_back(next); });
    }
    std::sort(place.begin(), place.end());
    return place;
  }

  void tell(const Moment& moment, Bare& bare, std::vector<std::string>& found) const {
    std::vector<Ids> places;
    while (!bare.empty()) places.push_back(take_place(bare, bare.begin()->first));
    std::sort(places.begin(), places.end(), [](const Ids& a, const Ids& b) {
      return a.size() != b.size() ? a.size() > b.size() : a < b;
    });
    for (std::size_t k = 0; k < std::min(places.size(), most_places); ++k)
      found.push_back(sentence(moment, places[k]));
    if (places.size() > most_places)
      found.push_back(fmt::format("gravity:{} there are {} more such places.", moment.words,
                                  places.size() - most_places));
  }

  std::string sentence(const Moment& moment, const Ids& place) const {
    const auto at = [&](std::size_t id) { return across_.place(soil_[id]); };
    const auto [first, last] = std::minmax_element(place.begin(), place.end(),
                                                   [&](auto a, auto b) { return at(a) < at(b); });
    std::array<double, 2> low = at(*first), high = low;
    for (const std::size_t id : place) {
      for (std::size_t a = 0; a < 2; ++a) {
        low[a] = std::min(low[a], at(id)[a]);
        high[a] = std::max(high[a], at(id)[a]);
      }
    }
    const auto width = [&](std::size_t a) { return high[a] - low[a] + scene_.spacing; };
    return fmt::format(
        "gravity:{} no wall lies below {} of {} particles ({:.3g} %), {:.3g} m {}wide from {} to "
        "{}: "
        "what comes loose there falls out of the scene. Try a wall below, or walls that meet.",
        moment.words, place.size(), soil_.size(),
        100.0 * static_cast<double>(place.size()) / static_cast<double>(soil_.size()), width(0),
        scene_.dimension == 3 ? fmt::format("by {:.3g} m ", width(1)) : "",
        point_text(soil_[*first], scene_.dimension), point_text(soil_[*last], scene_.dimension));
  }

  const Scene& scene_;
  const std::vector<Vec3>& soil_;
  Across across_;
  double tolerance_;
  std::unordered_map<Across::Column, Ids, Across::Hash> columns_;
  std::vector<bool> told_;
};

}  // namespace

std::vector<std::string> soil_over_nothing(const Scene& scene, const std::vector<Vec3>& soil) {
  std::vector<std::string> found;
  if (scene.gravity == Vec3{}) return found;
  Support support(scene, soil);
  for (const Moment& moment : moments(scene)) support.look(moment, found);
  return found;
}

}  // namespace scarp
