// SPDX-License-Identifier: BSD-3-Clause
/// Runs of thin pieces over neighbouring lines.
#include "engine/check/thin_places.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "engine/check/line_cuts.hpp"

namespace scarp {
namespace {

constexpr double wanted = 2.0;        ///< spacings across
constexpr double long_enough = 1.5;   ///< spacings along itself
constexpr double taper = 0.176;       ///< tangent of 10 degrees
constexpr double most_lines = 20000;  ///< in one direction of cutting

/// A thin piece on one line.
struct Sample {
  double place = 0.0;  ///< of the line, across the direction of cutting
  double middle = 0.0;
  double length = 0.0;
  double width = 0.0;  ///< at right angles to the piece
};

/// A thin piece followed over neighbouring lines.
struct Run {
  std::vector<Sample> samples;
  int material = -1;
  int body = -1, below = -1, above = -1;  ///< bodies: its own and those on both sides
  bool closed_before = false;
};

/// What a message is about; one for each kind.
struct Kind {
  int material, body, below, above;
  auto operator<=>(const Kind&) const = default;
};

struct Found {
  double width = std::numeric_limits<double>::infinity();
  Vec3 place{};
  bool hole = false;
  double tapers = 0.0;  ///< length over which it thins out from two spacings to nothing, or 0 [m]
  int count = 0;
};

int material_at(const std::vector<LinePiece>& line, double place) {
  const auto piece = std::partition_point(
      line.begin(), line.end(), [place](const LinePiece& one) { return one.high < place; });
  return piece != line.end() && piece->low <= place ? piece->material : -1;
}

/// Widths at right angles, from how the middles move; pieces steeper than that across their line
/// belong to lines along another axis.
void set_widths(std::vector<Sample>& samples) {
  constexpr double steepest = 1.05;
  std::vector<double> slope(samples.size(), 0.0);
  for (std::size_t k = 0; k < samples.size() && samples.size() > 1; ++k) {
    const Sample& a = samples[k > 0 ? k - 1 : 0];
    const Sample& b = samples[std::min(k + 1, samples.size() - 1)];
    slope[k] = std::abs((b.middle - a.middle) / (b.place - a.place));
  }
  for (std::size_t k = 0; k < samples.size(); ++k) {
    samples[k].width = slope[k] <= steepest ? samples[k].length / std::hypot(1.0, slope[k])
                                            : std::numeric_limits<double>::infinity();
  }
}

class Search {
 public:
  Search(const Scene& scene, const LineCuts& cuts, std::map<Kind, Found>& found)
      : scene_(scene), cuts_(cuts), found_(found), limit_((wanted - 1e-6) * scene.spacing) {}

  /// Lines along `axis`, followed over `over`; all other coordinates are those of `at`.
  void look(std::size_t axis, std::size_t over, const std::vector<double>& places, Vec3 at) {
    axis_ = axis;
    over_ = over;
    at_ = at;
    std::vector<Run> runs;
    std::vector<LinePiece> before;
    for (const double place : places) {
      at_[over] = place;
      const std::vector<LinePiece> line = cuts_.cut(axis, at_);
      runs = follow(std::move(runs), before, line, place);
      before = line;
    }
    for (const Run& run : runs) judge(run, true);
  }

 private:
  std::vector<Run> follow(std::vector<Run> runs, const std::vector<LinePiece>& before,
                          const std::vector<LinePiece>& line, double place) {
    std::vector<Run> next;
    std::vector<bool> taken(runs.size(), false);
    std::size_t first = 0;  // runs and pieces ascend: those before it are too low for what follows
    for (std::size_t p = 0; p < line.size(); ++p) {
      const LinePiece& piece = line[p];
      const double length = piece.high - piece.low, middle = 0.5 * (piece.low + piece.high);
      if (length > 1.5 * limit_) continue;  // too wide even where it runs at 45 degrees
      Run run;
      for (std::size_t r = first; r < runs.size(); ++r) {
        if (taken[r]) continue;
        const Sample& last = runs[r].samples.back();
        const double apart = std::abs(middle - last.middle);
        const double furthest = 1.5 * limit_ + 1.2 * (place - last.place);
        if (last.middle < middle - furthest) first = r + 1;
        if (last.middle > middle + furthest) break;
        const double reach = 0.5 * (length + last.length) + 1.2 * (place - last.place);
        if (runs[r].material != piece.material || apart > reach) continue;
        taken[r] = true;
        run = std::move(runs[r]);
        break;
      }
      if (run.samples.empty()) {
        run.material = piece.material;
        run.body = piece.body;
        run.below = p > 0 ? line[p - 1].body : -1;
        run.above = p + 1 < line.size() ? line[p + 1].body : -1;
        run.closed_before = material_at(before, middle) != piece.material;
      }
      run.samples.push_back({place, middle, length, 0.0});
      next.push_back(std::move(run));
    }
    for (std::size_t r = 0; r < runs.size(); ++r) {
      if (taken[r]) continue;
      judge(runs[r], material_at(line, runs[r].samples.back().middle) != runs[r].material);
    }
    return next;
  }

