// SPDX-License-Identifier: BSD-3-Clause
/// Two good scenes as text, to read and to spoil.
#pragma once

#include <stdexcept>
#include <string>

namespace scarp {

inline const std::string slope_text = R"toml(title = "Cohesive slope"
dimension = 2
gravity = [0.0, -9.81]
spacing = "0.25 m"
preset = "modern"

[[material]]
name = "clay"
model = "drucker_prager"
density = 2000.0
youngs_modulus = "100 MPa"
poisson_ratio = 0.3
cohesion = "10 kPa"
friction_angle = "20 deg"
dilation_angle = "9 deg"
cone = "plane_strain"

[[body]]
material = "clay"
polygon = [[0, 0], [45, 0], [45, 5], [32, 5], [12, 15], [0, 15]]

[[wall]]
name = "base"
kind = "no_slip"
line = [[0, 0], [45, 0]]

[initial]
stress = "geostatic"

[[stage]]
name = "settle"
until = "rest"

[[stage]]
name = "fail"
strength_reduction = 1.4
duration = "10 s"

[[probe]]
name = "crest"
at = [12, 15]

[output]
every = "0.1 s"
)toml";

inline const std::string everything_text = R"toml(dimension = 3
spacing = 0.1
preset = "paper"

[numerics]
smoothing = "cubic_spline"
smoothing_ratio = 1.25
lattice_normalisation = true
gradient_correction = true
stress_rotation = "hughes_winget"
viscosity_alpha = 0.5
viscosity_beta = 2
artificial_stress = 0.5
artificial_stress_exponent = "auto"
stress_diffusion = 0.05
diffusion_shear_gate = 10
integrator = "kick_drift_kick"
verlet_restart_interval = 20
cfl = 1
skin = 0.2
density_minimum = 0.6
density_maximum = 1.1

[[material]]
name = "sand"
density = "1.8 t/m3"
youngs_modulus = "10 MPa"
poisson_ratio = 0.3
cohesion = 0
friction_angle = "30 deg"

[[material]]
name = "rubber"
model = "linear_elastic"
density = "1000 kg/m3"
youngs_modulus = "50 MPa"
poisson_ratio = 0.45

[[body]]
material = "sand"
polygon = [[0, 0], ["4 m", 0], [0, 4]]
extrude = [0, 2]

[[body]]
material = "rubber"
box = {min = [0, 0, 0], max = ["20 cm", 0.1, 0.3]}
velocity = [0, 0, "-3 m/s"]

[[body]]
material = "sand"
cylinder = {centre = [5, 5, 0], radius = 1, inner_radius = "50 cm", height = 2}

[[body]]
material = "sand"
height_field = {plan = [[0, 0], [40, 12]], base = 0, along = "x", profile = [[0, 16], [12, 16], [24, 4], [40, 4]]}

[[body]]
material = "sand"
height_field = {plan = [[0, 0], [40, 12]], base = 0, along = "radial", centre = [40, 0], profile = [[0, 16], [12, 16], [24, 4]]}

[[body]]
material = "sand"
height_field = {plan = [[0, 0], [40, 40]], base = 0, expression = "min(16, max(4, 28 - max(x, y)))"}

[[wall]]
name = "pit"
kind = "no_slip"
box = {min = [0, 0, 0], max = [40, 40, 20], open = ["+z"]}

[[wall]]
name = "gate"
kind = "free_slip"
rectangle = {origin = [0, 5, 0], u = [3, 0, 0], v = [0, 0, 2]}
motion = {velocity = [0, 0, 0.5], from = "run"}

[[wall]]
name = "ramp"
kind = "no_slip"
plane = {point = [1, 2, 3], normal = [3, 0, 4], size = 10}
until = "run"

[initial]
stress = "geostatic"
k0 = 0.5

[[stage]]
name = "settle"
until = "rest"
duration = 2
rest_velocity = "2 mm/s"
damping = 12.5
reset = false

[[stage]]
name = "run"
duration = 5
strength_reduction = {sand = 1.3}
damping = "auto"

[[probe]]
name = "top"
at = [1, 1, 4]

[output]
every = 0.1
probes_every = "5 ms"
frames = false
energy = true

[checkpoint]
wall_every = "2 min"
every = 0.5
on_error = "stop"
)toml";

/// `text` with the first `from` turned into `to`; throws if it does not hold `from`.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::logic_error("the scene does not hold: " + from);
  return text.replace(at, from.size(), to);
}

}  // namespace scarp
