// SPDX-License-Identifier: BSD-3-Clause
/// Plain scalar form of the stress pass.
#include "kernels/constitutive/stress_pass_reference.hpp"

#include <Eigen/Dense>
#include <cmath>

#include "kernels/constitutive/matrix_reference.hpp"

namespace scarp::kernels {
namespace {

using Matrix = Eigen::Matrix3d;

double contract(const Matrix& a, const Matrix& b) { return a.cwiseProduct(b).sum(); }
Matrix deviator(const Matrix& a) { return a - a.trace() / 3.0 * Matrix::Identity(); }

/// Velocity gradient over the moment, where that can be inverted. Equation: K1.
Matrix used_gradient(const ReferencePointRates& rates, const StressPassConstants& c,
                     int dimension) {
  Matrix l = matrix_of(rates.velocity_gradient), moment = matrix_of(rates.moment);
  if (dimension == 2) {
    l.row(2).setZero();
    l.col(2).setZero();
    moment.row(2) << 0.0, 0.0, 1.0;
    moment.col(2) << 0.0, 0.0, 1.0;
  }
  const double smallest =
      dimension == 2 ? smallest_moment_determinant<2> : smallest_moment_determinant<3>;
  return c.gradient_correction && moment.determinant() >= smallest ? Matrix(l * moment.inverse())
                                                                   : l;
}

/// Equation: D1; the lithostatic part removed along gravity (1) and across it (K0).
Matrix diffusion_increment(const ReferencePointRates& rates, const StressPassConstants& c,
                           double density) {
  if (c.diffusion_cap == 0.0) return Matrix::Zero();
  const Eigen::Vector3d g(c.gravity[0], c.gravity[1], c.gravity[2]);
  Matrix ratio = c.k0 * Matrix::Identity();
  if (g.norm() > 0.0) ratio += (1.0 - c.k0) * g.normalized() * g.normalized().transpose();
  return c.leap * (matrix_of(rates.diffusion_rate) + density * rates.diffusion_slope * ratio);
}

/// New stress and density from base values; updates strains and works of the point. Equation: E18,
/// E21.
bool advance_material(const ReferencePointRates& rates, const StressPassConstants& c, int dimension,
                      const ReferenceModel& model, const Matrix& base, double base_density,
                      ReferencePoint& point, Matrix& stress, double& density) {
  const Matrix current = matrix_of(point.stress);
  const Matrix gradient = used_gradient(rates, c, dimension);
  const Matrix strain = 0.5 * c.leap * (gradient + gradient.transpose());
  const Matrix spin = 0.5 * c.leap * (gradient - gradient.transpose());
  if (c.hughes_winget) {
    const Matrix turn =
        (Matrix::Identity() - 0.5 * spin).inverse() * (Matrix::Identity() + 0.5 * spin);
    stress = turn * base * turn.transpose();
  } else {
    stress = base + spin * current + current * spin.transpose();
  }
  const Matrix diffusion = diffusion_increment(rates, c, point.density);
  stress += hooke(model, strain) + diffusion;
  const Matrix trial = stress;
  std::array<double, 4> change{};
  if (model.come_back != nullptr)
    stress = matrix_of(model.come_back(c.model, array_of(trial), point, change));
  for (std::size_t h = 0; h < change.size(); ++h) point.history[h] += c.plastic_share * change[h];
  const Matrix mean = 0.5 / point.density * (base + stress);  // works are per mass
  point.stress_work += c.plastic_share * contract(mean, strain);
  point.plastic_work += c.plastic_share * contract(mean, strain_of(model, trial - stress));
  point.diffusion_work -= c.plastic_share * contract(mean, strain_of(model, diffusion));
  const Matrix shear_rate = deviator(0.5 * (gradient + gradient.transpose()));
  const double h = c.smoothing_length;
  const double sound_speed =
      std::sqrt((model.bulk_modulus + 4.0 / 3.0 * model.shear_modulus) / point.density);
  point.diffusivity =
      std::fmin(c.diffusion_cap * h * sound_speed,
                c.diffusion_shear_gate * h * h * std::sqrt(2.0 * shear_rate.squaredNorm()));
  if (!c.gradient_correction) {
    density = base_density + c.leap * rates.density_rate;
    return false;
  }
  const double free = base_density - point.density * strain.trace();
  density = std::fmin(std::fmax(free, c.density_minimum), c.density_maximum);
  return density != free;
}

}  // namespace

bool advance_verlet_reference(const ReferencePointRates& rates, const StressPassConstants& c,
                              const VerletConstants& v, int dimension, const ReferenceModel& model,
                              ReferencePoint& point) {
  const Matrix base = matrix_of(v.leaps ? point.previous_stress : point.stress);
  const double base_density = v.leaps ? point.previous_density : point.density;
  Matrix stress;
  double density = 0.0;
  const bool bounded =
      advance_material(rates, c, dimension, model, base, base_density, point, stress, density);
  for (int a = 0; a < dimension; ++a) {
    const double now = point.velocity[a];
    const double start = v.leaps ? point.previous_velocity[a] : now;
    const double pull = rates.acceleration[a] + c.gravity[a];
    point.position[a] += v.dt * now + 0.5 * v.dt * v.dt * (pull - v.damping * now);
    // (v_new - v_start)/leap = pull - c_d (v_new + v_start)/2
    point.velocity[a] =
        (start * (1.0 / c.leap - 0.5 * v.damping) + pull) / (1.0 / c.leap + 0.5 * v.damping);
    point.previous_velocity[a] = now;
  }
  point.previous_stress = point.stress;
  point.previous_density = point.density;
  point.stress = array_of(stress);
  point.density = density;
  return bounded;
}

bool advance_stress_reference(const ReferencePointRates& rates, const StressPassConstants& c,
                              int dimension, const ReferenceModel& model, ReferencePoint& point) {
  Matrix stress;
  double density = 0.0;
  const bool bounded = advance_material(rates, c, dimension, model, matrix_of(point.stress),
                                        point.density, point, stress, density);
  point.stress = array_of(stress);
  point.density = density;
  return bounded;
}

}  // namespace scarp::kernels
