// SPDX-License-Identifier: BSD-3-Clause
/// The oracles of the models: returns found from flow rule and yield surfaces, not from closed
/// forms.
#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "kernels/constitutive/matrix_reference.hpp"
#include "kernels/constitutive/model_info.hpp"

namespace scarp::kernels {
namespace {

using Matrix = Eigen::Matrix3d;
using Vector = Eigen::Vector3d;

double contract(const Matrix& a, const Matrix& b) { return a.cwiseProduct(b).sum(); }
Matrix deviator(const Matrix& a) { return a - a.trace() / 3.0 * Matrix::Identity(); }
double root_j2(const Matrix& stress) { return std::sqrt(0.5 * deviator(stress).squaredNorm()); }
double equivalent(const Matrix& strain) {
  return std::sqrt(2.0 / 3.0 * deviator(strain).squaredNorm());
}
ReferenceModel elastic(const ElasticModuli& moduli) {
  return {moduli.bulk_modulus, moduli.shear_modulus, nullptr};
}

/// Cohesion and angles after the strain that a point has had. Equation: P4.
struct Strength {
  double cohesion, friction, dilation;  ///< [Pa, rad, rad]
};
Strength strength_of(const Softening& s, const ReferencePoint& point) {
  const double e = point.history[0];
  const double weight = s.linear ? std::fmax(0.0, 1.0 - s.rate * e) : std::exp(-s.rate * e);
  const double tangent = s.residual_friction * (1.0 - weight) + s.peak.friction * weight;
  const bool dilates = point.density > s.loosest_density;
  return {s.residual_cohesion * (1.0 - weight) + s.peak.cohesion * weight, std::atan(tangent),
          dilates ? std::atan(std::fmin(s.peak.dilation, tangent)) : 0.0};
}

/// df/dsigma or dg/dsigma of a cone: s/(2 sqrt(J2)) + alpha I.
Matrix cone_normal(const Matrix& stress, double alpha) {
  const double j = root_j2(stress);
  Matrix n = alpha * Matrix::Identity();
  if (j > 0.0) n += deviator(stress) / (2.0 * j);
  return n;
}

/// Flow along C : dg/dsigma until f = 0. On a cone neither gradient changes on the way, so one step
/// of Newton is exact; if it turned the deviator round, the way would cross the axis, so the apex
/// is the answer.
Matrix flow_back_to_cone(const ReferenceModel& m, const ConeConstants& c, const Matrix& trial) {
  const double f = root_j2(trial) + c.alpha_phi * trial.trace() - c.k_c;
  if (!(f > 0.0)) return trial;
  const Matrix direction = hooke(m, cone_normal(trial, c.alpha_psi));
  const double multiplier = f / contract(cone_normal(trial, c.alpha_phi), direction);
  const Matrix stress = trial - multiplier * direction;
  if (contract(deviator(stress), deviator(trial)) >= 0.0 && root_j2(trial) > 0.0) return stress;
  if (c.alpha_phi == 0.0) return trial.trace() / 3.0 * Matrix::Identity();
  return c.k_c / (3.0 * c.alpha_phi) * Matrix::Identity();
}

ReferenceMatrix drucker_prager(const ModelConstants& all, const ReferenceMatrix& trial,
                               const ReferencePoint& point, std::array<double, 4>& change) {
  const auto c = unpacked<DruckerPrager::Constants>(all);
  ConeConstants cone = c.cone;
  if (c.softening.acts) {
    const Strength s = strength_of(c.softening, point);
    cone = cone_constants({s.cohesion, s.friction, s.dilation}, c.match);
  }
  const ReferenceModel moduli = elastic(c.elastic);
  const Matrix from = matrix_of(trial), stress = flow_back_to_cone(moduli, cone, from);
  change[0] = equivalent(strain_of(moduli, from - stress));
  return array_of(stress);
}

/// A plane n.s = strength of the yield surface in principal stresses, and its flow.
struct Plane {
  Vector normal, flow;
  double strength;
};

/// Coulomb's planes and the cut-off's, of s1 >= s2 >= s3.
std::vector<Plane> planes_of(const Strength& s, const double* tensile_strength) {
  std::vector<Plane> planes;
  const double f = std::sin(s.friction), d = std::sin(s.dilation);
  for (const auto& [i, j] : {std::pair{0, 2}, {0, 1}, {1, 2}}) {
    Plane plane{Vector::Zero(), Vector::Zero(), 2.0 * s.cohesion * std::cos(s.friction)};
    plane.normal[i] = 1.0 + f;
    plane.normal[j] = f - 1.0;
    plane.flow[i] = 1.0 + d;
    plane.flow[j] = d - 1.0;
    planes.push_back(plane);
  }
  for (int i = 0; tensile_strength != nullptr && i < 3; ++i)
    planes.push_back({Vector::Unit(i), Vector::Unit(i), *tensile_strength});
  return planes;
}

/// The stress that is reached by flow of some of the planes alone, with no negative multiplier, and
/// is outside none.
std::optional<Vector> flow_of(const std::vector<Plane>& planes, unsigned acting,
                              const Matrix& stiffness, const Vector& trial) {
  std::vector<const Plane*> some;
  for (std::size_t k = 0; k < planes.size(); ++k) {
    if ((acting >> k & 1u) != 0) some.push_back(&planes[k]);
  }
  const auto count = static_cast<Eigen::Index>(some.size());
  if (count > 3) return {};
  const double scale = trial.cwiseAbs().maxCoeff() + 1.0;
  Eigen::MatrixXd slope(count, count);
  Eigen::VectorXd excess(count);
  for (Eigen::Index a = 0; a < count; ++a) {
    const Plane& plane = *some[static_cast<std::size_t>(a)];
    excess[a] = plane.normal.dot(trial) - plane.strength;
    for (Eigen::Index b = 0; b < count; ++b)
      slope(a, b) = plane.normal.dot(stiffness * some[static_cast<std::size_t>(b)]->flow);
  }
  Vector stress = trial;
  if (count > 0) {
    Eigen::FullPivLU<Eigen::MatrixXd> solver(slope);
    solver.setThreshold(1e-9);
    if (!solver.isInvertible()) return {};
    const Eigen::VectorXd multiplier = solver.solve(excess);
    if (multiplier.minCoeff() < 0.0) return {};
    for (Eigen::Index a = 0; a < count; ++a)
      stress -= multiplier[a] * (stiffness * some[static_cast<std::size_t>(a)]->flow);
  }
  const double slack = 1e-10 * scale;
  if (stress[0] < stress[1] - slack || stress[1] < stress[2] - slack) return {};
  for (const Plane& plane : planes) {
    if (plane.normal.dot(stress) > plane.strength + slack) return {};
  }
  return stress;
}

/// Every set of planes is tried, few before many; where none answers, the apex does.
Vector flow_back_to_coulomb(const ReferenceModel& m, const Strength& s,
                            const double* tensile_strength, const Vector& trial) {
  const double lame = m.bulk_modulus - 2.0 / 3.0 * m.shear_modulus;
  const Matrix stiffness =
      Matrix::Constant(lame) + 2.0 * m.shear_modulus * Matrix(Matrix::Identity());
  const std::vector<Plane> planes = planes_of(s, tensile_strength);
  for (int size = 0; size <= 3; ++size) {
    for (unsigned acting = 0; acting < 1u << planes.size(); ++acting) {
      if (__builtin_popcount(acting) != size) continue;
      if (const auto found = flow_of(planes, acting, stiffness, trial)) return *found;
    }
  }
  const double apex = s.friction > 0.0 ? s.cohesion / std::tan(s.friction) : trial.mean();
  return Vector::Constant(tensile_strength != nullptr ? std::fmin(apex, *tensile_strength) : apex);
}

ReferenceMatrix mohr_coulomb(const ModelConstants& all, const ReferenceMatrix& trial,
                             const ReferencePoint& point, std::array<double, 4>& change) {
  const auto c = unpacked<MohrCoulomb::Constants>(all);
  Strength s{0.5 * c.surface.twice_c_cosine / std::sqrt(1.0 - c.surface.sine * c.surface.sine),
             std::asin(c.surface.sine), std::asin(c.surface.dilation)};
  if (c.softening.acts) s = strength_of(c.softening, point);
  const ReferenceModel moduli = elastic(c.elastic);
  const Matrix from = matrix_of(trial);
  const Eigen::SelfAdjointEigenSolver<Matrix> solver(from);
  const Matrix axes = solver.eigenvectors().rowwise().reverse();
  const Vector back = flow_back_to_coulomb(
      moduli, s, c.cut_off ? &c.surface.tensile_strength : nullptr, solver.eigenvalues().reverse());
  const Matrix stress = axes * back.asDiagonal() * axes.transpose();
  change[0] = equivalent(strain_of(moduli, from - stress));
  return array_of(stress);
}

}  // namespace

ReferenceModel reference_model(std::string_view name, const ModelConstants& constants) {
  ReferenceModel model = elastic(model_named(name)->moduli(constants));
  if (name == DruckerPrager::name) model.come_back = &drucker_prager;
  if (name == MohrCoulomb::name) model.come_back = &mohr_coulomb;
  return model;
}

}  // namespace scarp::kernels
