// SPDX-License-Identifier: BSD-3-Clause
/// Paths, mixed control and samples of the element tests.
#include "engine/element/element_path.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "engine/element/material_point.hpp"
#include "engine/errors.hpp"
#include "engine/stop.hpp"

namespace scarp {
namespace {

/// What a path prescribes: rates over the whole test, and the normal directions held in stress.
struct PathControl {
  GradientIncrement total{};
  std::vector<std::size_t> held;
  bool plane = false;
};

PathControl control_of(const ElementTest& test) {
  switch (test.path) {
    case ElementPath::triaxial:
      return {{0, 0, 0, 0, -test.strain, 0, 0, 0, 0}, {0, 2}, false};
    case ElementPath::plane_strain:
      return {{0, 0, 0, 0, -test.strain, 0, 0, 0, 0}, {0}, true};
    case ElementPath::simple_shear:
      return {{0, test.strain, 0, 0, 0, 0, 0, 0, 0}, {1}, true};
    case ElementPath::isotropic:
      break;
  }
  const double each = -test.strain / 3.0;
  return {{each, 0, 0, 0, each, 0, 0, 0, each}, {}, false};
}

/// Meets `target` in the held normal stresses by their strain increments.
class StressControl {
 public:
  StressControl(const MaterialPoint& point, const PathControl& control, double target, int steps)
      : point_(point), held_(control.held), target_(target), increment_(control.total) {
    double largest = 0.0;
    for (double& part : increment_) {
      part /= steps;
      largest = std::fmax(largest, std::fabs(part));
    }
    probe_ = 1e-4 * largest;
    elastic_step_ = point.moduli().wave_modulus() * largest;
  }

  /// The next state; the increments found are the first guess of the next step.
  /// Newton's method with the tangent by differences: the response is piecewise smooth, with a kink
  /// where yield begins, at which the step is halved until the residual falls.
  PointState step(const PointState& from) {
    PointState to = point_.advance(from, increment_);
    for (int iteration = 0; iteration < most_iterations; ++iteration) {
      const Eigen::VectorXd residual = residual_of(to);
      const double norm = residual.size() == 0 ? 0.0 : residual.cwiseAbs().maxCoeff();
      if (norm <= tolerance(to)) {
        error_ = std::fmax(error_, norm);
        return to;
      }
      const Eigen::VectorXd change = -tangent(from, residual).fullPivLu().solve(residual);
      const GradientIncrement start = increment_;
      double share = 1.0;
      do {
        for (std::size_t k = 0; k < held_.size(); ++k) {
          increment_[4 * held_[k]] =
              start[4 * held_[k]] + share * change[static_cast<Eigen::Index>(k)];
        }
        to = point_.advance(from, increment_);
        share *= 0.5;
      } while (!(residual_of(to).cwiseAbs().maxCoeff() < norm) && share > 1e-3);
    }
    throw Error(
        fmt::format("no strain increment holds the stress at {:g} Pa. Try more steps.", target_));
  }

  double error() const { return error_; }

 private:
  static constexpr int most_iterations = 50;

  /// 1e-9 of the stresses at hand, a thousand times what rounding leaves of an increment of
  /// 1e-4 of the stress.
  double tolerance(const PointState& state) const {
    double scale = std::fmax(std::fabs(target_), elastic_step_);
    for (const double s : state.stress) scale = std::fmax(scale, std::fabs(s));
    return 1e-9 * scale;
  }
  Eigen::VectorXd residual_of(const PointState& state) const {
    Eigen::VectorXd residual(static_cast<Eigen::Index>(held_.size()));
    for (std::size_t k = 0; k < held_.size(); ++k) {
      residual[static_cast<Eigen::Index>(k)] = state.stress[held_[k]] - target_;
    }
    return residual;
  }
  Eigen::MatrixXd tangent(const PointState& from, const Eigen::VectorXd& residual) const {
    Eigen::MatrixXd slope(residual.size(), residual.size());
    for (std::size_t k = 0; k < held_.size(); ++k) {
      GradientIncrement moved = increment_;
      moved[4 * held_[k]] += probe_;
      slope.col(static_cast<Eigen::Index>(k)) =
          (residual_of(point_.advance(from, moved)) - residual) / probe_;
    }
    return slope;
  }

