// SPDX-License-Identifier: BSD-3-Clause
/// Boundaries between layers after the collapse.

#include "validation/cases/cuboid_3d/layers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/output/text_file.hpp"

namespace scarp::validation {
namespace {

using Line = std::vector<std::array<double, 2>>;  ///< (x, z) [m]

/// The particles that lay next to a boundary in the middle section, by their present x, averaged
/// over five neighbours: one row above it and one below, so that their mean is the boundary.
Line boundary(const std::vector<double>& position, const std::vector<double>& start, double height,
              const CuboidSize& size, double spacing) {
  Line points;
  for (std::size_t i = 0; i < position.size(); i += 3) {
    if (start[i] < size.gate && start[i + 1] < spacing &&
        std::fabs(start[i + 2] - height) < 0.75 * spacing) {
      points.push_back({position[i], position[i + 2]});
    }
  }
  std::sort(points.begin(), points.end());
  Line smooth;
  constexpr std::size_t reach = 5;
  for (std::size_t k = reach; k + reach < points.size(); ++k) {
    std::array<double, 2> mean{};
    for (std::size_t j = k - reach; j <= k + reach; ++j) {
      for (std::size_t a = 0; a < 2; ++a) mean[a] += points[j][a] / (2.0 * reach + 1.0);
    }
    smooth.push_back(mean);
  }
  return smooth;
}

/// Where a line is steepest over about four spacings: between its bend down and its bend back.
std::array<double, 2> steepest(const Line& line, double spacing) {
  std::array<double, 2> found{std::nan(""), std::nan("")};
  double most = 0.0;
  for (std::size_t a = 0; a < line.size(); ++a) {
    std::size_t b = a;
    while (b < line.size() && line[b][0] - line[a][0] < 4.0 * spacing) ++b;
    if (b == line.size()) break;
    const double slope = (line[a][1] - line[b][1]) / (line[b][0] - line[a][0]);
    if (slope <= most) continue;
    most = slope;
    found = {0.5 * (line[a][0] + line[b][0]), 0.5 * (line[a][1] + line[b][1])};
  }
  return found;
}

/// Mean over the grains (x, z, strain) at whose place `counts` holds.
template <class Counts>
double mean_strain(const std::vector<std::array<double, 3>>& grains, Counts&& counts) {
  double sum = 0.0, number = 0.0;
  for (const auto& [x, z, strain] : grains) {
    if (!counts(x, z)) continue;
    sum += strain;
    number += 1.0;
  }
  return sum / number;
}

}  // namespace

void measure_layers(const Simulation& fallen, const std::vector<double>& start,
                    const CuboidSize& size, const std::filesystem::path& folder, Outcome& outcome) {
  const std::vector<double> position = fallen.field("position"),
                            strain = fallen.field("accumulated_plastic_strain");
  const double spacing = fallen.scene().spacing;
  CsvFile table(folder / "layers.csv", {"boundary", "x [m]", "z [m]"});
  std::vector<std::array<double, 2>> points;
  for (int b = 1; b < layer_count; ++b) {
    const double height = size.base_layer + size.fill * b / layer_count;
    const Line line = boundary(position, start, height, size, spacing);
    for (const auto& [x, z] : line) {
      table << static_cast<double>(b) << x << z;
      table.end_row();
    }
    points.push_back(steepest(line, spacing));
    outcome.values[fmt::format("boundary {}: inflection x [m]", b)] = points.back()[0];
    outcome.values[fmt::format("boundary {}: inflection z [m]", b)] = points.back()[1];
  }
  std::vector<std::array<double, 3>> fill;  // present x and z, strain
  for (std::size_t i = 0; i < strain.size(); ++i) {
    if (start[3 * i + 1] < spacing && start[3 * i] < size.gate &&
        start[3 * i + 2] > size.base_layer)
      fill.push_back({position[3 * i], position[3 * i + 2], strain[i]});
  }
  const auto around = [&](double x, double z) {
    return mean_strain(
        fill, [&](double px, double pz) { return std::hypot(px - x, pz - z) < 2.0 * spacing; });
  };
  double off = 0.0, near = 0.0;
  for (const auto& [x, z] : points) {
    double most = -1.0, at = std::nan("");
    for (const auto& [px, pz, grain] : fill) {
      if (std::fabs(pz - z) > 0.75 * spacing) continue;
      if (const double here = around(px, pz); here > most) {
        most = here;
        at = px;
      }
    }
    off += std::fabs(at - x) / spacing / static_cast<double>(points.size());
    near += around(x, z) / static_cast<double>(points.size());
  }
  outcome.values["inflection points from the most sheared soil over spacing [-]"] = off;
  outcome.values["plastic strain at the inflection points over the fill's [-]"] =
      near / mean_strain(fill, [](double, double) { return true; });
}

}  // namespace scarp::validation
