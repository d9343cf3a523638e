// SPDX-License-Identifier: BSD-3-Clause
/// Pair sweeps on the free block: fused and each half, by dimension, smoothing function, artificial
/// stress, instruction set, size and threads. The default set takes about two minutes; --full adds
/// sizes up to 4M particles and every combination.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "bench/bench_main.hpp"
#include "bench/block.hpp"
#include "bench/fma_peak.hpp"
#include "engine/team.hpp"
#include "kernels/pair/term_rows.hpp"
#include "kernels/smoothing/list.hpp"

namespace scarp::bench {
namespace {

struct Sweep {
  const char* name;
  void (*run)(State&);
  kernels::TermSet (*terms)(kernels::TermSet of_scene);
};
constexpr Sweep fused{"fused", sweep_all, [](kernels::TermSet all) { return all; }};
constexpr Sweep gradient{"gradient", sweep_gradient, kernels::gradient_terms};
constexpr Sweep force{"force", sweep_force, kernels::force_terms};

/// What a benchmark runs on: a block, in tension throughout or in compression, under a name.
struct Body {
  std::string name;
  Numerics numerics;
  bool tension = false;
};

Body plain_body(SmoothingFunction smoothing) {
  Body body{kernels::smoothing_functions[static_cast<std::size_t>(smoothing)].name,
            preset("paper")};
  body.numerics.smoothing = smoothing;
  body.numerics.artificial_stress = 0.0;
  return body;
}
/// Artificial stress compiled in: skipped in compression, at work everywhere in tension.
Body tensile_body(bool tension) {
  return {tension ? "yang_liu+artificial_stress:always" : "yang_liu+artificial_stress:auto",
          preset("paper"), tension};
}
/// Its two sweeps read different records, so there is no fused one.
Body modern_body() { return {"modern", preset("modern")}; }
Body in_mixed(Body body) {
  body.numerics.precision = Precision::mixed;
  return body;
}

/// Corrected forces read other records than the gradient, made from what it found.
void prepare(State& state, const Sweep& sweep) {
  if (!state.kernels.corrects_forces()) return;
  phases::pack_soil.run(state);
  if (sweep.run != sweep_force) return;
  for (const Phase& phase : {phases::sweep_gradient, phases::take_moment, phases::pack_forces})
    phase.run(state);
}

/// One block is kept: runs that differ only in the sweep share it.
State& cached_block(const BlockOptions& options, const std::string& key) {
  static std::string present;
  static std::unique_ptr<State> block;
  if (!block || present != key) {
    block.reset();
    block = std::make_unique<State>(block_state(options));
    present = key;
  }
  return *block;
}

void run(benchmark::State& bench, const Sweep& sweep, const BlockOptions& options,
         const std::string& key) {
  State& state = cached_block(options, key);
  prepare(state, sweep);
  const auto particles = static_cast<double>(state.particles.count());
  const auto pairs = static_cast<double>(true_pairs(state));
  // Of soil in compression the terms that read the second line are skipped.
  kernels::TermSet terms = sweep.terms(state.kernels.terms);
  if (!options.tension) terms = terms.without(kernels::marked_terms(kernels::PairTerms{}));
  const int flops = kernels::pair_flops(kernels::PairTerms{}, options.dimension, terms);
  // Twice as many lanes in single precision, at the same rate.
  const double lanes = state.scene.numerics.precision == Precision::mixed ? 2.0 : 1.0;
  const double peak = lanes * fma_peak(state.kernels.table->isa) * options.threads;
  for (auto _ : bench) sweep.run(state);
  const auto per_second = [&](double items) {
    return benchmark::Counter(items, benchmark::Counter::kIsIterationInvariantRate);
  };
  bench.counters["pairs_per_second"] = per_second(pairs);
  bench.counters["particle_steps_per_second"] = per_second(particles);
  bench.counters["pairs_per_particle"] = pairs / particles;
  bench.counters["flop_per_pair"] = flops;
  bench.counters["peak_share"] = per_second(pairs * flops / peak);
  bench.counters["peak_gflops"] = 1e-9 * peak;
  bench.counters["useful_lane_share"] =
      pairs / (static_cast<double>(state.neighbours.lists.entries()) * state.kernels.cluster_size);
  bench.counters["bytes_per_particle"] =
      static_cast<double>(state.particles.bytes() + state.sweep.records.bytes() +
                          state.sweep.narrow_records.bytes() + state.neighbours.lists.bytes()) /
      particles;
}

void add(const Sweep& sweep, const Body& body, BlockOptions options) {
  options.numerics = body.numerics;
  options.tension = body.tension;
  const std::string block =
      fmt::format("{}d/{}/{}/{}/{}/threads:{}", options.dimension, body.name,
                  word(body.numerics.precision), options.isa, options.particles, options.threads);
  benchmark::RegisterBenchmark(fmt::format("{}/{}", sweep.name, block).c_str(),
                               [=](benchmark::State& bench) { run(bench, sweep, options, block); })
      ->UseRealTime()
      ->Unit(benchmark::kMillisecond);
}

/// What every machine and size is measured by: the body of the targets in the README.
void add_core(const BlockOptions& options) {
  const Body body = plain_body(SmoothingFunction::yang_liu);
  for (const Sweep& sweep : {fused, gradient, force}) add(sweep, body, options);
  add(fused, in_mixed(body), options);
}

void add_bodies(const BlockOptions& options) {
  add(fused, tensile_body(false), options);
  add(fused, tensile_body(true), options);
  for (const SmoothingFunction smoothing :
       {SmoothingFunction::cubic_spline, SmoothingFunction::wendland_c2}) {
    add(fused, plain_body(smoothing), options);
  }
  for (const Sweep& sweep : {gradient, force}) add(sweep, modern_body(), options);
  add(fused, in_mixed(tensile_body(true)), options);
  for (const Sweep& sweep : {gradient, force}) add(sweep, in_mixed(modern_body()), options);
}

}  // namespace

void add_all(bool full) {
  const int all_threads = default_threads();
  std::vector<std::int64_t> sizes{10'000, 176'000};
  if (full) sizes = {10'000, 100'000, 176'000, 1'000'000, 4'000'000};
  for (const int dimension : {3, 2}) {
    for (const std::int64_t particles : sizes) {
      for (const kernels::Isa isa : kernels::available_isas()) {
        const bool best = isa == kernels::available_isas().back();
        for (int threads = 1; threads <= all_threads; threads *= 2) {
          if (!full && !best && (threads > 1 || particles > 10'000)) continue;
          const BlockOptions options{dimension, particles, preset("paper"), threads,
                                     kernels::isa_name(isa)};
          add_core(options);
          if (full || (best && threads == 1)) add_bodies(options);
        }
      }
    }
  }
}

}  // namespace scarp::bench
