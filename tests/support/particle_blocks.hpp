// SPDX-License-Identifier: BSD-3-Clause
/// Blocks of particles with random states for kernel tests.
#pragma once

#include <random>

#include "kernels/pair/pair_sweep_reference.hpp"

namespace scarp::test {

struct BlockOptions {
  int dimension = 2;
  int cells = 10;  ///< particles along an edge
  double spacing = 0.25;
  double jitter = 0.2;  ///< of the spacing
  bool walls = true;    ///< dummies below, images at the left
};

/// A block of soil with everything random, a quarter of it in tension, on three layers of dummies
/// of a moving wall and beside mirror images of its first columns; one stray particle far off. 2D:
/// no xz, yz stress.
inline kernels::ReferenceParticles random_block(const BlockOptions& o, unsigned seed) {
  std::mt19937 engine(seed), corrected(seed + 1000);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  kernels::ReferenceParticles p;
  const double dx = o.spacing;
  const auto add = [&](double x, double y, double z, bool soil) {
    const double jitter = soil ? o.jitter * dx : 0.0;
    p.position.push_back({x + jitter * unit(engine), y + jitter * unit(engine),
                          o.dimension == 3 ? z + jitter * unit(engine) : 0.0});
    p.velocity.push_back({unit(engine), unit(engine), o.dimension == 3 ? unit(engine) : 0.0});
    p.density.push_back(1800.0 + 200.0 * unit(engine));
    p.volume.push_back(std::pow(dx, o.dimension) * (1.0 + 0.1 * unit(engine)));
    p.sound_speed.push_back(250.0 + 50.0 * unit(engine));
    p.diffusivity.push_back(5.0 + 5.0 * unit(engine));
    std::array<double, 6> stress{}, artificial{};
    for (double& component : stress) component = 1e5 * unit(engine);
    if (soil && unit(engine) > 0.5) {
      for (double& component : artificial) component = 1e-2 * unit(engine);
    }
    if (o.dimension == 2) stress[4] = stress[5] = artificial[4] = artificial[5] = 0.0;
    p.stress.push_back(stress);
    p.artificial_stress.push_back(artificial);
    p.face.emplace_back();
    // From a source of its own, so that all else is as without it.
    std::array<double, 9> force_stress{}, wall_gradient{};
    for (std::size_t c = 0; c < 9; ++c) {
      if (o.dimension == 2 && (c % 3 == 2 || c / 3 == 2)) continue;
      force_stress[c] = 1e5 * unit(corrected);
      if (!soil) wall_gradient[c] = std::pow(dx, o.dimension) * unit(corrected);
    }
    p.force_stress.push_back(force_stress);
    p.wall_gradient.push_back(wall_gradient);
    std::array<double, 6> strain_rate{};
    for (std::size_t c = 0; c < 6; ++c)
      strain_rate[c] = o.dimension == 2 && c > 3 ? 0.0 : 4.0 * unit(corrected);
    p.strain_rate.push_back(strain_rate);
  };
  const int depth = o.dimension == 3 ? o.cells : 1;
  for (int k = 0; k < depth; ++k) {
    for (int j = 0; j < o.cells; ++j) {
      for (int i = 0; i < o.cells; ++i) add((i + 0.5) * dx, (j + 0.5) * dx, (k + 0.5) * dx, true);
    }
  }
  add(-40.0 * dx, 40.0 * dx, 0.0, true);
  p.soil_count = p.size();
  if (!o.walls) return p;
  for (int k = 0; k < depth; ++k) {
    for (int j = 1; j <= 3; ++j) {
      for (int i = 0; i < o.cells; ++i) {
        add((i + 0.5) * dx, (0.5 - j) * dx, (k + 0.5) * dx, false);
        p.velocity.back() = {0.3, 0.0, 0.0};
        p.face.back() = {
            {0.0, 1.0, 0.0},
            (j - 0.5) * dx,
            i % 2 == 0 ? kernels::extrapolation_limit : kernels::extrapolation_limit_near_edge};
      }
    }
  }
  p.wall_count = p.size() - p.soil_count;
  for (std::size_t k = 0; k < p.soil_count; ++k) {
    if (p.position[k][0] < 0.0 || p.position[k][0] > 2.5 * dx) continue;
    p.position.push_back({-p.position[k][0], p.position[k][1], p.position[k][2]});
    p.velocity.push_back({-p.velocity[k][0], p.velocity[k][1], p.velocity[k][2]});
    for (auto* scalar : {&p.density, &p.volume, &p.sound_speed, &p.diffusivity})
      scalar->push_back((*scalar)[k]);
    for (auto* tensor : {&p.stress, &p.artificial_stress}) {
      std::array<double, 6> image = (*tensor)[k];
      image[3] = -image[3];
      image[5] = -image[5];
      tensor->push_back(image);
    }
    std::array<double, 9> image = p.force_stress[k];
    for (const std::size_t c : {1u, 2u, 3u, 6u}) image[c] = -image[c];
    p.force_stress.push_back(image);
    p.wall_gradient.push_back({});
    std::array<double, 6> strain_rate = p.strain_rate[k];
    strain_rate[3] = -strain_rate[3];
    strain_rate[5] = -strain_rate[5];
    p.strain_rate.push_back(strain_rate);
    p.face.emplace_back();
  }
  return p;
}

}  // namespace scarp::test
