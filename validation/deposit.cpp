// SPDX-License-Identifier: BSD-3-Clause
/// Columns, fronts and areas of deposits.

#include "validation/deposit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <numbers>
#include <numeric>
#include <string>
#include <unordered_map>

#include "engine/errors.hpp"
#include "engine/output/text_file.hpp"

namespace scarp::validation {
namespace {

/// Integral of |d| over a length on which d goes linearly from `first` to `last`.
double absolute_area(double first, double last, double length) {
  const double sum = std::fabs(first) + std::fabs(last);
  if (first * last >= 0.0) return 0.5 * sum * length;
  return 0.5 * (first * first + last * last) / sum * length;
}

double distance_to_piece(double x, double y, const Profile& line, std::size_t k) {
  const double along_x = line.x[k + 1] - line.x[k], along_y = line.height[k + 1] - line.height[k];
  const double to_x = x - line.x[k], to_y = y - line.height[k];
  const double length = along_x * along_x + along_y * along_y;
  const double share = std::clamp((to_x * along_x + to_y * along_y) / length, 0.0, 1.0);
  return std::hypot(to_x - share * along_x, to_y - share * along_y);
}

/// Particles by cells as wide as the reach, so that near ones are in the 27 cells around.
class Cells {
 public:
  Cells(const std::vector<double>& position, double reach) : position_(position), reach_(reach) {
    for (std::size_t i = 0; 3 * i < position.size(); ++i) cells_[key(cell_of(i))].push_back(i);
  }

  template <class Visit>
  void near(std::size_t i, const Visit& visit) const {
    const Cell home = cell_of(i);
    for (int n = 0; n < 27; ++n) {
      const auto found =
          cells_.find(key({home[0] + n % 3 - 1, home[1] + n / 3 % 3 - 1, home[2] + n / 9 - 1}));
      if (found == cells_.end()) continue;
      for (const std::size_t j : found->second) {
        const double x = position_[3 * i] - position_[3 * j],
                     y = position_[3 * i + 1] - position_[3 * j + 1],
                     z = position_[3 * i + 2] - position_[3 * j + 2];
        if (x * x + y * y + z * z < reach_ * reach_) visit(j);
      }
    }
  }

 private:
  using Cell = std::array<long, 3>;
  Cell cell_of(std::size_t i) const {
    Cell cell;
    for (std::size_t a = 0; a < 3; ++a) {
      cell[a] = static_cast<long>(std::floor(position_[3 * i + a] / reach_));
    }
    return cell;
  }
  static std::string key(const Cell& cell) {
    return fmt::format("{} {} {}", cell[0], cell[1], cell[2]);
  }

  const std::vector<double>& position_;
  double reach_;
  std::unordered_map<std::string, std::vector<std::size_t>> cells_;
};

}  // namespace

Profile column_profile(const std::vector<double>& x, double spacing, double width) {
  const double end = x.empty() ? 0.0 : *std::max_element(x.begin(), x.end()) + spacing;
  std::vector<double> area(static_cast<std::size_t>(end / width) + 2);
  for (const double at : x) {
    const double left = at - 0.5 * spacing, right = at + 0.5 * spacing;
    // What reaches over x = 0 is the mirror image's gain, not a loss.
    auto k = static_cast<std::size_t>(std::max(left, 0.0) / width);
    for (double from = left; from < right; ++k) {
      const double to = std::max(from, std::min(right, static_cast<double>(k + 1) * width));
      area[k] += spacing * (to - from);
      from = to;
    }
  }
  while (!area.empty() && area.back() == 0.0) area.pop_back();
  if (area.empty()) return {};
  Profile profile{{0.0}, {area.front() / width}};
  for (std::size_t k = 0; k < area.size(); ++k) {
    profile.x.push_back((static_cast<double>(k) + 0.5) * width);
    profile.height.push_back(area[k] / width);
  }
  profile.x.push_back(profile.x.back() + width);
  profile.height.push_back(0.0);
  return profile;
}

double height_at(const Profile& profile, double x) {
  if (profile.x.empty() || x > profile.x.back()) return 0.0;
  if (x <= profile.x.front()) return profile.height.front();
  const auto k = static_cast<std::size_t>(std::lower_bound(profile.x.begin(), profile.x.end(), x) -
                                          profile.x.begin());
  const double share = (x - profile.x[k - 1]) / (profile.x[k] - profile.x[k - 1]);
  return profile.height[k - 1] + share * (profile.height[k] - profile.height[k - 1]);
}

double area_between(const Profile& a, const Profile& b) {
  std::vector<double> knots{0.0};
  knots.insert(knots.end(), a.x.begin(), a.x.end());
  knots.insert(knots.end(), b.x.begin(), b.x.end());
  std::sort(knots.begin(), knots.end());
  double area = 0.0;
  for (std::size_t k = 0; k + 1 < knots.size(); ++k) {
    const double from = knots[k], length = knots[k + 1] - from;
    if (from < 0.0 || length <= 0.0) continue;
    // Both are linear between knots, but may jump at one: the ends follow from two inner places.
    const auto difference = [&](double share) {
      const double x = from + share * length;
      return height_at(a, x) - height_at(b, x);
    };
    const double near = difference(0.25), far = difference(0.75);
    area += absolute_area(1.5 * near - 0.5 * far, 1.5 * far - 0.5 * near, length);
  }
  return area;
}

double mean_distance(const Profile& points, const Profile& line) {
  if (points.x.empty() || line.x.size() < 2) return std::numeric_limits<double>::quiet_NaN();
  double sum = 0.0;
  for (std::size_t i = 0; i < points.x.size(); ++i) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k + 1 < line.x.size(); ++k) {
      least = std::min(least, distance_to_piece(points.x[i], points.height[i], line, k));
    }
    sum += least;
  }
  return sum / static_cast<double>(points.x.size());
}

