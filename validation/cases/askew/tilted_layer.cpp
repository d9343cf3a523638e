// SPDX-License-Identifier: BSD-3-Clause
/// Shear stress and displacement of a tilted layer, turned against the lattice.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "validation/cases/askew/parts.hpp"
#include "validation/cases/askew/turned.hpp"

namespace scarp::validation {
namespace {

/// Layer of H = 1 under gravity (g_t, -g_n): shear rho g_t (H - y), displacement rho g (H y -
/// y^2/2) over G along and over the oedometer modulus down.
struct TiltedLayer {
  double height, length, along, down, shear_modulus, oedometric;  ///< along, down: rho g [N/m3]

  explicit TiltedLayer(const Scene& aligned) {
    const Material& soil = aligned.materials.front();
    const auto& outline = std::get<Polygon>(aligned.bodies.front().shape).points;
    const double youngs = soil.model.parameter("youngs_modulus"),
                 poisson = soil.model.parameter("poisson_ratio");
    length = outline[1][0];
    height = outline[2][1];
    along = soil.density * aligned.gravity[0];
    down = -soil.density * aligned.gravity[1];
    shear_modulus = 0.5 * youngs / (1.0 + poisson);
    oedometric = youngs * (1.0 - poisson) / ((1.0 + poisson) * (1.0 - 2.0 * poisson));
  }
  double course(double y) const { return height * y - 0.5 * y * y; }
};

}  // namespace

void judge_layer(CaseRun& run, const std::string& preset, double spacing, double degrees,
                 std::optional<Simulation>& last) {
  const double angle = radians(degrees);
  const std::string who =
      fmt::format("{}, tilted layer, dx = {} m, turned by {} deg: ", preset, spacing, degrees);
  const Scene aligned = run.scene_at(spacing, preset, "layer.toml");
  const TiltedLayer layer(aligned);
  last = run.solve(who, turned(aligned, angle));
  const auto rows = static_cast<std::size_t>(std::lround(layer.height / spacing));
  std::vector<double> off(rows), count(rows);
  double along = 0.0, down = 0.0, squares = 0.0, inner = 0.0;
  for (const TurnedBack& one : turned_back(*last, angle)) {
    // The middle, away from the ends by five depths.
    if (std::fabs(one.start[0] - 0.5 * layer.length) > 0.5 * layer.length - 5.0 * layer.height)
      continue;
    const double y = one.start[1];
    const auto row = std::min(rows - 1, static_cast<std::size_t>(std::fmax(y, 0.0) / spacing));
    const double error = (one.xy - layer.along * (layer.height - y)) / (layer.along * spacing);
    off[row] += error;
    count[row] += 1.0;
    if (row + 1 == rows) {
      along += one.displacement[0] * layer.shear_modulus / (layer.along * layer.course(y));
      down -= one.displacement[1] * layer.oedometric / (layer.down * layer.course(y));
    }
    if (row + 2 < rows) {
      squares += error * error;
      inner += 1.0;
    }
  }
  double below = 0.0, middle = 0.0, surface = 0.0;
  for (std::size_t row = 0; row < rows; ++row) {
    double& worst = row + 2 < rows ? below : surface;
    worst = std::fmax(worst, std::fabs(off[row] / count[row]));
    if (row >= 4 && row + 2 < rows) middle = std::fmax(middle, std::fabs(off[row] / count[row]));
  }
  run.add(holds(who + "came to rest", last->stage_reached_rest(), "slower than 1e-6 m/s"));
  judge_in_long_forms(
      run, within(who + "error of the shear stress, worst row below the surface", below, "", 0.0,
                  0.0, 0.1, "over rho g sin(b) dx; a tenth of a row's weight"));
  run.add(reported(who + "the same from the fifth row on", middle, "", "beyond reach of the base"));
  run.add(reported(who + "the same in the two rows at the surface", surface, "",
                   "there T and not the stress is in balance"));
  run.add(reported(who + "rms of single particles below them", std::sqrt(squares / inner), "",
                   "over rho g sin(b) dx"));
  const double top = count[rows - 1];
  judge_in_long_forms(
      run, within(who + "displacement of the surface along it over the closed form", along / top,
                  "", 1.0, 0.99, 1.01, "rho g sin(b) (H y - y^2/2)/G, 1 %"));
  judge_in_long_forms(
      run, within(who + "displacement of the surface down over the closed form", down / top, "",
                  1.0, 0.99, 1.01, "rho g cos(b) (H y - y^2/2)/M_oed, 1 %"));
  run.add(reported(
      who + "mass of the particles over that of the outline",
      last->soil_mass() / (aligned.materials.front().density * layer.length * layer.height), "",
      "a particle is where the centre of its cell is in the outline"));
}

}  // namespace scarp::validation
