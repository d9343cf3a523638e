// SPDX-License-Identifier: BSD-3-Clause
/// The per-particle pass on the free block: elastic and plastic, gradient
/// correction, diffusion, by dimension, instruction set and size.
#include <benchmark/benchmark.h>

#include <memory>
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
  bool elastic = false;
};

std::vector<Law> laws() {
  Numerics plain = preset("paper");
  plain.artificial_stress = 0.0;
  Numerics corrected = plain;
  corrected.gradient_correction = true;
  Numerics modern = preset("modern");
  modern.integrator = Integrator::verlet;
  return {{"elastic", plain, true},
          {"return_mapping", plain},
          {"gradient_correction", corrected},
          {"modern", modern}};
}

void run(benchmark::State& bench, const Law& law, const BlockOptions& options) {
  BlockOptions own = options;
  own.numerics = law.numerics;
  own.elastic = law.elastic;
  State state = block_state(own);
  sweep_all(state);
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
