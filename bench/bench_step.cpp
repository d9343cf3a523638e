// SPDX-License-Identifier: BSD-3-Clause
/// The whole step, lists and walls included: on the free block, on states that occur in runs, and
/// with one piece of physics more or less than a preset has.
#include <benchmark/benchmark.h>

#include <functional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "bench/bench_main.hpp"
#include "bench/block.hpp"
#include "bench/real_states.hpp"
#include "engine/team.hpp"

namespace scarp::bench {
namespace {

void count(benchmark::State& bench, const Simulation& simulation, std::uint64_t rebuilds) {
  const auto particles = static_cast<double>(simulation.soil_count());
  bench.counters["particle_steps_per_second"] =
      benchmark::Counter(particles, benchmark::Counter::kIsIterationInvariantRate);
  bench.counters["particles"] = particles;
  bench.counters["steps_per_rebuild"] =
      rebuilds > 0 ? static_cast<double>(bench.iterations()) / static_cast<double>(rebuilds) : 0.0;
  bench.counters["bytes_per_particle"] = static_cast<double>(simulation.memory_bytes()) / particles;
}

/// Steps from a state as the engine does, and starts anew every so many steps, so that the state
/// stays the one that is named.
void step_from(benchmark::State& bench, Simulation simulation, std::uint64_t steps) {
  // First touch and first lists belong to the state.
  do simulation.step();
  while (simulation.rebuild_count() == 0);
  const Simulation start = simulation.clone();
  const std::uint64_t first = start.last_step().step;
  std::uint64_t rebuilds = 0;
  const auto since_start = [&] { return simulation.rebuild_count() - start.rebuild_count(); };
  for (auto _ : bench) {
    simulation.step();
    if (simulation.last_step().step < first + steps) continue;
    bench.PauseTiming();
    rebuilds += since_start();
    simulation = start.clone();
    bench.ResumeTiming();
  }
  count(bench, simulation, rebuilds + since_start());
}

/// The free faces of the block let go at the speed of sound, a fifth of a spacing a step.
void step_block(benchmark::State& bench, const BlockOptions& options) {
  step_from(bench, Simulation(block_scene(options), {options.threads, options.isa}), 40);
}

void add(const std::string& name, const std::function<void(benchmark::State&)>& run) {
  benchmark::RegisterBenchmark(name.c_str(), run)->UseRealTime()->Unit(benchmark::kMillisecond);
}

void add_block(const std::string& body, const BlockOptions& options) {
  add(fmt::format("step/{}/{}/threads:{}", body, options.particles, options.threads),
      [=](benchmark::State& bench) { step_block(bench, options); });
}

/// What a piece of physics costs: `with_without/<preset>/` as it stands, then with one choice
/// changed.
void add_with_and_without() {
  struct Change {
    const char* name;
    void (*apply)(BlockOptions&);
  };
  const std::vector<Change> of_paper{
      {"as_it_is", [](BlockOptions&) {}},
      {"2d", [](BlockOptions& o) { o.dimension = 2; }},
      {"no_artificial_stress", [](BlockOptions& o) { o.numerics.artificial_stress = 0.0; }},
      {"no_viscosity",
       [](BlockOptions& o) { o.numerics.viscosity_alpha = o.numerics.viscosity_beta = 0.0; }},
      {"artificial_stress_at_work", [](BlockOptions& o) { o.tension = true; }},
      {"gradient_correction", [](BlockOptions& o) { o.numerics.gradient_correction = true; }},
      {"elastic",
       [](BlockOptions& o) {
         o.soil = rock();  // may come into tension, so without the artificial stress
         o.numerics.artificial_stress = 0.0;
       }},
      {"walls", [](BlockOptions& o) { o.walls = true; }},
      {"energy", [](BlockOptions& o) { o.energy = true; }}};
  const std::vector<Change> of_modern{
      {"as_it_is", [](BlockOptions&) {}},
      {"2d", [](BlockOptions& o) { o.dimension = 2; }},
      {"no_stress_diffusion", [](BlockOptions& o) { o.numerics.stress_diffusion = 0.0; }},
      {"no_gradient_correction",
       [](BlockOptions& o) {
         o.numerics.gradient_correction = false;
         o.numerics.stress_diffusion = 0.0;
       }},
      {"no_viscosity",
       [](BlockOptions& o) { o.numerics.viscosity_alpha = o.numerics.viscosity_beta = 0.0; }},
      {"verlet", [](BlockOptions& o) { o.numerics.integrator = Integrator::verlet; }},
      {"no_force_correction", [](BlockOptions& o) { o.numerics.force_correction = false; }},
      {"2d_no_force_correction",
       [](BlockOptions& o) {
         o.dimension = 2;
         o.numerics.force_correction = false;
       }},
      {"elastic", [](BlockOptions& o) { o.soil = rock(); }},
      {"walls", [](BlockOptions& o) { o.walls = true; }},
      {"walls_no_force_correction",
       [](BlockOptions& o) {
         o.walls = true;
         o.numerics.force_correction = false;
       }},
      {"energy", [](BlockOptions& o) { o.energy = true; }}};
  for (const std::string name : {"paper", "modern"}) {
    for (const Change& change : name == "paper" ? of_paper : of_modern) {
      BlockOptions options{3, 64'000, preset(name), 1, {}};
      change.apply(options);
      add_block(fmt::format("with_without/{}/{}", name, change.name), options);
    }
  }
}

}  // namespace

void add_all(bool full) {
  std::vector<RealState> states{failed_slope(1.0), failed_slope(0.5), run_out_2d(5e-3),
                                run_out_2d(2.5e-3)};
  if (full) {
    for (const RealState& state : {failed_slope(0.25), run_out_2d(1.25e-3), run_out_3d(12e-3)})
      states.push_back(state);
  }
  for (const std::string name : {"paper", "modern"}) {
    for (int threads = 1; threads <= default_threads(); threads *= 2) {
      for (const int dimension : {2, 3}) {
        const std::int64_t particles = dimension == 2 ? 90'000 : 176'000;
        for (const Precision precision : {Precision::real64, Precision::mixed}) {
          BlockOptions options{dimension, particles, preset(name), threads, {}};
          options.numerics.precision = precision;
          add_block(fmt::format("block/{}d/{}/{}", dimension, name, word(precision)), options);
        }
      }
      add_block(fmt::format("weak/3d/{}/double", name),
                {3, 88'000L * threads, preset(name), threads, {}});
      for (const RealState& state : states) {
        add(fmt::format("step/{}/{}/dx:{}/threads:{}", state.name, name, state.spacing, threads),
            [=](benchmark::State& bench) { step_from(bench, made(state, name, threads), 400); });
      }
    }
  }
  add_with_and_without();
}

}  // namespace scarp::bench
