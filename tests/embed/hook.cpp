// SPDX-License-Identifier: BSD-3-Clause
/// A hook adds a force of its own: a free block of 10 m/s is braked with 3 m/s2.
#include <cmath>
#include <cstdio>
#include <scarp/scarp.hpp>

using namespace scarp;

int main() {
  constexpr double start = 10.0, push = -3.0;  // [m/s], [m/s2]
  const LinearElastic rock{.youngs_modulus = 10e6, .poisson_ratio = 0.3};
  Simulation simulation(Scene{
      .gravity = {},
      .spacing = 0.1,
      .materials = {{.name = "rock", .model = rock, .density = 2000.0}},
      .bodies = {{.shape = box({0, 0}, {1, 1}), .velocity = {start}}},
      .stages = {{.name = "brake", .duration = 1.0}},
  });
  simulation.on_phase("sweep_force", When::after, [](PhaseView& view) {
    const auto acceleration = view.write("acceleration", 0);
    for (std::size_t slot = 0; slot < acceleration.size(); ++slot) {
      if (view.ids()[slot] >= 0) acceleration[slot] += push;
    }
  });
  for (int step = 0; step < 50; ++step) simulation.step();

  const double time = simulation.last_step().time;
  double error = 0.0;
  const auto velocity = simulation.field("velocity");
  for (std::size_t k = 0; k < velocity.size(); k += 3)
    error = std::fmax(error, std::fabs(velocity[k] - (start + push * time)));
  std::printf("%g m/s after %g s, off by %g\n", start + push * time, time, error);
  return error < 1e-12 ? 0 : 1;  // round-off of 50 sums
}
