// SPDX-License-Identifier: BSD-3-Clause
/// Bonds found on the lattice, measured later.

#include "validation/cases/rings/bonds.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>

namespace scarp::validation {

Bonds::Bonds(const Simulation& start)
    : spacing_(start.scene().spacing), particles_(start.soil_count()) {
  const std::vector<double> position = start.field("position");
  std::map<std::array<std::int64_t, 2>, std::size_t> sites;
  const auto site = [&](std::size_t i, std::int64_t dx, std::int64_t dy) {
    return std::array<std::int64_t, 2>{
        std::llround((position[3 * i] - position[0]) / spacing_) + dx,
        std::llround((position[3 * i + 1] - position[1]) / spacing_) + dy};
  };
  for (std::size_t i = 0; i < particles_; ++i) sites[site(i, 0, 0)] = i;
  for (std::size_t i = 0; i < particles_; ++i) {
    for (const auto& next : {site(i, 1, 0), site(i, 0, 1)}) {
      if (const auto found = sites.find(next); found != sites.end())
        pairs_.push_back({i, found->second});
    }
  }
}

std::vector<double> Bonds::lengths(const Simulation& now) const {
  const std::vector<double> position = now.field("position");
  std::vector<double> lengths;
  lengths.reserve(pairs_.size());
  for (const auto& pair : pairs_) {
    const std::size_t a = 3 * pair[0], b = 3 * pair[1];
    lengths.push_back(std::hypot(position[a] - position[b], position[a + 1] - position[b + 1]) /
                      spacing_);
  }
  return lengths;
}

double Bonds::longest(const Simulation& now) const {
  const std::vector<double> all = lengths(now);
  return *std::max_element(all.begin(), all.end());
}

double Bonds::broken_share(const Simulation& now) const {
  const std::vector<double> all = lengths(now);
  const auto broken = std::count_if(all.begin(), all.end(),
                                    [](double length) { return !(length <= broken_length); });
  return static_cast<double>(broken) / static_cast<double>(all.size());
}

int Bonds::pieces(const Simulation& now) const {
  std::vector<std::size_t> parent(particles_);
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto root = [&](std::size_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  const std::vector<double> all = lengths(now);
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (all[k] <= broken_length) parent[root(pairs_[k][0])] = root(pairs_[k][1]);
  }
  int count = 0;
  for (std::size_t i = 0; i < particles_; ++i) count += root(i) == i;
  return count;
}

}  // namespace scarp::validation
