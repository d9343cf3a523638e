// SPDX-License-Identifier: BSD-3-Clause
/// Where the parts of a soil come together.
#pragma once

#include <array>
#include <cstddef>
#include <initializer_list>
#include <span>
#include <vector>

namespace scarp {

/// Joins the minima, maxima and sums that a step takes over the whole soil (time step, rest, watch,
/// heights, energies, counts). Here: the particles of this process are all there are, every value
/// is the whole's already. An engine that holds the soil in several parts derives from it; each
/// member is then called by every part with as many values in the same order, and gives all of them
/// the same. A part whose step throws takes no part in the reductions that would have followed.
class Reduction {
 public:
  virtual ~Reduction() = default;
  virtual void maximum(std::span<double> /*values*/) {}
  virtual void minimum(std::span<double> /*values*/) {}
  virtual void sum(std::span<double> /*values*/) {}
  /// Appends the values of the other parts, as many as they have.
  virtual void gather(std::vector<double>& /*values*/) {}

  double maximum_of(double value) {
    maximum({&value, 1});
    return value;
  }
  double minimum_of(double value) {
    minimum({&value, 1});
    return value;
  }
  double sum_of(double value) {
    sum({&value, 1});
    return value;
  }
  void sum_each(std::initializer_list<double*> places) {
    std::vector<double> values;
    for (const double* place : places) values.push_back(*place);
    sum(values);
    auto next = values.begin();
    for (double* place : places) *place = *next++;
  }
  void sum_each(std::vector<std::array<double, 3>>& vectors) {
    std::vector<double> values;
    for (const auto& vector : vectors) values.insert(values.end(), vector.begin(), vector.end());
    sum(values);
    for (std::size_t k = 0; k < values.size(); ++k) vectors[k / 3][k % 3] = values[k];
  }
};

}  // namespace scarp
