// SPDX-License-Identifier: BSD-3-Clause
/// First bending modes of Timoshenko's beam in plane strain.
#pragma once

#include "engine/scene/scene.hpp"

namespace scarp::validation {

/// A beam of unit thickness along x, in plane strain: E' = E/(1 - nu^2), and Cowper's shear factor
/// of a rectangle, 5 (1 + nu')/(6 + 5 nu') in plane stress (Kaneko 1975), which is 5/(6 - nu) with
/// nu' = nu/(1 - nu).
struct Beam {
  double length = 1.0, depth = 1.0;  ///< [m]
  double density = 1.0;              ///< [kg/m3]
  double modulus = 1.0;              ///< E' [Pa]
  double shear_modulus = 1.0;        ///< G [Pa]
  double shear_factor = 1.0;         ///< [-]

  /// Of the scene's first body, a box along x, and first material.
  explicit Beam(const Scene& scene);
  Beam(double length_m, double depth_m, double reference_density, double youngs_modulus,
       double poisson_ratio);

  double inertia() const { return depth * depth * depth / 12.0; }  ///< I [m3]
  /// Of Euler and Bernoulli: (k L)^2 sqrt(E' I/(rho D L^4)) [1/s]
  double slender_frequency(double wave_number_times_length) const;
  /// Deflection under its own weight of a beam clamped at x = 0: rho g D x^2 (6 L^2 - 4 L x +
  /// x^2)/(24 E' I) + rho g (L x - x^2/2)/(kappa G) [m].
  double sag(double gravity, double x) const;
};

enum class Support { free_free, clamped_free };

/// The first mode, deflection 1 at its end x = L (free: x = L/2, from the middle).
/// kappa G (W'' - psi') + rho w^2 W = 0, E' I psi'' + kappa G D (W' - psi) + rho w^2 I psi = 0;
/// free ends have psi' = 0 and W' = psi, a clamped one W = 0 and psi = 0.
class BendingMode {
 public:
  BendingMode(const Beam& beam, Support support);
  double frequency() const { return frequency_; }  ///< circular [1/s]
  double deflection(double x) const;               ///< W [-]
  double rotation(double x) const;                 ///< psi [1/m]

 private:
  struct Waves {
    double a, b;         ///< W = cos(a x), sin(a x), cosh(b x), sinh(b x) [1/m]
    double alpha, beta;  ///< their psi over W of the quarter before or after [1/m]
    double shear;        ///< rho w^2/(kappa G) [1/m2]
  };
  static Waves waves(const Beam& beam, double frequency);
  /// Left side of the frequency equation; sets the four amplitudes.
  double residual(const Beam& beam, double frequency);

  Support support_;
  double frequency_ = 0.0;
  Waves waves_{};
  double cosine_ = 0.0, sine_ = 0.0, cosh_ = 0.0, sinh_ = 0.0;
};

}  // namespace scarp::validation
