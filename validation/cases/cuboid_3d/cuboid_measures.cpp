// SPDX-License-Identifier: BSD-3-Clause
/// Measures of the deposit.

#include "validation/cases/cuboid_3d/cuboid_measures.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "validation/cases/cuboid_3d/layers.hpp"
#include "validation/deposit.hpp"

namespace scarp::validation {
namespace {

double whole(double x, double spacing) { return spacing * std::round(x / spacing); }

Vec3 whole(const Vec3& p, double spacing) {
  return {whole(p[0], spacing), whole(p[1], spacing), whole(p[2], spacing)};
}

/// Whether particle i / 3 belongs to the fill of the box, by where it started.
bool of_fill(const std::vector<double>& start, std::size_t i, const CuboidSize& size) {
  return start[i] <= size.gate && start[i + 2] >= size.base_layer;
}

/// Highest particles of a vertical slice in bins of one spacing, as a surface above the floor.
Profile surface_of(const std::vector<double>& position, double spacing, std::size_t across,
                   double at, std::size_t along) {
  Profile profile;
  for (std::size_t i = 0; i < position.size(); i += 3) {
    if (std::fabs(position[i + across] - at) > spacing) continue;
    const auto bin = static_cast<std::size_t>(std::max(position[i + along] / spacing, 0.0));
    while (profile.x.size() <= bin) {
      profile.x.push_back((static_cast<double>(profile.x.size()) + 0.5) * spacing);
      profile.height.push_back(0.0);
    }
    profile.height[bin] = std::max(profile.height[bin], position[i + 2] + 0.5 * spacing);
  }
  return profile;
}

/// Angle of the straight part of a falling surface: least squares between 20 and 80 % of its drop.
double face_angle(const Profile& surface, double low, double high) {
  double n = 0.0, x = 0.0, z = 0.0, xx = 0.0, xz = 0.0;
  for (std::size_t k = 0; k < surface.x.size(); ++k) {
    const double share = (surface.height[k] - low) / (high - low);
    if (share < 0.2 || share > 0.8) continue;
    n += 1.0;
    x += surface.x[k];
    z += surface.height[k];
    xx += surface.x[k] * surface.x[k];
    xz += surface.x[k] * surface.height[k];
  }
  return -std::atan((n * xz - x * z) / (n * xx - x * x)) * 180.0 / std::numbers::pi;
}

void write_surfaces(const std::vector<double>& position, double spacing,
                    const std::filesystem::path& folder) {
  write_profile(folder / "middle_plane.csv", surface_of(position, spacing, 1, 0.0, 0));
  write_profile(folder / "y_100_mm.csv", surface_of(position, spacing, 1, 0.1, 0));
  write_profile(folder / "x_212_mm.csv", surface_of(position, spacing, 0, 0.212, 1));
}

}  // namespace

CuboidSize cuboid_size(const Scene& scene) {
  const Box &box = std::get<Box>(scene.bodies[0].shape),
            &field = std::get<Box>(scene.bodies[1].shape);
  return {box.maximum[0],   box.maximum[1],  field.maximum[2], box.maximum[2] - field.maximum[2],
          field.maximum[0], field.maximum[1]};
}

void snap_to_lattice(Scene& scene) {
  const double dx = scene.spacing;
  for (Body& body : scene.bodies) {
    Box& box = std::get<Box>(body.shape);
    box = {whole(box.minimum, dx), whole(box.maximum, dx)};
  }
  for (Wall& wall : scene.walls) {
    for (Facet& facet : wall.facets) {
      const Vec3 near = whole(facet.origin, dx);
      const auto length = [&](const Vec3& tangent, double old) {
        Vec3 end{};
        for (std::size_t a = 0; a < 3; ++a) end[a] = facet.origin[a] + old * tangent[a];
        const Vec3 far = whole(end, dx);
        return std::hypot(far[0] - near[0], far[1] - near[1], far[2] - near[2]);
      };
      facet.length_u = length(facet.tangent_u, facet.length_u);
      facet.length_v = length(facet.tangent_v, facet.length_v);
      facet.origin = near;
    }
  }
}

void measure_settled_cuboid(const Simulation& settled, Outcome& outcome) {
  double force = 0.0;
  for (const WallReaction& reaction : settled.wall_reactions()) force -= reaction.force[2];
  const Scene& scene = settled.scene();
  const double weight = static_cast<double>(settled.soil_count()) * std::pow(scene.spacing, 3) *
                        scene.materials.front().density * -scene.gravity[2];
  outcome.values["vertical force on the walls over weight, settled [-]"] = force / weight;
  outcome.values["residual velocity, settled [m/s]"] = settled.last_step().max_velocity;
}

double mean_run_out(const Simulation& fallen, const std::vector<double>& start) {
  const std::vector<double> position = fallen.field("position");
  const CuboidSize size = cuboid_size(fallen.scene());
  double way = 0.0, count = 0.0;
  for (std::size_t i = 0; i < position.size(); i += 3) {
    if (!of_fill(start, i, size)) continue;
    way += position[i] - start[i];
    count += 1.0;
  }
  return way / (count * size.gate);
}

void measure_deposit(const Simulation& fallen, const std::vector<double>& start,
                     const std::filesystem::path& folder, Outcome& outcome) {
  const std::vector<double> position = fallen.field("position");
  const double spacing = fallen.scene().spacing;
  const CuboidSize size = cuboid_size(fallen.scene());
  const double top = size.base_layer + size.fill;
  double inside = 0.0, back_height = 0.0;
  std::vector<double> front, width;
  for (std::size_t i = 0; i < position.size(); i += 3) {
    const double x = position[i], y = position[i + 1], z = position[i + 2];
    inside += x > 0.0 && x < size.field_length && y > 0.0 && y < size.field_half_width && z > 0.0;
    if (x < 2.0 * spacing) back_height = std::max(back_height, z + 0.5 * spacing - size.base_layer);
    if (!of_fill(start, i, size)) continue;
    front.push_back(x - size.gate);
    width.push_back(x > size.gate ? y : 0.0);
  }
  auto& values = outcome.values;
  values["mass inside over mass before [-]"] = 3.0 * inside / static_cast<double>(position.size());
  // The farthest grain is off by 15 % and more; 0.5 % of the fill may run ahead.
  values["front beyond the gate [m]"] = quantile(front, 0.995);
  values["half width of the deposit outside [m]"] = quantile(width, 0.995);
  values["height at the back wall over that of the fill [-]"] = back_height / size.fill;
  const Profile middle = surface_of(position, spacing, 1, 0.0, 0),
                off_middle = surface_of(position, spacing, 1, 0.1, 0);
  values["face angle, middle plane [deg]"] = face_angle(middle, size.base_layer, top);
  values["height at the gate, middle plane [m]"] = height_at(middle, size.gate) - size.base_layer;
  values["height at the gate, y = 100 mm [m]"] = height_at(off_middle, size.gate) - size.base_layer;
  write_surfaces(position, spacing, folder);
  measure_layers(fallen, start, size, folder, outcome);
  const EnergyBalance energy = fallen.energy();
  values["energy left open over potential drop [-]"] = energy.imbalance / -energy.potential;
  values["plastic work over potential drop [-]"] = energy.plastic / -energy.potential;
  const StepReport& last = fallen.last_step();
  const double limit = fallen.scene().stages.back().duration.value();
  values["time to rest [s]"] = last.stage_time < limit ? last.stage_time : std::nan("");
  values["residual velocity [m/s]"] = fallen.last_step().max_velocity;
  values["particles [-]"] = static_cast<double>(fallen.soil_count());
}

}  // namespace scarp::validation
