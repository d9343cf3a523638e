// SPDX-License-Identifier: BSD-3-Clause
/// Local linear fits by least squares.
#include "validation/stress_noise.hpp"

#include <cmath>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

namespace scarp::validation {
namespace {

/// Sums of a fit f = a + b x + c y.
struct Fit {
  double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;
  struct Sums {
    double f = 0.0, fx = 0.0, fy = 0.0;
    void add(double dx, double dy, double value) {
      f += value;
      fx += value * dx;
      fy += value * dy;
    }
  };

  void add(double dx, double dy) {
    n += 1.0;
    x += dx;
    y += dy;
    xx += dx * dx;
    xy += dx * dy;
    yy += dy * dy;
  }
  /// a, the value at the centre, by Cramer's rule.
  double at_centre(const Sums& sums) const {
    const double a = xx * yy - xy * xy, b = x * yy - y * xy, c = x * xy - y * xx;
    return (sums.f * a - sums.fx * b + sums.fy * c) / (n * a - x * b + y * c);
  }
};

}  // namespace

StressNoise stress_noise(const Simulation& simulation) {
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
  double rough = 0.0, rough_shear = 0.0, all = 0.0;
  for (std::size_t k = 0; k < count; ++k) {
    Fit fit;
    Fit::Sums of_pressure, of_shear;
    const auto [i, j] = key(k);
    for (long n = 0; n < 9; ++n) {
      const auto cell = cells.find({i + n % 3 - 1, j + n / 3 - 1});
      if (cell == cells.end()) continue;
      for (const std::size_t other : cell->second) {
        const double dx = position[3 * other] - position[3 * k],
                     dy = position[3 * other + 1] - position[3 * k + 1];
        if (!(dx * dx + dy * dy < reach * reach)) continue;
        fit.add(dx / reach, dy / reach);
        of_pressure.add(dx / reach, dy / reach, pressure[other]);
        of_shear.add(dx / reach, dy / reach, stress[6 * other + 3]);
      }
    }
    if (fit.n < inside) continue;
    const double off = pressure[k] - fit.at_centre(of_pressure),
                 off_shear = stress[6 * k + 3] - fit.at_centre(of_shear);
    rough += off * off;
    rough_shear += off_shear * off_shear;
    all += pressure[k] * pressure[k];
  }
  return {std::sqrt(rough / all), std::sqrt(rough_shear / all)};
}

}  // namespace scarp::validation
