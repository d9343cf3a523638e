// SPDX-License-Identifier: BSD-3-Clause
/// Local linear fits by least squares.
#include "validation/pressure_noise.hpp"

#include <cmath>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

namespace scarp::validation {
namespace {

/// Sums of a fit p = a + b x + c y.
struct Fit {
  double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0, p = 0.0, px = 0.0, py = 0.0;

  void add(double dx, double dy, double pressure) {
    n += 1.0;
    x += dx;
    y += dy;
    xx += dx * dx;
    xy += dx * dy;
    yy += dy * dy;
    p += pressure;
    px += pressure * dx;
    py += pressure * dy;
  }
  /// a, the value at the centre, by Cramer's rule.
  double at_centre() const {
    const double a = xx * yy - xy * xy, b = x * yy - y * xy, c = x * xy - y * xx;
    return (p * a - px * b + py * c) / (n * a - x * b + y * c);
  }
};

}  // namespace

double pressure_noise(const Simulation& simulation) {
  const std::vector<double> position = simulation.field("position"),
                            stress = simulation.field("stress");
  const double reach = 2.0 * simulation.smoothing_length(), spacing = simulation.scene().spacing;
  const double inside = 0.75 * std::numbers::pi * reach * reach / (spacing * spacing);
  using Key = std::pair<long, long>;
  std::map<Key, std::vector<std::size_t>> cells;
  const std::size_t count = position.size() / 3;
  const auto key = [&](std::size_t k) {
    return Key{std::lround(std::floor(position[3 * k] / reach)),
               std::lround(std::floor(position[3 * k + 1] / reach))};
  };
  std::vector<double> pressure(count);
  for (std::size_t k = 0; k < count; ++k) {
    const double* s = &stress[6 * k];
    pressure[k] = -(s[0] + s[1] + s[2]) / 3.0;
    cells[key(k)].push_back(k);
  }
  double rough = 0.0, all = 0.0;
  for (std::size_t k = 0; k < count; ++k) {
    Fit fit;
    const auto [i, j] = key(k);
    for (long n = 0; n < 9; ++n) {
      const auto cell = cells.find({i + n % 3 - 1, j + n / 3 - 1});
      if (cell == cells.end()) continue;
      for (const std::size_t other : cell->second) {
        const double dx = position[3 * other] - position[3 * k],
                     dy = position[3 * other + 1] - position[3 * k + 1];
        if (dx * dx + dy * dy < reach * reach) fit.add(dx / reach, dy / reach, pressure[other]);
      }
    }
    if (fit.n < inside) continue;
    const double off = pressure[k] - fit.at_centre();
    rough += off * off;
    all += pressure[k] * pressure[k];
  }
  return std::sqrt(rough / all);
}

}  // namespace scarp::validation
