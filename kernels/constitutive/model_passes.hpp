// SPDX-License-Identifier: BSD-3-Clause
/// The compiled per-particle passes of a model.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "kernels/particle_view.hpp"

namespace scarp::kernels {

using StressPass = std::uint64_t (*)(const ParticleView&, const StressPassConstants&,
                                     std::size_t begin, std::size_t end);
using VerletPass = std::uint64_t (*)(const ParticleView&, const StressPassConstants&,
                                     const VerletConstants&, std::size_t begin, std::size_t end);

/// The compiled passes of one model for one instruction set, by dimension - 2.
struct ModelPasses {
  std::array<StressPass, 2> stress;
  std::array<VerletPass, 2> verlet;
};

}  // namespace scarp::kernels
