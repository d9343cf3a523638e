// SPDX-License-Identifier: BSD-3-Clause
/// Waves on a lattice under pressure.
#include "engine/check/lattice_growth.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "engine/particles/lattice_places.hpp"

namespace scarp {
namespace {

using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 3, 3>;
using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 3, 1>;

/// In spacings.
struct Neighbour {
  Vector place;
  Vector gradient;  ///< V grad W at the particle, of this neighbour's W
  Matrix second;    ///< V grad grad W
  Matrix damping;   ///< V |grad W| h r/(r^2 + 0.01 h^2) e e^T: of E26, over alpha c
};

/// d2W/dq2 without its normalisation.
double curvature(const kernels::SmoothingForm& form, double q) {
  const double b = std::max(2.0 - q, 0.0), a = std::max(1.0 - q, 0.0);
  return -b * (2.0 * form.derivative(0) +
               b * (3.0 * form.derivative(1) + b * 4.0 * form.derivative(2))) -
         2.0 * a * form.derivative(3);
}

std::vector<Neighbour> neighbours(const LoadedLattice& lattice) {
  const int d = lattice.dimension;
  const double h = lattice.smoothing_ratio;
  const kernels::SmoothingForm& form = *lattice.smoothing;
  const double volume = form.normalisation(d) / std::pow(h, d);
  std::vector<Neighbour> all;
  double moment = 0.0;
  for (const Site& offset : offsets_within(2.0 * h, d)) {
    const double r = length_of(offset);
    if (r >= 2.0 * h) continue;
    const double slope = volume * form.slope(r / h) / h,
                 bend = volume * curvature(form, r / h) / (h * h);
    Vector place(d);
    for (int a = 0; a < d; ++a) place[a] = static_cast<double>(offset[static_cast<std::size_t>(a)]);
    const Matrix along = place * place.transpose() / (r * r);
    moment -= r * slope / d;
    all.push_back({place, -slope / r * place,
                   bend * along + slope / r * (Matrix::Identity(d, d) - along),
                   -slope * h * r / (r * r + 0.01 * h * h) * along});
  }
  if (!lattice.normalised) return all;
  for (Neighbour& j : all) {
    j.gradient /= moment;
    j.second /= moment;
    j.damping /= moment;
  }
  return all;
}

Matrix stress_of(const LoadedLattice& lattice) {
  const int d = lattice.dimension;
  Vector down(d);
  for (int a = 0; a < d; ++a) down[a] = lattice.down[static_cast<std::size_t>(a)];
  return -lattice.pressure *
         (lattice.k0 * Matrix::Identity(d, d) + (1.0 - lattice.k0) * down * down.transpose());
}

}  // namespace

double growth_rate(const LoadedLattice& lattice) {
  const int d = lattice.dimension;
  const std::vector<Neighbour> all = neighbours(lattice);
  const double rho = lattice.inertia, dx = lattice.spacing;
  const double shear = lattice.shear_modulus / rho,  // squares of the speeds of sound
      bulk = (lattice.wave_modulus - lattice.shear_modulus) / rho;
  const double speed = std::sqrt(lattice.wave_modulus / rho);
  const Matrix pull = 2.0 / rho * stress_of(lattice);
  // E26 acts between particles that approach each other, half of the time.
  const double viscous = 0.5 * lattice.viscosity_alpha * speed / dx;
  constexpr int samples = 8;
  double fastest = 0.0;
  const auto look = [&](const Vector& wave) {
    Vector gradient = Vector::Zero(d);
    Matrix second = Matrix::Zero(d, d), damping = Matrix::Zero(d, d);
    for (const Neighbour& j : all) {
      const double phase = wave.dot(j.place), turn = 1.0 - std::cos(phase);
      gradient += std::sin(phase) * j.gradient;
      second += turn * j.second;
      damping += turn * j.damping;
    }
    // Acceleration over displacement, times dx^2.
    const Matrix change = pull * second - shear * gradient.squaredNorm() * Matrix::Identity(d, d) -
                          bulk * gradient * gradient.transpose();
    const Eigen::EigenSolver<Matrix> modes(change);
    for (int m = 0; m < d; ++m) {
      const double square = modes.eigenvalues()[m].real() / (dx * dx);
      if (!(square > 0.0)) continue;
      const Vector way = modes.eigenvectors().col(m).real().normalized();
      const double rate = 0.5 * viscous * way.dot(damping * way);
      fastest = std::max(fastest, std::sqrt(square + rate * rate) - rate);
    }
  };
  // Half a sample short of the edge of the zone: a wave of exactly two rows fits into no soil with
  // walls. Waves along -k are those along k.
  Vector wave(d);
  const auto sample = [](int s) { return std::numbers::pi * (s + 0.5) / samples; };
  for (int x = 0; x < samples; ++x) {
    wave[0] = sample(x);
    for (int y = -samples; y < samples; ++y) {
      wave[1] = sample(y);
      if (d == 2) look(wave);
      for (int z = -samples; d == 3 && z < samples; ++z) {
        wave[2] = sample(z);
        look(wave);
      }
    }
  }
  return fastest;
}

}  // namespace scarp
