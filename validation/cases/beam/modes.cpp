// SPDX-License-Identifier: BSD-3-Clause
/// Frequency equation and shape of the first bending modes.
#include "validation/cases/beam/modes.hpp"

#include <cmath>
#include <variant>

namespace scarp::validation {

Beam::Beam(double length_m, double depth_m, double reference_density, double youngs_modulus,
           double poisson_ratio)
    : length(length_m),
      depth(depth_m),
      density(reference_density),
      modulus(youngs_modulus / (1.0 - poisson_ratio * poisson_ratio)),
      shear_modulus(0.5 * youngs_modulus / (1.0 + poisson_ratio)),
      shear_factor(5.0 / (6.0 - poisson_ratio)) {}

Beam::Beam(const Scene& scene)
    : Beam(std::get<Box>(scene.bodies.front().shape).maximum[0] -
               std::get<Box>(scene.bodies.front().shape).minimum[0],
           std::get<Box>(scene.bodies.front().shape).maximum[1] -
               std::get<Box>(scene.bodies.front().shape).minimum[1],
           scene.materials.front().density,
           scene.materials.front().model.parameter("youngs_modulus"),
           scene.materials.front().model.parameter("poisson_ratio")) {}

double Beam::slender_frequency(double wave_number_times_length) const {
  const double k = wave_number_times_length / length;
  return k * k * std::sqrt(modulus * inertia() / (density * depth));
}

double Beam::sag(double gravity, double x) const {
  const double bending = depth * x * x * (6.0 * length * length - 4.0 * length * x + x * x) /
                         (24.0 * modulus * inertia()),
               shear = (length * x - 0.5 * x * x) / (shear_factor * shear_modulus);
  return density * gravity * (bending + shear);
}

BendingMode::Waves BendingMode::waves(const Beam& beam, double frequency) {
  const double square = frequency * frequency;
  const double stretch = beam.density * square / beam.modulus,
               shear = beam.density * square / (beam.shear_factor * beam.shear_modulus),
               radius = beam.inertia() / beam.depth;
  // k^4 - k^2 (stretch + shear) + stretch shear - stretch/radius = 0, one root k^2 above zero, a^2,
  // and one below, -b^2.
  const double half = 0.5 * (stretch + shear),
               root = std::sqrt(half * half - stretch * shear + stretch / radius);
  const double a = std::sqrt(half + root), b = std::sqrt(root - half);
  return {a, b, a - shear / a, b + shear / b, shear};
}

double BendingMode::residual(const Beam& beam, double frequency) {
  waves_ = waves(beam, frequency);
  const auto& [a, b, alpha, beta, shear] = waves_;
  if (support_ == Support::free_free) {
    const double l = 0.5 * beam.length;
    // The shear at the end, -shear (A sin(a l)/a + B sinh(b l)/b), vanishes by the choice of A, B.
    cosine_ = std::sinh(b * l) / b;
    cosh_ = -std::sin(a * l) / a;
    return -cosine_ * alpha * a * std::cos(a * l) + cosh_ * beta * b * std::cosh(b * l);
  }
  // W = A (cos - cosh) + C (sin - alpha/beta sinh) has W = psi = 0 at x = 0.
  const double l = beam.length, ratio = alpha / beta;
  const double moment_a = -alpha * a * std::cos(a * l) - beta * b * std::cosh(b * l),
               moment_c = -alpha * (a * std::sin(a * l) + b * std::sinh(b * l));
  const double shear_a = -std::sin(a * l) / a + std::sinh(b * l) / b,
               shear_c = std::cos(a * l) / a + ratio * std::cosh(b * l) / b;
  cosine_ = 1.0;
  cosh_ = -1.0;
  sine_ = -moment_a / moment_c;
  sinh_ = -ratio * sine_;
  return shear_a + sine_ * shear_c;
}

BendingMode::BendingMode(const Beam& beam, Support support) : support_(support) {
  // Shear and rotary inertia only lower the frequency, of a beam five depths long by less than a
  // third.
  const double slender =
      beam.slender_frequency(support == Support::free_free ? 4.730041 : 1.875104);
  double low = 0.5 * slender, high = slender;
  const double at_low = residual(beam, low);
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (low + high);
    (residual(beam, middle) * at_low > 0.0 ? low : high) = middle;
  }
  frequency_ = 0.5 * (low + high);
  residual(beam, frequency_);
  const double end = deflection(support == Support::free_free ? 0.5 * beam.length : beam.length);
  for (double* amplitude : {&cosine_, &sine_, &cosh_, &sinh_}) *amplitude /= end;
}

double BendingMode::deflection(double x) const {
  return cosine_ * std::cos(waves_.a * x) + sine_ * std::sin(waves_.a * x) +
         cosh_ * std::cosh(waves_.b * x) + sinh_ * std::sinh(waves_.b * x);
}

double BendingMode::rotation(double x) const {
  return waves_.alpha * (sine_ * std::cos(waves_.a * x) - cosine_ * std::sin(waves_.a * x)) +
         waves_.beta * (cosh_ * std::sinh(waves_.b * x) + sinh_ * std::cosh(waves_.b * x));
}

}  // namespace scarp::validation
