// SPDX-License-Identifier: BSD-3-Clause
/// Runs of thin pieces over neighbouring lines.
#include "engine/check/thin_places.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "engine/check/line_cuts.hpp"
#include "engine/check/thin_place_words.hpp"

namespace scarp {
namespace {

constexpr double long_enough = 1.5;   ///< spacings along itself
constexpr double taper = 0.176;       ///< tangent of 10 degrees
constexpr double natural = 3.73;      ///< cotangent of 15 degrees, a tip that is none
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

/// The longest piece of a material that has a part between two places of a line, or none. Open air
/// beyond the soil is a piece without end.
double longest_between(const std::vector<LinePiece>& line, int material, double low, double high) {
  constexpr double endless = std::numeric_limits<double>::infinity();
  if (material < 0 && (line.empty() || low < line.front().low || high > line.back().high))
    return endless;
  double longest = 0.0;
  for (auto piece = std::partition_point(line.begin(), line.end(),
                                         [low](const LinePiece& one) { return one.high < low; });
       piece != line.end() && piece->low <= high; ++piece) {
    if (piece->material == material) longest = std::max(longest, piece->high - piece->low);
  }
  return longest;
}

/// Whether what a piece shows goes on in the next line, `apart` from it. A tip may lie so that it
/// is far longer there and begins beyond the middle of this one.
bool goes_on(const std::vector<LinePiece>& line, int material, const Sample& sample, double apart) {
  const double reach = 0.5 * sample.length;
  if (material < 0) return longest_between(line, material, sample.middle, sample.middle) > 0.0;
  return longest_between(line, material, sample.middle - reach - natural * apart,
                         sample.middle + reach + natural * apart) > 0.0;
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
  Search(const Scene& scene, const LineCuts& cuts, std::map<ThinKind, ThinPlace>& found)
      : scene_(scene),
        cuts_(cuts),
        found_(found),
        limit_((spacings_wanted - 1e-6) * scene.spacing) {}

  /// Lines along `axis`, followed over `over`; all other coordinates are those of `at`.
  void look(std::size_t axis, std::size_t over, const std::vector<double>& places, Vec3 at) {
    axis_ = axis;
    over_ = over;
    at_ = at;
    std::vector<Run> runs;
    std::vector<LinePiece> before;
    double place_before = 0.0;
    for (const double place : places) {
      at_[over] = place;
      const std::vector<LinePiece> line = cuts_.cut(axis, at_);
      runs = follow(std::move(runs), before, line, place, place - place_before);
      before = line;
      place_before = place;
    }
    for (const Run& run : runs) judge(run, true);
  }

 private:
  std::vector<Run> follow(std::vector<Run> runs, const std::vector<LinePiece>& before,
                          const std::vector<LinePiece>& line, double place, double apart) {
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
        const double moved = std::abs(middle - last.middle);
        const double furthest = 1.5 * limit_ + 1.2 * (place - last.place);
        if (last.middle < middle - furthest) first = r + 1;
        if (last.middle > middle + furthest) break;
        const double reach = 0.5 * (length + last.length) + 1.2 * (place - last.place);
        if (runs[r].material != piece.material || moved > reach) continue;
        taken[r] = true;
        run = std::move(runs[r]);
        break;
      }
      const Sample sample{place, middle, length, 0.0};
      if (run.samples.empty()) {
        run.material = piece.material;
        run.body = piece.body;
        run.below = p > 0 ? line[p - 1].body : -1;
        run.above = p + 1 < line.size() ? line[p + 1].body : -1;
        run.closed_before = !goes_on(before, piece.material, sample, apart);
      }
      run.samples.push_back(sample);
      next.push_back(std::move(run));
    }
    for (std::size_t r = 0; r < runs.size(); ++r) {
      if (taken[r]) continue;
      judge(runs[r], !goes_on(line, runs[r].material, runs[r].samples.back(), apart));
    }
    return next;
  }

  void judge(Run run, bool closed_after) {
    std::vector<Sample>& s = run.samples;
    set_widths(s);
    leave_edges_out(run);
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

  /// In 3D a piece near an edge of a thick body is short all along that edge. Across it, along the
  /// third axis, it grows as a layer does not.
  void leave_edges_out(Run& run) {
    if (scene_.dimension == 2) return;
    const std::size_t third = 3 - axis_ - over_;
    const double step = 0.5 * scene_.spacing;
    for (Sample& sample : run.samples) {
      for (const double way : {-step, step}) {
        if (sample.width >= limit_) break;
        Vec3 at = at_;
        at[over_] = sample.place;
        at[third] += way;
        const double reach = 0.5 * sample.length;
        const double there = longest_between(cuts_.cut(axis_, at), run.material,
                                             sample.middle - reach, sample.middle + reach);
        if (there - sample.length > taper * step)
          sample.width = std::numeric_limits<double>::infinity();
      }
    }
  }

  static bool narrower(const Sample& a, const Sample& b) { return a.width < b.width; }
  static std::vector<Sample>::const_iterator widest(std::vector<Sample>::const_iterator begin,
                                                    std::vector<Sample>::const_iterator end) {
    return std::max_element(begin, end, narrower);
  }

  void name(const Run& run, const Sample& sample, bool hole, double tapers = 0.0) {
    ThinPlace& found = found_[{run.material, run.body, std::min(run.below, run.above),
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
  std::map<ThinKind, ThinPlace>& found_;
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

}  // namespace

std::vector<std::string> thin_places(const Scene& scene) {
  if (scene.bodies.empty()) return {};
  constexpr double most_work = 3e7;  // edges looked at: below a second
  const LineCuts cuts(scene);
  std::map<ThinKind, ThinPlace> found;
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
  for (const auto& [kind, one] : found) sentences.push_back(words_of(scene, kind, one));
  return sentences;
}

}  // namespace scarp
