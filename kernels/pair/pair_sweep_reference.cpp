// SPDX-License-Identifier: BSD-3-Clause
/// Plain scalar form of all pair terms.
#include "kernels/pair/pair_sweep_reference.hpp"

#include <Eigen/Dense>
#include <algorithm>

#include "kernels/particle_view.hpp"

namespace scarp::kernels {
namespace {

using Vector = Eigen::Vector3d;
using Matrix = Eigen::Matrix3d;

Vector vector_of(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }

Matrix matrix_of(const std::array<double, 6>& s) {
  Matrix m;
  m << s[0], s[3], s[5], s[3], s[1], s[4], s[5], s[4], s[2];
  return m;
}

Matrix matrix_of(const std::array<double, 9>& t) {
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(t.data());
}

constexpr int row[6] = {0, 1, 2, 0, 1, 2}, column[6] = {0, 1, 2, 1, 2, 0};

/// Pi of Eq. 26 and, if the pair approaches, -mu.
double viscosity(const ReferenceParticles& p, const ReferenceSettings& s, std::size_t i,
                 std::size_t j, const Vector& velocity, const Vector& distance,
                 double& approach_rate) {
  const double approach = velocity.dot(distance);
  approach_rate = 0.0;
  if (approach >= 0.0) return 0.0;
  const double h = s.smoothing_length;
  const double mu = h * approach / (distance.squaredNorm() + 0.01 * h * h);
  approach_rate = -mu;
  const double mean_density = 0.5 * (p.density[i] + p.density[j]);
  const double mean_sound_speed = 0.5 * (p.sound_speed[i] + p.sound_speed[j]);
  return (-s.viscosity_alpha * mean_sound_speed * mu + s.viscosity_beta * mu * mu) / mean_density;
}

/// Equation: V1; what takes the place of -Pi.
double hourglass_viscosity(const ReferenceParticles& p, const ReferenceSettings& s, std::size_t i,
                           std::size_t j, const Vector& velocity, const Vector& distance) {
  if (!s.corrected || p.is_wall(j)) return 0.0;
  const double h = s.smoothing_length;
  const Matrix mean = 0.5 * (matrix_of(p.strain_rate[i]) + matrix_of(p.strain_rate[j]));
  const double unseen = velocity.dot(distance) - distance.dot(mean * distance);
  const double mean_density = 0.5 * (p.density[i] + p.density[j]);
  const double mean_sound_speed = 0.5 * (p.sound_speed[i] + p.sound_speed[j]);
  return s.hourglass_viscosity * mean_sound_speed * h * unseen /
         ((distance.squaredNorm() + 0.01 * h * h) * mean_density);
}

void add_gradients(const ReferenceParticles& p, const ReferenceSettings& s, std::size_t j,
                   const Vector& velocity, const Vector& distance, const Vector& gradient,
                   ReferenceRate& rate) {
  const double mass = p.volume[j] * p.density[j];
  for (int a = 0; a < s.dimension; ++a) {
    rate.density_rate.add(mass * velocity(a) * gradient(a));
    for (int b = 0; b < s.dimension; ++b) {
      rate.velocity_gradient[3 * a + b].add(p.volume[j] * -velocity(a) * gradient(b));
    }
  }
  for (int c = 0; c < 6; ++c) {
    rate.moment[c].add(p.volume[j] * -distance(row[c]) * gradient(column[c]));
  }
}

void add_forces(const ReferenceParticles& p, const ReferenceSettings& s, std::size_t i,
                std::size_t j, const Vector& velocity, const Vector& distance,
                const Vector& gradient, ReferenceRate& rate) {
  if (p.volume[j] == 0.0) return;  // an inner point of a wall
  const double mass = p.volume[j] * p.density[j];
  double approach_rate = 0.0;
  const double pi = viscosity(p, s, i, j, velocity, distance, approach_rate);
  rate.approach_rate = std::fmax(rate.approach_rate, approach_rate);
  const double f =
      smoothing_value_reference(s.smoothing, s.dimension, distance.norm(), s.smoothing_length) /
      smoothing_value_reference(s.smoothing, s.dimension, s.spacing, s.smoothing_length);
  const double weight = std::pow(f, s.tension_exponent);
  const Matrix artificial_i = matrix_of(p.artificial_stress[i]);
  const Matrix artificial_j = matrix_of(p.artificial_stress[j]);
  const auto force_stress = [&](std::size_t k) {
    return s.corrected ? matrix_of(p.force_stress[k]) : matrix_of(p.stress[k]);
  };
  const double hourglass = hourglass_viscosity(p, s, i, j, velocity, distance);
  const Matrix stress_i = force_stress(i), stress_j = force_stress(j);
  for (int a = 0; a < s.dimension; ++a) {
    ReferenceSum& sum = rate.acceleration[a];
    for (int b = 0; b < s.dimension; ++b) {
      sum.add(mass * stress_i(a, b) / (p.density[i] * p.density[j]) * gradient(b));
      sum.add(mass * stress_j(a, b) / (p.density[i] * p.density[j]) * gradient(b));
      for (const double r : {artificial_i(a, b), artificial_j(a, b)}) {
        sum.add(mass * weight * r * gradient(b));
        rate.largest_artificial = std::fmax(
            rate.largest_artificial, std::fmax(1.0, weight) * std::fabs(mass * r * gradient(b)));
      }
    }
    sum.add(-mass * pi * gradient(a));
    sum.add(mass * hourglass * gradient(a));
  }
}

void add_diffusion(const ReferenceParticles& p, const ReferenceSettings& s, std::size_t i,
                   std::size_t j, const Vector& distance, const Vector& gradient,
                   ReferenceRate& rate) {
  if (!p.material.empty() && p.material[i] != p.material[j]) return;
  const double h = s.smoothing_length;
  const double mean = 0.5 * (p.diffusivity[i] + p.diffusivity[j]);
  const double weight =
      2.0 * p.volume[j] * mean * distance.dot(gradient) / (distance.squaredNorm() + 0.01 * h * h);
  for (int c = 0; c < 6; ++c) {
    rate.diffusion_rate[c].add(weight * p.stress[i][c]);
    rate.diffusion_rate[c].add(-weight * p.stress[j][c]);
  }
  for (int a = 0; a < s.dimension; ++a)
    rate.diffusion_slope.add(weight * s.gravity[a] * distance(a));
}

/// Keeps the moment invertible and adds to the velocity gradient what the walls do. Equation: K1,
/// B5.
void complete_gradients(const ReferenceParticles& p, const ReferenceSettings& s, std::size_t i,
                        ReferenceRate& rate) {
  const int d = s.dimension;
  Matrix moment = Matrix::Identity();
  for (int c = 0; c < 6; ++c) {
    if (row[c] < d && column[c] < d)
      moment(row[c], column[c]) = moment(column[c], row[c]) = rate.moment[c].value;
  }
  const double least = d == 2 ? smallest_moment_determinant<2> : smallest_moment_determinant<3>;
  rate.identity_share = std::clamp((least - moment.determinant()) / (0.5 * least), 0.0, 1.0);
  moment += rate.identity_share * (Matrix::Identity() - moment);
  for (int c = 0; c < 6; ++c) {
    rate.moment[c].value = moment(row[c], column[c]);
    rate.moment[c].largest = std::fmax(rate.moment[c].largest, rate.identity_share);
  }
  Matrix sum = Matrix::Zero();
  double largest = 0.0;
  for (std::size_t w = p.soil_count; w < p.soil_count + p.wall_count; ++w) {
    const double r = (vector_of(p.position[i]) - vector_of(p.position[w])).norm();
    const double weight =
        smoothing_value_reference(s.smoothing, d, r, s.smoothing_length) / p.volume[i];
    const Matrix term = weight * matrix_of(p.wall_gradient[w]);
    sum += term;
    largest = std::fmax(largest, term.cwiseAbs().maxCoeff());
  }
  for (int a = 0; a < d; ++a) {
    for (int b = 0; b < d; ++b) {
      ReferenceSum& component = rate.velocity_gradient[3 * a + b];
      component.value += sum(a, b);
      component.largest = std::fmax(component.largest, largest);
    }
  }
}

}  // namespace

std::vector<ReferenceRate> pair_sweep_reference(const ReferenceParticles& p,
                                                const ReferenceSettings& s) {
  const double h = s.smoothing_length;
  std::vector<ReferenceRate> rates(p.soil_count);
  for (std::size_t i = 0; i < p.soil_count; ++i) {
    ReferenceRate& rate = rates[i];
    for (std::size_t j = 0; j < p.size(); ++j) {
      const Vector distance = vector_of(p.position[i]) - vector_of(p.position[j]);
      const double r = distance.norm();
      if (j == i || r >= 2.0 * h) continue;
      ++rate.neighbours;
      const Vector gradient = smoothing_slope_reference(s.smoothing, s.dimension, r, h) /
                              (r * s.lattice_moment) * distance;
      const Vector velocity = vector_of(p.velocity[i]) - vector_of(p.velocity[j]);
      add_gradients(p, s, j, velocity, distance, gradient, rate);
      add_forces(p, s, i, j, velocity, distance, gradient, rate);
      if (!p.is_wall(j)) add_diffusion(p, s, i, j, distance, gradient, rate);
    }
    if (s.corrected) complete_gradients(p, s, i, rate);
  }
  return rates;
}

std::vector<ReferenceDummy> wall_sweep_reference(const ReferenceParticles& p,
                                                 const ReferenceSettings& s) {
  std::vector<ReferenceDummy> dummies(p.wall_count);
  for (std::size_t w = p.soil_count; w < p.soil_count + p.wall_count; ++w) {
    ReferenceDummy& dummy = dummies[w - p.soil_count];
    double weights = 0.0, before = 0.0;
    std::array<ReferenceSum, 3> slip;
    for (std::size_t j = 0; j < p.size(); ++j) {
      if (p.is_wall(j)) continue;
      const Vector distance = vector_of(p.position[w]) - vector_of(p.position[j]);
      const double weight =
          smoothing_value_reference(s.smoothing, s.dimension, distance.norm(), s.smoothing_length);
      weights += weight;
      before -= weight * (distance.dot(vector_of(p.face[w].normal)) + p.face[w].distance);
      for (int a = 0; a < 3; ++a) slip[a].add(weight * (p.velocity[j][a] - p.velocity[w][a]));
      const double lithostatic = p.density[j] * vector_of(s.gravity).dot(distance);
      const double r = distance.norm();
      const double slope =
          r < 2.0 * s.smoothing_length
              ? smoothing_slope_reference(s.smoothing, s.dimension, r, s.smoothing_length) /
                    (r * s.lattice_moment)
              : 0.0;
      const Vector normal = vector_of(p.face[w].normal);
      const double upright = p.density[j] * vector_of(s.gravity).dot(normal) * distance.dot(normal);
      dummy.height.add(-weight * distance.dot(normal));
      dummy.overburden.add(-weight * upright);
      for (std::size_t a = 0; a < 3; ++a) {
        for (std::size_t b = 0; b < 3; ++b) {
          // grad_j W_jw points along x_j - x_w.
          dummy.gradient[3 * a + b].add(p.volume[j] * (p.velocity[w][a] - p.velocity[j][a]) *
                                        slope * -distance(static_cast<int>(b)));
          dummy.force_stress[3 * a + b].add(weight * p.force_stress[j][3 * a + b]);
          if (a == b) dummy.force_stress[3 * a + b].add(-weight * lithostatic);
        }
      }
      for (int c = 0; c < 6; ++c) {
        dummy.stress[c].add(weight * p.stress[j][c]);
        if (c < 3) dummy.stress[c].add(-weight * lithostatic);
      }
    }
    const double scale = weights > 0.0 ? 1.0 / weights : 0.0;
    const auto divide = [scale](auto& sums) {
      for (ReferenceSum& component : sums) {
        component.value *= scale;
        component.largest *= scale;
      }
    };
    dummy.weight = weights;
    for (ReferenceSum* sum : {&dummy.height, &dummy.overburden}) {
      sum->value *= scale;
      sum->largest *= scale;
    }
    divide(dummy.stress);
    divide(dummy.gradient);
    divide(dummy.force_stress);
    const double height = before * scale;
    const ReferenceFace& face = p.face[w];
    const double ratio = height > 0.0 ? std::fmin(face.limit, face.distance / height) : face.limit;
    for (int a = 0; a < 3; ++a) {
      dummy.velocity[a] = {p.velocity[w][a] - ratio * scale * slip[a].value,
                           std::fabs(p.velocity[w][a]) + ratio * scale * slip[a].largest};
    }
  }
  return dummies;
}

std::array<double, 6> positive_part_reference(const std::array<double, 6>& stress, int dimension) {
  std::array<double, 6> s = stress;
  if (dimension == 2) s[2] = s[4] = s[5] = 0.0;
  const Eigen::SelfAdjointEigenSolver<Matrix> eigen(matrix_of(s));
  const Matrix positive = eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0.0).asDiagonal() *
                          eigen.eigenvectors().transpose();
  std::array<double, 6> part{};
  for (int c = 0; c < 6; ++c) part[c] = positive(row[c], column[c]);
  return part;
}

}  // namespace scarp::kernels
