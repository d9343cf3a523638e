// SPDX-License-Identifier: BSD-3-Clause
/// Runs a scene with a soil model that is defined outside the library, history variable and all.
#include <algorithm>
#include <cstdio>
#include <scarp/scarp.hpp>

#include "maxwell.hpp"

int main() {
  using namespace scarp;
  const Maxwell bitumen{.youngs_modulus = 10e6, .poisson_ratio = 0.3, .relaxation_time = 0.01};
  Simulation simulation(Scene{
      .spacing = 0.1,
      .materials = {{.name = "bitumen", .model = custom_model(bitumen), .density = 2000.0}},
      .bodies = {{.shape = box({1, 0}, {2, 0.5})}},
      .walls = {no_slip("base", line({{0, 0}, {3, 0}}))},
      .initial_stress = InitialStress::geostatic,
      .stages = {{.name = "spread", .duration = 0.1}},
  });
  run(simulation);

  const std::vector<double> faded = simulation.field("faded_stress");
  const double most = *std::max_element(faded.begin(), faded.end());
  std::printf("most shear stress that has faded: %.3g Pa\n", most);
  return most > 100.0 && most < 1e6 ? 0 : 1;
}