  const MaterialPoint& point_;
  std::vector<std::size_t> held_;
  double target_;
  GradientIncrement increment_;
  double probe_ = 0.0, elastic_step_ = 0.0, error_ = 0.0;
};

ElementSample sample_of(const MaterialPoint& point, const PointState& state,
                        const PointState& start) {
  ElementSample sample;
  sample.strain = state.strain;
  sample.stress = state.stress;
  sample.first_invariant = point.first_invariant(state);
  sample.root_j2 = point.root_j2(state);
  sample.yield_function = point.yield_function(state);
  sample.history = state.history;
  sample.volumetric_strain = state.strain[0] + state.strain[1] + state.strain[2];
  sample.plastic_volumetric_strain = point.plastic_volumetric_strain(state, start);
  return sample;
}

void check(const ElementTest& test) {
  if (!(test.confining_pressure >= 0.0) || !std::isfinite(test.confining_pressure)) {
    throw Error(fmt::format("confining pressure {:g} Pa: must be 0 or more, compression positive",
                            test.confining_pressure));
  }
  if (!(std::fabs(test.strain) > 0.0) || !(std::fabs(test.strain) <= 10.0)) {
    throw Error(fmt::format("strain {:g}: must be in -10 to 10 and not 0", test.strain));
  }
  constexpr int most_steps = 10'000'000;
  if (test.steps < 1 || test.steps > most_steps)
    throw Error(fmt::format("{} steps: must be 1 to {}", test.steps, most_steps));
  if (static_cast<std::size_t>(test.path) >= element_path_names.size())
    throw Error("element test: no such path");
}

}  // namespace

double deviator(const ElementSample& sample) {
  const auto& [xx, yy, zz, xy, yz, zx] = sample.stress;
  Eigen::Matrix3d stress;
  stress << xx, xy, zx, xy, yy, yz, zx, yz, zz;
  const Eigen::Vector3d principal =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(stress, Eigen::EigenvaluesOnly).eigenvalues();
  return principal[2] - principal[0];
}

ElementResult run_element(const Scene& scene, const ElementTest& test, const RunOptions& options) {
  validate(scene);
  check(test);
  const PathControl control = control_of(test);
  const int dimension = control.plane ? scene.dimension : 3;
  const MaterialPoint point(scene, test.material, dimension, options);
  const double start_stress = -test.confining_pressure;
  const PointState start = point.at({start_stress, start_stress, start_stress, 0.0, 0.0, 0.0});

  ElementResult result;
  result.dimension = dimension;
  result.isa = point.isa();
  result.plastic = point.model().yields;
  result.history = point.model().state_fields;
  result.constants = point.shown();
  result.bulk_modulus = point.moduli().bulk_modulus;
  result.shear_modulus = point.moduli().shear_modulus;
  result.samples.reserve(static_cast<std::size_t>(test.steps) + 1);
  result.samples.push_back(sample_of(point, start, start));
  StressControl stress_control(point, control, start_stress, test.steps);
  PointState state = start;
  for (int n = 1; n <= test.steps; ++n) {
    stop_if_asked(options.stop);
    try {
      state = stress_control.step(state);
    } catch (const Error& error) {
      throw Error(fmt::format("element test {}, step {} of {}: {}",
                              element_path_names[static_cast<std::size_t>(test.path)], n,
                              test.steps, error.what()));
    }
    result.samples.push_back(sample_of(point, state, start));
    if (result.first_yield == 0 && state.history != start.history) {
      result.first_yield = static_cast<std::size_t>(n);
    }
  }
  result.control_error = stress_control.error();
  return result;
}

}  // namespace scarp
