// SPDX-License-Identifier: BSD-3-Clause
/// Gives a free disc a spin, lets it turn, and sums its kinetic energy without copying a field.
#include <cmath>
#include <cstdio>
#include <scarp/scarp.hpp>

using namespace scarp;

double kinetic_energy(const Simulation& simulation, double mass) {
  const FieldView velocity = simulation.view("velocity");  // valid until the next step
  double sum = 0.0;
  for (std::size_t slot = 0; slot < velocity.ids.size(); ++slot) {
    if (velocity.ids[slot] < 0) continue;  // only pads
    for (const auto& component : velocity.components)
      sum += 0.5 * mass * component[slot] * component[slot];
  }
  return sum;
}

int main() {
  const LinearElastic rock{.youngs_modulus = 10e6, .poisson_ratio = 0.3};
  Simulation simulation(Scene{
      .gravity = {},
      .spacing = 0.1,
      .materials = {{.name = "rock", .model = rock, .density = 2000.0}},
      .bodies = {{.shape = Cylinder{.radius = 1.0}}},
      .stages = {{.name = "turn", .duration = 1.0}},
  });
  const std::vector<double> x = simulation.field("position");  // by permanent id: a copy
  std::vector<double> v(x.size());
  for (std::size_t k = 0; k < x.size(); k += 3) v[k] = -x[k + 1], v[k + 1] = x[k];
  simulation.set_field("velocity", v);  // 1 rad/s

  const double before = kinetic_energy(simulation, 2000.0 * 0.1 * 0.1);
  for (int step = 0; step < 50; ++step) simulation.step();
  const double after = kinetic_energy(simulation, 2000.0 * 0.1 * 0.1);
  std::printf("kinetic energy %.4f J, then %.4f J\n", before, after);
  return std::abs(after - before) < 0.01 * before && before > 0.0 ? 0 : 1;
}
