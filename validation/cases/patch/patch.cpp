// SPDX-License-Identifier: BSD-3-Clause
/// Sums over a free block against what they must give for a linear field and a uniform stress.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "validation/case_list.hpp"
#include "validation/convergence.hpp"
#include "validation/extruded.hpp"

namespace scarp::validation {
namespace {

using Symmetric = std::array<double, 6>;  ///< xx, yy, zz, xy, yz, zx

/// The scene's velocity field as a gradient L; it has a spin, which must not show as strain.
constexpr double gradient[2][2] = {{0.3, -0.5}, {0.9, -0.2}};
constexpr double gradient_in_z = 0.4;  ///< dw/dz, in 3D
/// Wave number of the curved field [1/m] and its amplitude [m/s].
constexpr double curved_wave_number = 1.5, curved_amplitude = 0.1;
/// Compression with shear [Pa]: no principal stress is tensile, so no artificial stress acts.
constexpr Symmetric uniform{-80e3, -120e3, -60e3, 30e3, 0.0, 0.0};

/// C : e of the isotropic elastic soil.
Symmetric elastic_rate(const Material& soil, const Symmetric& rate) {
  const double youngs = soil.model.parameter("youngs_modulus"),
               poisson = soil.model.parameter("poisson_ratio");
  const double shear = youngs / (2.0 * (1.0 + poisson));
  const double lame = youngs * poisson / ((1.0 + poisson) * (1.0 - 2.0 * poisson));
  Symmetric stress{};
  for (std::size_t c = 0; c < 6; ++c) stress[c] = 2.0 * shear * rate[c];
  for (std::size_t c = 0; c < 3; ++c) stress[c] += lame * (rate[0] + rate[1] + rate[2]);
  return stress;
}

Symmetric linear_strain_rate(const Vec3&, int dimension) {
  return {gradient[0][0],
          gradient[1][1],
          dimension == 3 ? gradient_in_z : 0.0,
          0.5 * (gradient[0][1] + gradient[1][0]),
          0.0,
          0.0};
}

/// Of v = a (sin(k x) cos(k y), 0.5 cos(k x), 0).
Symmetric curved_strain_rate(const Vec3& at, int) {
  const double k = curved_wave_number, a = curved_amplitude;
  const double x = k * at[0], y = k * at[1];
  return {a * k * std::cos(x) * std::cos(y),
          0.0,
          0.0,
          0.5 * a * k * (-std::sin(x) * std::sin(y) - 0.5 * std::sin(x)),
          0.0,
          0.0};
}

enum class Place { inside, face, edge };

/// Largest errors at each place.
struct Errors {
  double inside = 0.0, face = 0.0, edge = 0.0;
  void note(Place place, double error) {
    double& largest = place == Place::inside ? inside : place == Place::face ? face : edge;
    largest = std::fmax(largest, error);
  }
};

/// Inside is farther than so many supports, 2h, from every face. Edges are a class of their own in
/// 3D only, two particles wide.
Place place_of(const Simulation& simulation, const Vec3& at, double supports) {
  const Box& box = std::get<Box>(simulation.scene().bodies.front().shape);
  const double reach = supports * 2.0 * simulation.smoothing_length();
  bool inside = true;
  int faces = 0;
  for (std::size_t a = 0; a < static_cast<std::size_t>(simulation.scene().dimension); ++a) {
    const double depth = std::fmin(at[a] - box.minimum[a], box.maximum[a] - at[a]);
    inside = inside && depth >= reach;
    faces += depth < 2.0 * simulation.scene().spacing;
  }
  if (inside) return Place::inside;
  return simulation.scene().dimension == 3 && faces >= 2 ? Place::edge : Place::face;
}

/// Stress of one step from zero over the step is C : e, so it shows the strain rate the sweep
/// found; relative to the largest component there is.
Errors strain_rate_errors(const Simulation& stepped, Symmetric (*exact)(const Vec3&, int)) {
  const Scene& scene = stepped.scene();
  const std::vector<double> position = stepped.field("position"), stress = stepped.field("stress");
  const double step = stepped.last_step().time_step;
  double largest = 0.0;
  Errors errors;
  for (std::size_t i = 0; i < stepped.soil_count(); ++i) {
    const Vec3 at{position[3 * i], position[3 * i + 1], position[3 * i + 2]};
    const Symmetric rate = elastic_rate(scene.materials.front(), exact(at, scene.dimension));
    double error = 0.0;
    for (std::size_t c = 0; c < 6; ++c) {
      largest = std::fmax(largest, std::fabs(rate[c]));
      error = std::fmax(error, std::fabs(stress[6 * i + c] / step - rate[c]));
    }
    errors.note(place_of(stepped, at, 1.0), error);
  }
  return {errors.inside / largest, errors.face / largest, errors.edge / largest};
}

/// Acceleration of soil under uniform stress, velocity over the one step, in units of the largest
/// stress over rho dx. A corrected force reads the moments of the neighbours, which know of a face
/// one support further in.
Errors acceleration_errors(const Simulation& stepped) {
  const Scene& scene = stepped.scene();
  const std::vector<double> position = stepped.field("position"),
                            velocity = stepped.field("velocity");
  const double unit =
      120e3 / (scene.materials.front().density * scene.spacing) * stepped.last_step().time_step;
  const Numerics& n = scene.numerics;
  const double supports = n.corrects_force() ? 2.0 : 1.0;
  Errors errors;
  for (std::size_t k = 0; k < velocity.size(); k += 3) {
    const Vec3 at{position[k], position[k + 1], position[k + 2]};
    errors.note(place_of(stepped, at, supports),
                std::hypot(velocity[k], velocity[k + 1], velocity[k + 2]) / unit);
  }
  return errors;
}

Scene linear_scene(CaseRun& run, double spacing, const std::string& preset, int dimension) {
  Scene scene = run.scene_at(spacing, preset);
  if (dimension == 2) return scene;
  // As deep as 14 spacings: eight layers are farther than a support of 3, at h = 1.5 dx, from both
  // ends.
  scene = extruded(std::move(scene), 14.0 * spacing);
  scene.bodies.front().velocity_field[2] = fmt::format("{}*z", gradient_in_z);
  return scene;
}

Scene curved(Scene scene) {
  auto& field = scene.bodies.front().velocity_field;
  field[0] = fmt::format("{}*sin({}*x)*cos({}*y)", curved_amplitude, curved_wave_number,
                         curved_wave_number);
  field[1] = fmt::format("{}*cos({}*x)", 0.5 * curved_amplitude, curved_wave_number);
  if (field.size() == 3) field[2] = fmt::format("{}", 0);
  return scene;
}

Scene stressed(Scene scene) {
  scene.bodies.front().velocity_field.clear();
  scene.initial_stress = InitialStress::uniform;
  scene.uniform_stress = uniform;
  return scene;
}

/// Coordinates are up to `size` spacings, so a difference of two is good to eps times that, and a
/// sum has at most 146 terms of one sign; the inverse moment of a corner multiplies it by about 10.
double round_off(const Scene& scene) {
  const double size = std::get<Box>(scene.bodies.front().shape).maximum[0] / scene.spacing;
  return 10.0 * 146.0 * size * std::numeric_limits<double>::epsilon();
}

struct Series {
  std::vector<ErrorAtSpacing> inside, face;
  double edge = 0.0;  ///< at the finest spacing
  void add(double spacing, const Errors& errors) {
    inside.push_back({spacing, errors.inside});
    face.push_back({spacing, errors.face});
    edge = errors.edge;
  }
};

void report(CaseRun& run, const std::string& quantity, const std::vector<ErrorAtSpacing>& errors,
            const std::string& remark) {
  for (const ErrorAtSpacing& one : errors) {
    run.add(reported(fmt::format("{}, dx = {} m", quantity, one.spacing), one.error, "", remark));
  }
  run.add({quantity, errors, observed_order(errors)});
}

void judge(CaseRun& run, const std::string& who, const Simulation& last, const Series& linear,
           const Series& bent, const Series& stress) {
  const Numerics& n = last.scene().numerics;
  const double exact = round_off(last.scene()), moment = last.lattice_moment();
  const double lattice = n.lattice_normalisation || n.gradient_correction ? 0.0 : 1.0 - moment;
  run.add(within(who + "linear field, strain rate inside", linear.inside.back().error, "", lattice,
                 lattice - exact, lattice + exact,
                 lattice == 0.0 ? "round-off" : "1 - M to round-off"));
  const std::string at_surface = who + "linear field, strain rate near the faces";
  if (n.gradient_correction) {
    run.add(within(at_surface, linear.face.back().error, "", 0.0, 0.0, exact,
                   "round-off: the gradient is corrected up to the surface"));
    if (last.scene().dimension == 3) {
      run.add(reported(who + "linear field, strain rate near the edges", linear.edge, "",
                       "where the moment is below 0.1 the plain gradient is kept"));
    }
    // Interior sums are symmetric: second order, with a leading error (k s)^2, s^2 the second
    // moment of the weights, s < h/sqrt(2) as they vanish at 2h. Surface sums are one-sided: first
    // order.
    const double kh = curved_wave_number * last.smoothing_length();
    judge_convergence(run, who + "curved field, strain rate inside", bent.inside,
                      {0.5 * kh * kh, 1.8, "second order: (k h)^2/2"});
    judge_convergence(run, who + "curved field, strain rate near the faces", bent.face,
                      {kh, 0.9, "first order: k h"});
  } else {
    report(run, at_surface, linear.face, "missing neighbours: does not converge");
    report(run, who + "curved field, strain rate inside", bent.inside, "1 - M does not converge");
    report(run, who + "curved field, strain rate near the faces", bent.face,
           "missing neighbours: does not converge");
  }
  run.add(within(who + "uniform stress, acceleration inside over s/(rho dx)",
                 stress.inside.back().error, "", 0.0, 0.0, exact,
                 "round-off: the lattice is symmetric"));
  report(run, who + "uniform stress, acceleration near the faces over s/(rho dx)", stress.face,
         "the unbalanced traction of a free face, of the order of 1");
}

}  // namespace

void patch(CaseRun& run) {
  const std::vector<double> spacings = run.spacings({0.1, 0.05, 0.025});
  std::optional<Simulation> last;
  for (const std::string& preset : run.presets()) {
    for (const int dimension : {2, 3}) {
      const std::string who = fmt::format("{} {}D: ", preset, dimension);
      Series linear, bent, stress;
      for (const double spacing : spacings) {
        const Scene scene = linear_scene(run, spacing, preset, dimension);
        const std::string at = fmt::format("dx = {} m", spacing);
        linear.add(spacing, strain_rate_errors(run.solve(who + "linear field, " + at, scene),
                                               linear_strain_rate));
        bent.add(spacing, strain_rate_errors(run.solve(who + "curved field, " + at, curved(scene)),
                                             curved_strain_rate));
        last = run.solve(who + "uniform stress, " + at, stressed(scene));
        stress.add(spacing, acceleration_errors(*last));
      }
      judge(run, who, *last, linear, bent, stress);
    }
  }
  run.finish(&*last);
}

}  // namespace scarp::validation
