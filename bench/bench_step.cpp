// SPDX-License-Identifier: BSD-3-Clause
/// The whole step, lists and walls included: on the free block, and on the paper's slope after
/// failure.
#include <benchmark/benchmark.h>

#include <map>
#include <memory>
#include <string>

#include <fmt/format.h>

#include "bench/block.hpp"
#include "engine/scene/scene_reader.hpp"

namespace scarp::bench {
namespace {

void count(benchmark::State& bench, std::int64_t particles, std::uint64_t rebuilds) {
  bench.counters["particle_steps_per_second"] = benchmark::Counter(
      static_cast<double>(particles), benchmark::Counter::kIsIterationInvariantRate);
  bench.counters["steps_per_rebuild"] =
      rebuilds > 0 ? static_cast<double>(bench.iterations()) / static_cast<double>(rebuilds) : 0.0;
}

/// Steps the block as the engine does; it expands freely from its initial pressure.
void step_block(benchmark::State& bench, const BlockOptions& options) {
  Simulation simulation(block_scene(options), {options.threads, options.isa});
  for (auto _ : bench) simulation.step();
  count(bench, static_cast<std::int64_t>(simulation.soil_count()), simulation.rebuild_count());
  bench.counters["bytes_per_particle"] =
      static_cast<double>(simulation.memory_bytes()) / static_cast<double>(simulation.soil_count());
}

/// The slope at SRF 1.6, three seconds after the strength was cut; made once per spacing and
/// preset.
Simulation& failed_slope(double spacing, const std::string& preset_name, int threads) {
  static std::map<std::string, std::unique_ptr<Simulation>> made;
  auto& slope = made[fmt::format("{}/{}/{}", spacing, preset_name, threads)];
  if (slope) return *slope;
  Scene scene = read_scene(SCARP_SLOPE_SCENE, {.preset = preset_name, .spacing = spacing});
  scene.output.energy = false;
  scene.stages[1].strength_reduction = 1.6;
  scene.stages[1].duration = 1e3;
  scene.stages[1].until = StageEnd::duration;
  slope = std::make_unique<Simulation>(scene, RunOptions{threads, {}});
  while (slope->stage_index() == 0 || slope->last_step().stage_time < 3.0) slope->step();
  return *slope;
}

void step_slope(benchmark::State& bench, double spacing, const std::string& preset_name,
                int threads) {
  Simulation simulation = failed_slope(spacing, preset_name, threads).clone();
  const std::uint64_t before = simulation.rebuild_count();
  for (auto _ : bench) simulation.step();
  count(bench, static_cast<std::int64_t>(simulation.soil_count()),
        simulation.rebuild_count() - before);
}

void add_all() {
  for (const std::string name : {"paper", "modern"}) {
    for (const int threads : {1, 2}) {
      for (const auto& [dimension, particles] :
           std::map<int, std::int64_t>{{2, 7'225}, {3, 176'000}}) {
        const BlockOptions options{dimension, particles, preset(name), threads, {}};
        benchmark::RegisterBenchmark(
            fmt::format("step/block/{}d/{}/{}/threads:{}", dimension, name, particles, threads)
                .c_str(),
            [=](benchmark::State& bench) { step_block(bench, options); })
            ->UseRealTime()
            ->Unit(benchmark::kMillisecond);
      }
      for (const double spacing : {1.0, 0.25}) {
        benchmark::RegisterBenchmark(
            fmt::format("step/failed_slope/2d/{}/dx:{}/threads:{}", name, spacing, threads).c_str(),
            [=](benchmark::State& bench) { step_slope(bench, spacing, name, threads); })
            ->UseRealTime()
            ->Unit(benchmark::kMillisecond);
      }
    }
  }
}

}  // namespace
}  // namespace scarp::bench

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  scarp::bench::add_all();
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
