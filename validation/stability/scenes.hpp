// SPDX-License-Identifier: BSD-3-Clause
/// Scenes of the stability map: at most about 500 particles, in 3D 1000.
#pragma once

#include "engine/scene/scene.hpp"

namespace scarp::validation {

/// Axis along which gravity acts in these scenes.
std::size_t upwards(const Scene& scene);
Stage lasting(const std::string& name, double duration);
Facet line_2d(double x0, double y0, double x1, double y1);
Wall wall_2d(const std::string& name, WallKind kind, std::vector<Facet> facets);
Material soil(double youngs = 100e6, double cohesion = 10e3, double friction_deg = 20.0,
              double dilation_deg = 0.0, double poisson = 0.3, double density = 2000.0);
/// A box from one corner to the other.
Body box_of(const std::string& material, double x0, double y0, double x1, double y1,
            double falling = 0.0);
Material solid(const std::string& name, double youngs, double density = 2000.0);

/// Slope of 10 m on 5 m of ground at 1 m, 445 particles: settles, then goes on at full strength.
Scene slope_scene(const std::string& preset_name);
/// Level bed between smooth sides on a rough base, the lower left corner at the origin; 2D, and 3D
/// as wide each way.
Scene bed_scene(const std::string& preset_name, double width, double height, double spacing);
Scene bed_scene_3d(const std::string& preset_name, double width, double height, double spacing);

/// Stages whose lengths suit the stiffness: settling for `passages` waves over h, then on.
void set_stages(Scene& scene, double settle_passages);

/// Whether the soil could stand: not where linear elasticity has its weight compress it to nothing
/// at its base, rho g H of its wave modulus or more.
bool can_stand(const Scene& scene);

/// Lets the first stage last until the slowest shear wave of the soil has died away, ten times
/// over.
void settle_fully(Scene& scene);

}  // namespace scarp::validation
