// SPDX-License-Identifier: BSD-3-Clause
/// Collapse of a column and its measures.

#include "validation/column_collapse.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace scarp::validation {
namespace {

constexpr double degree = std::numbers::pi / 180.0;
constexpr double duration = 6.0;        // in sqrt(H0/g); the front stops after 3 to 4
constexpr double volume_share = 0.995;  // the farthest grains are off by 15 % and more
constexpr double reach = 1.5;           // in dx; the diagonal of a lattice cell is 1.41
constexpr int sectors = 9;              // of the quarter circle

double initial_width(const Scene& scene) {
  const auto& shape = scene.bodies.front().shape;
  const Box* box = std::get_if<Box>(&shape);
  return box != nullptr ? box->maximum[0] : std::get<HeightField>(shape).plan_maximum[0];
}

double gravity_of(const Scene& scene) {
  return std::hypot(scene.gravity[0], scene.gravity[1], scene.gravity[2]);
}

/// Horizontal distance of particle i from the symmetry plane or axis.
double distance(const Simulation& now, const std::vector<double>& position, std::size_t i) {
  return now.scene().dimension == 2 ? position[3 * i]
                                    : std::hypot(position[3 * i], position[3 * i + 1]);
}

/// Edge of the particle at the quantile of the volume, half a spacing beyond its centre.
double front(const Simulation& now) {
  const std::vector<double> position = now.field("position");
  std::vector<double> distances;
  for (std::size_t i = 0; 3 * i < position.size(); ++i) {
    distances.push_back(distance(now, position, i));
  }
  return quantile(std::move(distances), volume_share) + 0.5 * now.scene().spacing;
}

/// End of the connected deposit; in 3D the mean over sectors, as the farthest of all grows with
/// their number.
double connected_front(const Simulation& now) {
  const std::vector<double> position = now.field("position");
  const double spacing = now.scene().spacing;
  const int count = now.scene().dimension == 2 ? 1 : sectors;
  std::vector<double> farthest(static_cast<std::size_t>(count), 0.0);
  for (const std::size_t i : main_body(position, reach * spacing)) {
    const double share =
        std::atan2(position[3 * i + 1], position[3 * i]) / (0.5 * std::numbers::pi);
    const int sector = count == 1 ? 0 : std::clamp(static_cast<int>(share * count), 0, count - 1);
    double& far = farthest[static_cast<std::size_t>(sector)];
    far = std::max(far, distance(now, position, i) + 0.5 * spacing);
  }
  double sum = 0.0;
  for (const double far : farthest) sum += far;
  return sum / count;
}

}  // namespace

double viscous_share(const Simulation& simulation) {
  if (!simulation.scene().output.energy) return 0.0;
  const EnergyBalance energy = simulation.energy();
  const double all = energy.plastic + energy.viscous + energy.damping + energy.artificial_stress +
                     energy.gradient_residue + energy.diffusion;
  return all > 0.0 ? energy.viscous / all : 0.0;
}

void set_column(Scene& scene, Column& column) {
  const double width = initial_width(scene), height = column.aspect_ratio * width;
  auto& shape = scene.bodies.front().shape;
  if (Box* box = std::get_if<Box>(&shape)) {
    box->maximum[1] = height;
  } else {
    for (auto& point : std::get<HeightField>(shape).profile) {
      if (point[1] > 0.0) point[1] = height;
    }
  }
  SoilModel& soil = scene.materials.front().model;
  if (column.friction_angle > 0.0) soil.set("friction_angle", column.friction_angle * degree);
  column.friction_angle = soil.parameter("friction_angle") / degree;
  scene.stages.back().duration = duration * std::sqrt(height / gravity_of(scene));
}

ColumnDeposit collapse_column(CaseRun& run, const std::string& name, Simulation& simulation,
                              const Column& column, RunWriter* writer, Profile* surface) {
  const Scene& scene = simulation.scene();
  const double width = initial_width(scene), height = column.aspect_ratio * width;
  const double late = scene.stages.back().duration.value() - std::sqrt(height / gravity_of(scene));
  std::optional<double> before;
  for (std::size_t stage = 0; stage < scene.stages.size(); ++stage) {
    const bool last = stage + 1 == scene.stages.size();
    run.run_stage(last ? name : name + ", " + scene.stages[stage].name, simulation, writer,
                  [&](const Simulation& now) {
                    if (!last || before || now.last_step().stage_time < late) return;
                    before = front(now);
                  });
  }
  const std::vector<double> position = simulation.field("position");
  ColumnDeposit deposit;
  deposit.preset = scene.numerics.preset;
  deposit.spacing = scene.spacing;
  deposit.width = width;
  deposit.column = column;
  const double end = front(simulation);
  deposit.run_out = end / width - 1.0;
  deposit.advance = (end - before.value_or(0.0)) / width;
  deposit.connected_run_out = connected_front(simulation) / width - 1.0;
  deposit.viscous_share = viscous_share(simulation);
  deposit.lost = share_through_walls(position, scene.dimension, scene.spacing);
  std::vector<double> x;
  const std::size_t up = scene.dimension == 2 ? 1 : 2;
  for (std::size_t i = 0; 3 * i < position.size(); ++i) {
    const double far = distance(simulation, position, i);
    x.push_back(far);
    if (far > 2.0 * scene.spacing) continue;
    deposit.height = std::max(deposit.height, (position[3 * i + up] + 0.5 * scene.spacing) / width);
  }
  deposit.grain_run_out =
      closed_front(x, scene.dimension, scene.spacing, grain_size * width) / width - 1.0;
  if (surface != nullptr) *surface = column_profile(x, scene.spacing, 2.0 * scene.spacing);
  return deposit;
}

double RunOutLaw::at(double a) const {
  return a < transition ? below * a : above * std::pow(a, exponent);
}

}  // namespace scarp::validation
