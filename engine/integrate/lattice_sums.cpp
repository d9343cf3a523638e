// SPDX-License-Identifier: BSD-3-Clause
/// Waves on the undisturbed lattice.
#include "engine/integrate/lattice_sums.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "engine/particles/lattice_places.hpp"
#include "kernels/pair/term_rows.hpp"

namespace scarp {
namespace {

struct Neighbour {
  double direction[3];
  std::array<double, 3> place;  ///< in spacings
  double distance;              ///< in h
  double slope;                 ///< V |W'|, times h
};

std::size_t index(const kernels::TermRow& row) { return static_cast<std::size_t>(row.term); }

std::vector<Neighbour> neighbours(const kernels::SmoothingForm& form, double ratio, int dimension) {
  const double volume = form.normalisation(dimension) / std::pow(ratio, dimension);
  std::vector<Neighbour> all;
  for (const Site& offset : offsets_within(2.0 * ratio, dimension)) {
    const double r = length_of(offset);
    if (r >= 2.0 * ratio) continue;
    Neighbour one{{}, {}, r / ratio, -volume * form.slope(r / ratio)};
    for (std::size_t a = 0; a < 3; ++a) {
      one.place[a] = static_cast<double>(offset[a]);
      one.direction[a] = one.place[a] / r;
    }
    all.push_back(one);
  }
  return all;
}

}  // namespace

LatticeSums lattice_sums(const kernels::SmoothingForm& form, double smoothing_ratio,
                         int dimension) {
  const std::vector<Neighbour> all = neighbours(form, smoothing_ratio, dimension);
  LatticeSums sums;
  sums.moment = 0.0;
  for (const Neighbour& j : all) sums.moment += j.distance * j.slope / dimension;
  constexpr int samples = 64;
  for (int axes = 1; axes <= dimension; ++axes) {
    for (int s = 1; s <= samples; ++s) {
      const double k = std::numbers::pi * s / samples;  // along so many axes, per spacing
      std::array<double, 3> gradient{};
      std::array<double, kernels::term_count> damping{};
      for (const Neighbour& j : all) {
        double phase = 0.0;
        for (int a = 0; a < axes; ++a) phase += k * j.place[static_cast<std::size_t>(a)];
        for (std::size_t a = 0; a < 3; ++a)
          gradient[a] += j.slope * j.direction[a] * std::sin(phase);
        const double part = j.slope / j.distance * (1.0 - std::cos(phase));
        for (const kernels::TermRow& row : kernels::term_rows) {
          if (row.limit != nullptr) damping[index(row)] += row.damping(part, j.direction);
        }
      }
      sums.wave_number =
          std::max(sums.wave_number, std::hypot(gradient[0], gradient[1], gradient[2]));
      for (std::size_t t = 0; t < damping.size(); ++t)
        sums.damping[t] = std::max(sums.damping[t], damping[t]);
    }
  }
  return sums;
}

double acoustic_cfl_limit(const Numerics& numerics, const LatticeSums& sums) {
  const double wave_number =
      sums.wave_number / (numerics.lattice_normalisation ? sums.moment : 1.0);
  return (numerics.integrator == Integrator::verlet ? 1.0 : 2.0) / wave_number;
}

DampingRates damping_rates(const Numerics& numerics, const LatticeSums& sums,
                           const kernels::TermSettings& settings) {
  // Damping by the velocity before is a forward step, stable up to a rate of 2/dt; half of that
  // leaves room for the wave itself. In Verlet's leap it feeds a second solution, which begins as
  // (rate dt)^2/4, grows by exp(rate dt) a step and ends with the next forward step: at the CFL
  // number 0.2 of its preset it stays below 1 up to a rate of 5.2/(M dt), 26/M in units of c/h.
  const double share = numerics.integrator == Integrator::verlet
                           ? std::min(1.0, 26.0 / numerics.verlet_restart_interval)
                           : 1.0;
  const double scale = 1.0 / (share * (numerics.lattice_normalisation ? sums.moment : 1.0));
  DampingRates rates{};
  for (const kernels::TermRow& row : kernels::term_rows) {
    if (row.limit != nullptr && row.used(settings))
      rates[index(row)] = row.damping_rate(settings, scale, sums.damping[index(row)]);
  }
  return rates;
}

}  // namespace scarp