  void judge(Run run, bool closed_after) {
    std::vector<Sample>& s = run.samples;
    set_widths(s);
    const auto thin = [this](const Sample& sample) { return sample.width < limit_; };
    const auto first_thin = std::find_if(s.begin(), s.end(), thin);
    if (first_thin == s.end()) return;
    run.closed_before = run.closed_before && first_thin == s.begin();
    s.erase(s.begin(), first_thin);
    while (!thin(s.back())) {
      s.pop_back();
      closed_after = false;
    }
    const double along = long_enough * scene_.spacing;
    const bool small = s.back().place - s.front().place < along;
    if (small) {
      if (run.closed_before && closed_after && std::all_of(s.begin(), s.end(), thin))
        name(run, *widest(s.begin(), s.end()), true);
      return;
    }
    // The narrowest stretch, so long, over which the width changes less than in a taper.
    const Sample* narrowest = nullptr;
    for (std::size_t first = 0, last = 0; first < s.size(); ++first) {
      last = std::max(last, first);
      while (last + 1 < s.size() && s[last].place - s[first].place < along) ++last;
      if (s[last].place - s[first].place < along) break;
      const auto begin = s.begin() + static_cast<std::ptrdiff_t>(first),
                 end = s.begin() + static_cast<std::ptrdiff_t>(last) + 1;
      const Sample& wide = *widest(begin, end);
      const Sample& least = *std::min_element(begin, end, narrower);
      if (wide.width >= limit_) continue;
      if (wide.width - least.width > taper * (s[last].place - s[first].place)) continue;
      if (narrowest == nullptr || wide.width < narrowest->width) narrowest = &wide;
    }
    if (narrowest == nullptr) return;
    const Sample& widest_of_all = *widest(s.begin(), s.end());
    const bool wedge = std::min_element(s.begin(), s.end(), narrower)->width < 0.1 * limit_ &&
                       widest_of_all.width > 0.9 * limit_;
    name(run, wedge ? widest_of_all : *narrowest, false,
         wedge ? s.back().place - s.front().place : 0.0);
  }

  static bool narrower(const Sample& a, const Sample& b) { return a.width < b.width; }
  static std::vector<Sample>::const_iterator widest(std::vector<Sample>::const_iterator begin,
                                                    std::vector<Sample>::const_iterator end) {
    return std::max_element(begin, end, narrower);
  }

  void name(const Run& run, const Sample& sample, bool hole, double tapers = 0.0) {
    Found& found = found_[{run.material, run.body, std::min(run.below, run.above),
                           std::max(run.below, run.above)}];
    ++found.count;
    if (sample.width >= found.width) return;
    found.width = sample.width;
    found.place = at_;
    found.place[over_] = sample.place;
    found.place[axis_] = sample.middle;
    found.hole = hole;
    found.tapers = tapers;
  }

