// SPDX-License-Identifier: BSD-3-Clause
/// The per-particle pass on the free block: every model, inside its surface and on it, gradient
/// correction, diffusion, by dimension, instruction set and size.
#include <benchmark/benchmark.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "bench/bench_main.hpp"
#include "bench/block.hpp"
#include "engine/integrate/stress_phase.hpp"

namespace scarp::bench {
namespace {

struct Law {
  std::string name;
  Numerics numerics;
  std::optional<SoilModel> soil = {};
  bool yielding = false;
};

std::vector<Law> laws() {
  Numerics plain = preset("paper");
  plain.artificial_stress = 0.0;
  Numerics corrected = plain;
  corrected.gradient_correction = true;
  Numerics modern = preset("modern");
  modern.integrator = Integrator::verlet;
  const MohrCoulomb coulomb{100e6, 0.3, 0.0, 0.35, 0.15};
  MohrCoulomb falling = coulomb;
  falling.residual_friction_angle = 0.2;
  falling.softening_slip = 1.0;
  const DruckerPrager cone{100e6, 0.3, 0.0, 0.35, 0.15};
  DruckerPrager falling_cone = cone;
  falling_cone.residual_friction_angle = 0.2;
  falling_cone.softening_slip = 1.0;
  return {{"elastic", plain, rock()},
          {"return_mapping", plain},
          {"mohr_coulomb", plain, coulomb},
          {"return_mapping_yielding", plain, cone, true},
          {"mohr_coulomb_yielding", plain, coulomb, true},
          {"return_mapping_softening", plain, falling_cone, true},
          {"mohr_coulomb_softening", plain, falling, true},
          {"gradient_correction", corrected},
          {"modern", modern}};
}

void run(benchmark::State& bench, const Law& law, const BlockOptions& options) {
  BlockOptions own = options;
  own.numerics = law.numerics;
  own.soil = law.soil;
  own.yielding = law.yielding;
  State state = block_state(own);
  if (state.kernels.corrects_forces()) {
    sweep_gradient(state);
  } else {
    sweep_all(state);
  }
  state.clock.time_step = 1e-9;  // the state stays what it is
  const kernels::VerletConstants verlet{1e-9, false, 0.0};
  for (auto _ : bench) {
    run_stress_phase(
        state, 1e-9, 1e-9,
        [&](const kernels::ModelPasses& passes, const kernels::ParticleView& view,
            const kernels::StressPassConstants& constants, std::size_t begin, std::size_t end) {
          const auto dimension = static_cast<std::size_t>(options.dimension - 2);
          return passes.verlet[dimension](view, constants, verlet, begin, end);
        });
  }
  const auto particles = static_cast<double>(state.particles.count());
  bench.counters["particles_per_second"] =
      benchmark::Counter(particles, benchmark::Counter::kIsIterationInvariantRate);
  bench.counters["bytes_per_particle"] = static_cast<double>(state.particles.bytes()) / particles;
}

}  // namespace

void add_all(bool /*full*/) {
  for (const int dimension : {3, 2}) {
    for (const std::int64_t particles : {64'000, 1'000'000}) {
      for (const kernels::Isa isa : kernels::available_isas()) {
        const bool best = isa == kernels::available_isas().back();
        for (const Law& law : laws()) {
          if (!best && (particles > 64'000 || law.name != "return_mapping")) continue;
          const BlockOptions options{dimension, particles, preset("paper"), 1,
                                     kernels::isa_name(isa)};
          benchmark::RegisterBenchmark(fmt::format("stress_pass/{}d/{}/double/{}/{}", dimension,
                                                   law.name, options.isa, particles)
                                           .c_str(),
                                       [=](benchmark::State& bench) { run(bench, law, options); })
              ->UseRealTime()
              ->Unit(benchmark::kMillisecond);
        }
      }
    }
  }
}

}  // namespace scarp::bench
