// SPDX-License-Identifier: BSD-3-Clause
/// Main of all benchmark programs: the options of Google Benchmark, and --full.
#include "bench/bench_main.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstring>

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