Profile read_profile(const std::filesystem::path& path) {
  std::ifstream stream(path);
  std::string line;
  Profile profile;
  std::getline(stream, line);
  double x = 0.0, height = 0.0;
  char comma = ' ';
  while (stream >> x >> comma >> height && comma == ',') {
    profile.x.push_back(x);
    profile.height.push_back(height);
  }
  if (profile.x.empty() || !stream.eof()) {
    throw FileError(fmt::format(
        "'{}': not a table of two columns of numbers below a line of titles.", path.string()));
  }
  return profile;
}

void write_profile(const std::filesystem::path& path, const Profile& profile) {
  CsvFile file(path, {"x [m]", "height [m]"});
  for (std::size_t k = 0; k < profile.x.size(); ++k) {
    file << profile.x[k] << profile.height[k];
    file.end_row();
  }
}

double closed_front(const std::vector<double>& distances, int dimension, double spacing,
                    double grain) {
  const double width = 4.0 * spacing;
  std::vector<double> depth;
  for (const double distance : distances) {
    const auto k = static_cast<std::size_t>(std::max(distance, 0.0) / width);
    if (k >= depth.size()) depth.resize(k + 1, 0.0);
    const double ring = 0.25 * std::numbers::pi * static_cast<double>(2 * k + 1) * width * width;
    depth[k] += dimension == 2 ? spacing * spacing / width : spacing * spacing * spacing / ring;
  }
  depth.push_back(0.0);
  std::size_t k = 0;
  while (depth[k] >= grain) ++k;
  if (k == 0) return 0.0;
  return (static_cast<double>(k) - 0.5 + (depth[k - 1] - grain) / (depth[k - 1] - depth[k])) *
         width;
}

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto rank = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + rank, values.end());
  return values[static_cast<std::size_t>(rank)];
}

std::vector<std::size_t> main_body(const std::vector<double>& position, double reach) {
  const Cells cells(position, reach);
  std::vector<char> seen(position.size() / 3, 0);
  std::vector<std::size_t> largest;
  for (std::size_t first = 0; first < seen.size(); ++first) {
    if (seen[first]) continue;
    std::vector<std::size_t> body{first};
    seen[first] = 1;
    for (std::size_t next = 0; next < body.size(); ++next) {
      cells.near(body[next], [&](std::size_t j) {
        if (seen[j]) return;
        seen[j] = 1;
        body.push_back(j);
      });
    }
    if (body.size() > largest.size()) largest = std::move(body);
  }
  return largest;
}

double share_through_walls(const std::vector<double>& position, int dimension, double spacing) {
  std::size_t through = 0;
  for (std::size_t i = 0; i < position.size(); i += 3) {
    const double z = dimension == 3 ? position[i + 2] : 0.0;
    if (std::min({position[i], position[i + 1], z}) < -spacing) ++through;
  }
  return 3.0 * static_cast<double>(through) / static_cast<double>(position.size());
}

}  // namespace scarp::validation
