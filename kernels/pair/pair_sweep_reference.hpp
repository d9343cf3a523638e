// SPDX-License-Identifier: BSD-3-Clause
/// Plain scalar form of all pair terms, straight from the equations: all pairs, SI, no packing. The
/// oracle of the sweeps, never part of a run.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "kernels/particle_view.hpp"
#include "kernels/smoothing/smoothing_reference.hpp"

namespace scarp::kernels {

/// Wall face of a dummy particle: unit normal towards the soil, distance of the dummy behind the
/// face [m], limit of the extrapolation (B1).
struct ReferenceFace {
  std::array<double, 3> normal{};
  double distance = 0.0;
  double limit = extrapolation_limit;
};

/// Soil first, then dummies, then mirror images of soil; every array has an entry for every
/// particle. SI; components xx, yy, zz, xy, yz, zx.
struct ReferenceParticles {
  std::size_t soil_count = 0, wall_count = 0;
  std::vector<std::array<double, 3>> position, velocity;
  std::vector<double> density, volume, sound_speed;
  std::vector<double> diffusivity;  ///< D of the stress diffusion [m2/s]
  std::vector<int> material;        ///< empty: all is one
  std::vector<std::array<double, 6>> stress;
  std::vector<std::array<double, 6>> artificial_stress;  ///< R of Eq. 27 [Pa m6/kg2]
  std::vector<ReferenceFace> face;                       ///< read for dummies only
  /// T = sigma B, row by row, first index the direction of the force [Pa]. Equation: K3.
  std::vector<std::array<double, 9>> force_stress;
  std::vector<std::array<double, 6>> strain_rate;    ///< D of the hourglass viscosity [1/s]; V1
  std::vector<std::array<double, 9>> wall_gradient;  ///< H of dummies [m2/s, in 3D m3/s]; B5

  std::size_t size() const { return position.size(); }
  bool is_wall(std::size_t k) const { return k >= soil_count && k < soil_count + wall_count; }
};

struct ReferenceSettings {
  int dimension = 3;
  ReferenceSmoothing smoothing = ReferenceSmoothing::yang_liu;
  double smoothing_length = 1.0;
  double lattice_moment = 1.0;  ///< grad W is divided by it
  double viscosity_alpha = 0.0, viscosity_beta = 0.0;
  double hourglass_viscosity = 0.0;  ///< acts if `corrected`
  double spacing = 1.0;              ///< dx of F = W(r)/W(dx)
  double tension_exponent = 2.55;
  std::array<double, 3> gravity{};  ///< [m/s2]; for walls less the acceleration of the wall
  bool corrected = false;  ///< forces of T, gradients with H and the moment kept invertible
};

/// A sum with what its rounding is measured by.
struct ReferenceSum {
  double value = 0.0;
  double largest = 0.0;  ///< magnitude of its largest term

  void add(double term) {
    value += term;
    largest = std::fmax(largest, std::fabs(term));
  }
};

/// Rates of one soil particle; names as in PairSweepView.
struct ReferenceRate {
  int neighbours = 0;
  ReferenceSum density_rate;
  std::array<ReferenceSum, 9> velocity_gradient;
  std::array<ReferenceSum, 6> moment;
  double identity_share = 0.0;  ///< of the identity in it
  std::array<ReferenceSum, 3> acceleration;
  /// Largest term of the artificial stress, with 1 for a smaller F^n [m/s2].
  double largest_artificial = 0.0;
  double approach_rate = 0.0;
  std::array<ReferenceSum, 6> diffusion_rate;
  ReferenceSum diffusion_slope;
};

/// What a wall makes of a dummy.
struct ReferenceDummy {
  std::array<ReferenceSum, 3> velocity;      ///< [m/s]
  std::array<ReferenceSum, 6> stress;        ///< [Pa]
  std::array<ReferenceSum, 9> gradient;      ///< G_w/sum_k W_wk [m2/s, in 3D m3/s]; B5
  std::array<ReferenceSum, 9> force_stress;  ///< average of T and weight of the soil between [Pa]
  double weight = 0.0;                       ///< sum_k W_wk [1/m2, in 3D 1/m3]
  ReferenceSum height;                       ///< of the soil over the dummy along its normal [m]
  ReferenceSum overburden;                   ///< weight of the soil between, along the normal [Pa]
};

/// Rates of all soil particles; dummies come with their extrapolated velocity and stress. Equation:
/// E19, E20, E23, E24, E26, E27, D1, K1, K3, B5. Cost: O(N^2).
std::vector<ReferenceRate> pair_sweep_reference(const ReferenceParticles& particles,
                                                const ReferenceSettings& settings);

/// What all dummies take from the soil; they come with the velocity of their wall. Equation: B1,
/// B2, B5. Cost: O(N^2).
std::vector<ReferenceDummy> wall_sweep_reference(const ReferenceParticles& particles,
                                                 const ReferenceSettings& settings);

/// Positive part of the stress by its eigenvectors; in 2D of its in-plane block. Equation: E27.
std::array<double, 6> positive_part_reference(const std::array<double, 6>& stress, int dimension);

}  // namespace scarp::kernels
