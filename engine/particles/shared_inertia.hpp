// SPDX-License-Identifier: BSD-3-Clause
/// Inertia of soil beside soil whose inertia is scaled.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "engine/particles/particles.hpp"
#include "kernels/smoothing/list.hpp"

namespace scarp {

/// The inertia over mass that a particle's neighbours ask for. Equation: I2; the stress of a stiff
/// particle pulls at its neighbours, so that each needs the inertia with which it bears the step
/// that the fastest sound c_max allows: s = <M>/(rho c_max^2) with the mean <M> of the wave moduli
/// of the neighbours by |grad W|, rounded up to a power of 2, where that is more than its
/// material's own; among its like none asks for more.
class AskedInertia {
 public:
  /// Over the neighbours of a particle.
  struct Sums {
    double weights = 0.0, moduli = 0.0;
  };

  explicit AskedInertia(const Scene& scene);
  /// Adds a neighbour of material `other` at the distance r [m].
  void add(std::size_t material, std::size_t other, double r, Sums& sums) const {
    const double weight = std::abs(form_.slope(r / smoothing_length_));
    sums.weights += weight;
    sums.moduli += weight * modulus_[other] / unscaled_modulus_[material];
  }
  double of(std::size_t material, const Sums& sums) const;

 private:
  const kernels::SmoothingForm& form_;
  double smoothing_length_;
  std::vector<double> modulus_;           ///< wave modulus of each material [Pa]
  std::vector<double> unscaled_modulus_;  ///< rho c_max^2 [Pa]
  std::vector<double> mass_scaling_;
};

/// That of each particle, decided at the start. Pre: the particles are complete. Limits: soil that
/// meets scaled soil later keeps what it has.
std::vector<double> shared_inertia(const Scene& scene, const Particles& soil);

}  // namespace scarp
