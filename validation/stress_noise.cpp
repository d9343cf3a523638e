// SPDX-License-Identifier: BSD-3-Clause
/// Local linear fits by least squares.
#include "validation/stress_noise.hpp"

#include <Eigen/Dense>

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <vector>

namespace scarp::validation {
namespace {

/// Pressure and the shear stresses.
using Values = Eigen::Vector4d;
/// 1 and the offset over the reach.
using Basis = Eigen::Vector4d;
using Key = std::array<long, 3>;

struct Fit {
  Eigen::Matrix4d normal = Eigen::Matrix4d::Zero(), sums = Eigen::Matrix4d::Zero();

  explicit Fit(int dimension) { normal(3, 3) = dimension == 2 ? 1.0 : 0.0; }  // no slope along z
  void add(const Basis& basis, const Values& values) {
    normal += basis * basis.transpose();
    sums += basis * values.transpose();
  }
  double count() const { return normal(0, 0); }
  Values at_centre() const { return normal.ldlt().solve(sums).row(0).transpose(); }
};

}  // namespace

StressNoise stress_noise(const Simulation& simulation) {
  const std::vector<double> position = simulation.field("position"),
                            stress = simulation.field("stress");
  const int dimension = simulation.scene().dimension;
  const double reach = 2.0 * simulation.smoothing_length(), spacing = simulation.scene().spacing;
  const double rows = reach / spacing;
  const double inside =
      0.75 * std::numbers::pi * (dimension == 2 ? rows * rows : 4.0 / 3.0 * rows * rows * rows);
  const std::size_t count = position.size() / 3;
  std::map<Key, std::vector<std::size_t>> cells;
  const auto key = [&](std::size_t k) {
    Key place{};
    for (std::size_t a = 0; a < 3; ++a)
      place[a] = std::lround(std::floor(position[3 * k + a] / reach));
    return place;
  };
  std::vector<Values> values(count);
  for (std::size_t k = 0; k < count; ++k) {
    const double* s = &stress[6 * k];
    values[k] = {-(s[0] + s[1] + s[2]) / 3.0, s[3], s[4], s[5]};
    cells[key(k)].push_back(k);
  }
  const auto neighbour_cells = [&](const Key& centre, auto&& with) {
    const long last = dimension == 2 ? 0 : 1;
    for (long x = -1; x <= 1; ++x)
      for (long y = -1; y <= 1; ++y)
        for (long z = -last; z <= last; ++z) {
          const auto cell = cells.find({centre[0] + x, centre[1] + y, centre[2] + z});
          if (cell != cells.end()) with(cell->second);
        }
  };
  double rough = 0.0, rough_shear = 0.0, all = 0.0;
  for (std::size_t k = 0; k < count; ++k) {
    Fit fit(dimension);
    neighbour_cells(key(k), [&](const std::vector<std::size_t>& members) {
      for (const std::size_t other : members) {
        const double *to = &position[3 * other], *from = &position[3 * k];
        const Basis basis{1.0, (to[0] - from[0]) / reach, (to[1] - from[1]) / reach,
                          (to[2] - from[2]) / reach};
        if (basis.tail<3>().squaredNorm() < 1.0) fit.add(basis, values[other]);
      }
    });
    if (fit.count() < inside) continue;
    const Values off = values[k] - fit.at_centre();
    rough += off[0] * off[0];
    rough_shear += off.tail<3>().squaredNorm();
    all += values[k][0] * values[k][0];
  }
  return {std::sqrt(rough / all), std::sqrt(rough_shear / all)};
}

}  // namespace scarp::validation
