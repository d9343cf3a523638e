// SPDX-License-Identifier: BSD-3-Clause
/// Run-time choice of instruction set and sweep.
#include "kernels/isa/kernel_table.hpp"

#include "kernels/constitutive/model_info.hpp"

namespace scarp::kernels {

namespace {

/// Terms with which the records hold something else: a sweep with them serves no scene without.
constexpr TermSet other_records{Term::wall_gradient, Term::force_correction};

template <class Real>
PairSweep<Real> first_that_covers(std::span<const CompiledSweep<Real>> sweeps,
                                  const SweepVariant& wanted) {
  constexpr TermSet alike = TermSet{Term::velocity_gradient, Term::momentum} | other_records;
  for (const CompiledSweep<Real>& candidate : sweeps) {
    const SweepVariant& have = candidate.variant;
    if (have.dimension == wanted.dimension && (have.terms & alike) == (wanted.terms & alike) &&
        have.terms.covers(wanted.terms))
      return candidate.sweep;
  }
  return nullptr;
}

}  // namespace

const ModelPasses& KernelTable::passes_of(const ModelInfo& model) const {
  if (model.passes != nullptr) return *model.passes;
  std::size_t index = 0;
  while (models.at(index).name != model.name) ++index;
  return passes[index];
}
PairSweep<double> KernelTable::sweep_for(const SweepVariant& wanted) const {
  return first_that_covers(sweeps, wanted);
}
PairSweep<float> KernelTable::mixed_sweep_for(const SweepVariant& wanted) const {
  return first_that_covers(mixed, wanted);
}

#if defined(__aarch64__)
std::span<const Isa> compiled_isas() {
  static constexpr Isa all[]{Isa::neon};
  return all;
}
std::span<const Isa> available_isas() { return compiled_isas(); }

const KernelTable& kernels_of(Isa) { return neon_kernels(); }
#else
std::span<const Isa> compiled_isas() {
  static constexpr Isa all[]{Isa::sse2, Isa::avx2, Isa::avx512};
  return all;
}
std::span<const Isa> available_isas() {
  const bool avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  const bool avx512 = avx2 && __builtin_cpu_supports("avx512f") &&
                      __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
                      __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512vl");
  return compiled_isas().first(avx512 ? 3 : avx2 ? 2 : 1);
}

const KernelTable& kernels_of(Isa isa) {
  switch (isa) {
    case Isa::avx512:
      return avx512_kernels();
    case Isa::avx2:
      return avx2_kernels();
    default:
      return sse2_kernels();
  }
}
#endif

const char* isa_name(Isa isa) { return kernels_of(isa).name; }

std::optional<Isa> isa_named(std::string_view name) {
  for (const Isa isa : compiled_isas()) {
    if (name == isa_name(isa)) return isa;
  }
  return std::nullopt;
}

}  // namespace scarp::kernels
