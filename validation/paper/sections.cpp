// SPDX-License-Identifier: BSD-3-Clause
/// Particles by place.

#include "validation/paper/sections.hpp"

namespace scarp::validation {

std::vector<Grain> grains_of(const Simulation& simulation) {
  const std::vector<double> position = simulation.field("position"),
                            displacement = simulation.field("displacement"),
                            strain = simulation.field("accumulated_plastic_strain"),
                            density = simulation.field("density"),
                            stress = simulation.field("stress");
  const bool plane = simulation.scene().dimension == 2;
  std::vector<Grain> grains(strain.size());
  for (std::size_t i = 0; i < grains.size(); ++i) {
    const double *p = &position[3 * i], *u = &displacement[3 * i], *s = &stress[6 * i];
    Grain& grain = grains[i];
    grain.now = plane ? Vec3{p[0], 0.0, p[1]} : Vec3{p[0], p[1], p[2]};
    grain.start =
        plane ? Vec3{p[0] - u[0], 0.0, p[1] - u[1]} : Vec3{p[0] - u[0], p[1] - u[1], p[2] - u[2]};
    grain.moved = std::hypot(u[0], u[1], u[2]);
    grain.strain = strain[i];
    grain.density = density[i];
    grain.xx = s[0];
    grain.yy = plane ? s[2] : s[1];
    grain.zz = plane ? s[1] : s[2];
    grain.xy = plane ? 0.0 : s[3];
  }
  return grains;
}

std::vector<Section> sections_of(const Slope3d& slope) {
  if (slope.plane()) return {{"section", false, 0.0, true}};
  if (!slope.corner()) return {{"section M"}};
  return {{"section P", true}, {"section Q", false, slope.lateral_section()}};
}

bool slides(const Grain& grain, const Slope3d& slope) {
  return grain.moved > slide_share * slope.size().height;
}

bool at_risk(const Grain& grain, const Slope3d& slope) {
  const double d = slope.distance(grain.start[0], grain.start[1]);
  const SlopeSize& size = slope.size();
  // Behind the crest as far as in the sections of 3D slopes, whose diagonal is longer by sqrt(2).
  const double behind = 0.5 * slope.face_run();
  return grain.start[2] > size.foundation && d > size.crest - behind &&
         d < size.crest + slope.face_run();
}

}  // namespace scarp::validation