  const Scene& scene_;
  const LineCuts& cuts_;
  std::map<Kind, Found>& found_;
  double limit_;
  std::size_t axis_ = 0, over_ = 0;
  Vec3 at_{};
};

/// Places from `low` to `high`, `step` apart, and between all corners, as long as there are not too
/// many.
std::vector<double> places_between(const LineCuts& cuts, std::size_t axis, double step,
                                   double most) {
  const double low = cuts.minimum()[axis], high = cuts.maximum()[axis];
  std::vector<double> places;
  const double pieces = std::clamp(std::ceil((high - low) / step), 1.0, most);
  const auto count = static_cast<std::size_t>(pieces);
  for (std::size_t k = 0; k < count; ++k)
    places.push_back(low + (high - low) * (static_cast<double>(k) + 0.5) / pieces);
  const std::vector<double> corners = cuts.corners(axis);
  if (static_cast<double>(corners.size()) <= most) {
    for (std::size_t k = 1; k < corners.size(); ++k)
      places.push_back(0.5 * (corners[k - 1] + corners[k]));
  }
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return places;
}

/// What one line costs, in edges looked at.
double cost_of_line(const Scene& scene) {
  double cost = 0.0;
  for (const Body& body : scene.bodies) cost += row_of(body.shape).cost(body.shape);
  return cost;
}

std::string sentence(const Scene& scene, const Kind& kind, const Found& found) {
  const std::string place = point_text(found.place, scene.dimension);
  const std::string more =
      found.count > 1 ? fmt::format(" (the narrowest of {} such places)", found.count) : "";
  if (kind.material < 0) {
    const std::string where =
        kind.below == kind.above
            ? fmt::format("in body[{}]", kind.below)
            : fmt::format("between body[{}] and body[{}]", kind.below, kind.above);
    return fmt::format(
        "{}: {} at {} is {:.3g} m wide, less than two spacings of {:g} m{}: below one spacing it "
        "may "
        "vanish, and below two the soil on its sides acts across it. Try spacing = {:.3g}, or a "
        "wider "
        "one.",
        where, found.hole ? "the hole" : "the gap", place, found.width, scene.spacing, more,
        found.width / wanted);
  }
  if (found.tapers > 0.0) {
    return fmt::format(
        "body[{}]: from {} on it thins out to nothing over {:.3g} m, all of it thinner than two "
        "spacings of {:g} m{}: where it is thinner than one it may vanish. Try to end it where it "
        "is "
        "{:.3g} m thick, or a smaller spacing.",
        kind.body, place, found.tapers, scene.spacing, more, wanted * scene.spacing);
  }
  const std::string& material = scene.materials[static_cast<std::size_t>(kind.material)].name;
  return fmt::format(
      "material '{}': the layer of body[{}] at {} is {:.3g} m thick, less than two spacings of "
      "{:g} "
      "m{}: a single row of particles cannot shear in itself, and what is thinner than a spacing "
      "may "
      "vanish. Two to three rows are needed; a row of weak soil between stronger soil takes the "
      "row above it too. Try spacing = {:.3g} to {:.3g}, or a thicker one.",
      material, kind.body, place, found.width, scene.spacing, more, found.width / 3.0,
      found.width / wanted);
}

}  // namespace

std::vector<std::string> thin_places(const Scene& scene) {
  if (scene.bodies.empty()) return {};
  constexpr double most_work = 3e7;  // edges looked at: below a second
  const LineCuts cuts(scene);
  std::map<Kind, Found> found;
  Search search(scene, cuts, found);
  const bool plane = scene.dimension == 2;
  const double lines =
      std::clamp(most_work / cost_of_line(scene) / (plane ? 2.0 : 6.0), 10.0, most_lines);
  const double step = 0.5 * scene.spacing;
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(scene.dimension); ++axis) {
    const std::size_t up = plane ? 1 : 2;
    if (axis != up && !cuts.knows(axis)) continue;
    for (std::size_t over = 0; over < static_cast<std::size_t>(scene.dimension); ++over) {
      if (over == axis) continue;
      if (plane) {
        search.look(axis, over, places_between(cuts, over, step, lines), {});
        continue;
      }
      const std::size_t third = 3 - axis - over;
      const double each = std::sqrt(lines);
      for (const double place : places_between(cuts, third, 2.0 * step, each)) {
        Vec3 at{};
        at[third] = place;
        search.look(axis, over, places_between(cuts, over, step, each), at);
      }
    }
  }
  std::vector<std::string> sentences;
  for (const auto& [kind, one] : found) sentences.push_back(sentence(scene, kind, one));
  return sentences;
}

}  // namespace scarp
