// SPDX-License-Identifier: BSD-3-Clause
/// Pair sweeps on the free block: fused and each half, by dimension, smoothing function,
/// instruction set, size and threads. The default set takes about two minutes; --full adds 1M
/// particles and every option.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "bench/block.hpp"
#include "kernels/smoothing/list.hpp"

namespace scarp::bench {
namespace {

struct Variant {
  const char* name;
  void (*sweep)(State&);
};
constexpr Variant fused{"fused", sweep_all};
constexpr Variant gradient{"gradient", sweep_gradient};
constexpr Variant force{"force", sweep_force};

/// One block is kept: runs that differ only in the sweep share it.
State& cached_block(const BlockOptions& options, const std::string& key) {
  static std::string present;
  static std::unique_ptr<State> block;
  if (present != key) {
    block = std::make_unique<State>(block_state(options));
    present = key;
  }
  return *block;
}

void run(benchmark::State& bench, const Variant& variant, const BlockOptions& options,
         const std::string& key) {
  State& state = cached_block(options, key);
  const auto particles = static_cast<double>(state.particles.count());
  const auto pairs = static_cast<double>(true_pairs(state));
  for (auto _ : bench) variant.sweep(state);
  const auto per_second = [&](double items) {
    return benchmark::Counter(items, benchmark::Counter::kIsIterationInvariantRate);
  };
  bench.counters["pairs_per_second"] = per_second(pairs);
  bench.counters["particle_steps_per_second"] = per_second(particles);
  bench.counters["pairs_per_particle"] = pairs / particles;
  bench.counters["useful_lane_share"] =
      pairs / (static_cast<double>(state.lists.entries()) * state.kernels.table->cluster_size);
  bench.counters["bytes_per_particle"] =
      static_cast<double>(state.particles.bytes() + state.records.bytes() + state.lists.bytes()) /
      particles;
}

void add(const Variant& variant, const BlockOptions& options, const std::string& body) {
  const std::string block = fmt::format("{}d/{}/double/{}/{}/threads:{}", options.dimension, body,
                                        options.isa, options.particles, options.threads);
  benchmark::RegisterBenchmark(
      fmt::format("{}/{}", variant.name, block).c_str(),
      [=](benchmark::State& bench) { run(bench, variant, options, block); })
      ->UseRealTime()
      ->Unit(benchmark::kMillisecond);
}

void add_all(bool full) {
  std::vector<std::int64_t> sizes{10'000, 176'000};
  if (full) sizes.push_back(1'000'000);
  for (const int dimension : {3, 2}) {
    for (const std::int64_t particles : sizes) {
      for (const int threads : {1, 2}) {
        for (const kernels::Isa isa : kernels::available_isas()) {
          BlockOptions options{dimension, particles, preset("paper"), threads,
                               kernels::isa_name(isa)};
          const bool best = isa == kernels::available_isas().back();
          if (!full && !best && (threads > 1 || particles > 10'000)) continue;
          options.numerics.artificial_stress = 0.0;
          for (std::size_t s = 0; s < kernels::smoothing_functions.size(); ++s) {
            options.numerics.smoothing = static_cast<SmoothingFunction>(s);
            const std::string name = kernels::smoothing_functions[s].name;
            const bool plain = options.numerics.smoothing == SmoothingFunction::yang_liu;
            if (!full && !plain) continue;
            add(fused, options, name);
            if (!plain) continue;
            add(gradient, options, name);
            add(force, options, name);
          }
          if (!best) continue;
          BlockOptions with = options;
          with.numerics = preset("paper");
          add(fused, with, "yang_liu+artificial_stress");
          with.numerics = preset("modern");
          with.numerics.integrator = Integrator::verlet;  // for the fused sweep
          add(fused, with, "modern");
        }
      }
    }
  }
}

}  // namespace
}  // namespace scarp::bench

int main(int argc, char** argv) {
  const auto end =
      std::remove_if(argv + 1, argv + argc, [](char* a) { return std::strcmp(a, "--full") == 0; });
  const bool full = end != argv + argc;
  argc = static_cast<int>(end - argv);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  scarp::bench::add_all(full);
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
