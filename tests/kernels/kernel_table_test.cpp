// SPDX-License-Identifier: BSD-3-Clause
/// Run-time choice of instruction set and sweep.
#include "kernels/isa/kernel_table.hpp"

#include <gtest/gtest.h>

#include <utility>

#include "kernels/constitutive/model_info.hpp"

namespace scarp::test {
namespace {

using namespace kernels;

TEST(KernelTableTest, NamesAreTheirOwnInverse) {
  for (const Isa isa : {Isa::sse2, Isa::avx2, Isa::avx512})
    EXPECT_EQ(isa_named(isa_name(isa)), isa);
  EXPECT_EQ(isa_named("avx"), std::nullopt);
  EXPECT_EQ(isa_named(""), std::nullopt);
}

TEST(KernelTableTest, EveryMachineHasSse2First) {
  ASSERT_FALSE(available_isas().empty());
  EXPECT_EQ(available_isas().front(), Isa::sse2);
  for (const Isa isa : available_isas()) EXPECT_EQ(kernels_of(isa).isa, isa);
}

TEST(KernelTableTest, EveryRequestIsCoveredByTheSameOrMore) {
  const bool both[] = {false, true};
  for (const Isa isa : {Isa::sse2, Isa::avx2, Isa::avx512}) {
    const KernelTable& table = kernels_of(isa);
    for (const int dimension : {2, 3}) {
      for (const Terms terms : {Terms::fused, Terms::gradient, Terms::force}) {
        for (const bool viscosity : both) {
          for (const bool artificial_stress : both) {
            for (const auto& [correction, diffusion] :
                 {std::pair{false, false}, {true, false}, {false, true}, {true, true}}) {
              // A gradient sweep has no forces and a force sweep no gradients to correct.
              if (terms == Terms::gradient && (viscosity || artificial_stress)) continue;
              if (terms == Terms::force && (correction || diffusion)) continue;
              const bool continuity = terms != Terms::force && !correction;
              const SweepVariant wanted{dimension,  terms,     viscosity, artificial_stress,
                                        correction, diffusion, continuity};
              const PairSweep<double> sweep = table.sweep_for(wanted);
              ASSERT_NE(sweep, nullptr);
              const SweepVariant* have = nullptr;
              for (const CompiledSweep<double>& compiled : table.sweeps) {
                if (compiled.sweep == sweep) have = &compiled.variant;
              }
              ASSERT_NE(have, nullptr);
              EXPECT_EQ(have->dimension, dimension);
              EXPECT_EQ(have->terms, terms);
              EXPECT_GE(have->viscosity, viscosity);
              EXPECT_GE(have->artificial_stress, artificial_stress);
              EXPECT_GE(have->correction, correction);
              EXPECT_GE(have->diffusion, diffusion);
              EXPECT_GE(have->continuity, continuity);
              // Nothing more special that covers it was passed over.
              for (const CompiledSweep<double>& compiled : table.sweeps) {
                if (compiled.variant == wanted) {
                  EXPECT_EQ(compiled.sweep, sweep);
                }
              }
            }
          }
        }
      }
    }
  }
}

TEST(KernelTableTest, StaysSmall) {
  for (const Isa isa : {Isa::sse2, Isa::avx2, Isa::avx512}) {
    EXPECT_LE(kernels_of(isa).sweeps.size(), 28u) << isa_name(isa);
    EXPECT_GT(kernels_of(isa).cluster_size, 0);
  }
  EXPECT_LT(kernels_of(Isa::sse2).sweeps.size(), 8u);
}

TEST(KernelTableTest, EveryEntryIsThere) {
  for (const Isa isa : {Isa::sse2, Isa::avx2, Isa::avx512}) {
    const KernelTable& table = kernels_of(isa);
    for (const std::size_t d : {0u, 1u}) {
      EXPECT_NE(table.wall_sweep[d], nullptr);
      for (const ModelInfo& model : models) {
        EXPECT_NE(table.passes_of(model).verlet[d], nullptr) << model.name;
        EXPECT_NE(table.passes_of(model).stress[d], nullptr) << model.name;
      }
    }
    EXPECT_NE(table.filter_candidates, nullptr);
  }
}

}  // namespace
}  // namespace scarp::test
