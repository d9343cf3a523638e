// SPDX-License-Identifier: BSD-3-Clause
/// The compiled kernels of each instruction set, and the run-time choice between them.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "kernels/constitutive/model_passes.hpp"
#include "kernels/pair/term.hpp"
#include "kernels/particle_view.hpp"

namespace scarp::kernels {

struct ModelInfo;

enum class Isa { sse2, avx2, avx512, neon };

/// What a sweep sums in how many dimensions; a kernel compiled for more serves a scene that uses
/// less.
struct SweepVariant {
  int dimension = 3;
  TermSet terms;
  friend bool operator==(const SweepVariant&, const SweepVariant&) = default;
};

template <class Real>
using PairSweep = void (*)(const PairSweepView<Real>&, std::int64_t begin, std::int64_t end);
template <class Real>
using WallSweep = void (*)(const WallSweepView<Real>&, std::int64_t begin, std::int64_t end);
/// Writes the indices of the candidates that are neighbours, in order; returns how many.
using CandidateFilter = int (*)(const CandidateView&, std::int32_t* out);

template <class Real>
struct CompiledSweep {
  SweepVariant variant;
  PairSweep<Real> sweep;
};

/// Everything compiled for one instruction set.
struct KernelTable {
  Isa isa;
  const char* name;
  int cluster_size;                               ///< particles per cluster, double
  int mixed_cluster_size;                         ///< ... of the sweeps in single precision
  std::span<const CompiledSweep<double>> sweeps;  ///< special before general
  std::span<const CompiledSweep<float>> mixed;    ///< the same in single precision
  /// By what it sums and dimension - 2.
  std::array<std::array<WallSweep<double>, 2>, wall_sums_count> wall_sweep;
  std::span<const ModelPasses> passes;  ///< by model of the list
  CandidateFilter filter_candidates;

  /// Of a model of the list, or those that another one brings.
  const ModelPasses& passes_of(const ModelInfo& model) const;
  /// The most special kernel that covers what is asked for, sums gradients and forces only where
  /// both are asked for, and reads the records as they are packed; every table holds general ones
  /// for either. Null: no sweep sums such gradients and forces at once, so that two have to.
  PairSweep<double> sweep_for(const SweepVariant& wanted) const;
  PairSweep<float> mixed_sweep_for(const SweepVariant& wanted) const;
};

/// Each is compiled for the processors that it is an instruction set of (cmake/isa.cmake).
const KernelTable& sse2_kernels();
const KernelTable& avx2_kernels();
const KernelTable& avx512_kernels();
const KernelTable& neon_kernels();

/// Instruction sets of this processor's family, best last.
std::span<const Isa> compiled_isas();
/// Those that this machine can run: the first of them, best last.
std::span<const Isa> available_isas();
/// Pre: it is compiled.
const KernelTable& kernels_of(Isa isa);
/// Of a compiled one.
std::optional<Isa> isa_named(std::string_view name);
const char* isa_name(Isa isa);

}  // namespace scarp::kernels
