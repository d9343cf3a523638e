// SPDX-License-Identifier: BSD-3-Clause
/// A block of clay falls onto a rough base: a scene made in code, 50 steps, where the crest is.
#include <cmath>
#include <cstdio>
#include <scarp/scarp.hpp>

using namespace scarp;

int main() {
  Simulation simulation(Scene{
      .spacing = 0.1,
      .materials = {{.name = "clay",
                     .model = DruckerPrager{.youngs_modulus = 10e6,
                                            .poisson_ratio = 0.3,
                                            .cohesion = 10e3,
                                            .friction_angle = degrees(20)},
                     .density = 2000.0}},
      .bodies = {{.shape = polygon({{1, 0}, {2, 0}, {2, 0.5}, {1, 0.5}}), .material = "clay"}},
      .walls = {no_slip("base", line({{0, 0}, {3, 0}}))},
      .stages = {{.name = "fall", .duration = 10.0}},
      .probes = {{.name = "crest", .at = {1.5, 0.5}}},
  });
  for (int step = 0; step < 50; ++step) simulation.step();

  const double height = simulation.probe("crest").position[1];
  std::printf("scarp %s: t = %g s, crest at y = %g m\n", SCARP_VERSION, simulation.last_step().time,
              height);
  return std::isfinite(height) && height < 0.5 ? 0 : 1;
}
