// SPDX-License-Identifier: BSD-3-Clause
/// Where the parts of a soil come together.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace scarp {

/// Joins the minima, maxima and sums that a step takes over the whole soil (time step, rest, watch,
/// heights, energies, counts). Here: the particles of this process are all there are, every value
/// is the whole's already. An engine that holds the soil in several parts derives from it; each
/// member is then called by every part with as many values in the same order, and gives all of them
/// the same.
class Reduction {
 public:
  virtual ~Reduction() = default;
  virtual void maximum(std::span<double> /*values*/) {}
  virtual void minimum(std::span<double> /*values*/) {}
  virtual void sum(std::span<double> /*values*/) {}
  /// Appends the values of the other parts, as many as they have.
  virtual void gather(std::vector<double>& /*values*/) {}
  /// Called by a part that leaves its set-up, a step, or another member that reduces, by an
  /// exception: it takes no part in the reductions that follow. From then on each member must throw
  /// in every part, also where it waits already, else the others wait for ever. What it throws
  /// leaves their steps. To go on, make the parts anew from snapshots, with another reduction.
  virtual void abort() noexcept {}

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
  template <std::size_t N>
  void sum_each(double* const (&places)[N]) {
    std::array<double, N> values;
    for (std::size_t k = 0; k < N; ++k) values[k] = *places[k];
    sum(values);
    for (std::size_t k = 0; k < N; ++k) *places[k] = values[k];
  }
  void sum_each(std::vector<std::array<double, 3>>& vectors) {
    std::vector<double> values;
    for (const auto& vector : vectors) values.insert(values.end(), vector.begin(), vector.end());
    sum(values);
    for (std::size_t k = 0; k < values.size(); ++k) vectors[k / 3][k % 3] = values[k];
  }
};

/// What throws in one part of a soil does not leave the others waiting for it.
template <class Call>
decltype(auto) or_abort(Reduction* reduction, const Call& call) {
  try {
    return call();
  } catch (...) {
    if (reduction != nullptr) reduction->abort();
    throw;
  }
}

}  // namespace scarp
