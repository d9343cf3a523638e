// SPDX-License-Identifier: BSD-3-Clause
/// Run-time choice of instruction set and sweep.
#include "kernels/isa/kernel_table.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "kernels/pair/term_rows.hpp"

#include "kernels/constitutive/model_info.hpp"

namespace scarp::test {
namespace {

using namespace kernels;

TEST(KernelTableTest, NamesAreTheirOwnInverse) {
  for (const Isa isa : compiled_isas()) EXPECT_EQ(isa_named(isa_name(isa)), isa);
  EXPECT_EQ(isa_named("avx"), std::nullopt);
  EXPECT_EQ(isa_named(""), std::nullopt);
}

TEST(KernelTableTest, EveryMachineHasTheFirst) {
  ASSERT_FALSE(available_isas().empty());
  ASSERT_LE(available_isas().size(), compiled_isas().size());
  EXPECT_EQ(available_isas().front(), compiled_isas().front());
  for (const Isa isa : available_isas()) EXPECT_EQ(kernels_of(isa).isa, isa);
}

TEST(KernelTableTest, ASceneIsNeverServedByASweepThatReadsOtherRecords) {
  const KernelTable& table = kernels_of(available_isas().back());
  const PairSweep<double> plain = table.sweep_for({3, {Term::momentum}}),
                          corrected =
                              table.sweep_for({3, {Term::momentum, Term::force_correction}});
  ASSERT_NE(plain, nullptr);
  ASSERT_NE(corrected, nullptr);
  EXPECT_NE(plain, corrected);
  EXPECT_NE(table.sweep_for({3, {Term::velocity_gradient, Term::moment}}),
            table.sweep_for({3, {Term::velocity_gradient, Term::moment, Term::wall_gradient}}));
}

/// Every set of terms that some scene sums.
std::vector<TermSet> all_scenes() {
  std::vector<TermSet> sets;
  for (const int correction : {0, 1, 2}) {
    for (const double diffusion : {0.0, 0.1}) {
      for (const double viscosity : {0.0, 0.1}) {
        for (const double stress : {0.0, 0.3}) {
          TermSettings settings;
          settings.gradient_correction = correction > 0;
          settings.force_correction = correction > 1;
          settings.yields = true;
          settings.stress_diffusion = diffusion;
          settings.viscosity_alpha = viscosity;
          settings.artificial_stress = stress;
          sets.push_back(used_terms(settings));
        }
      }
    }
  }
  return sets;
}

template <class Real>
void expect_most_special(std::span<const CompiledSweep<Real>> sweeps, PairSweep<Real> chosen,
                         const SweepVariant& wanted) {
  ASSERT_NE(chosen, nullptr);
  const SweepVariant* have = nullptr;
  for (const CompiledSweep<Real>& compiled : sweeps) {
    if (compiled.sweep == chosen) have = &compiled.variant;
  }
  ASSERT_NE(have, nullptr);
  EXPECT_EQ(have->dimension, wanted.dimension);
  EXPECT_TRUE(have->terms.covers(wanted.terms));
  const int work = pair_flops(PairTerms{}, wanted.dimension, have->terms);
  for (const CompiledSweep<Real>& other : sweeps) {
    constexpr TermSet other_records{Term::wall_gradient, Term::force_correction};
    if (other.variant.dimension != wanted.dimension || !other.variant.terms.covers(wanted.terms) ||
        !((other.variant.terms & other_records) == (wanted.terms & other_records)))
      continue;
    // Nothing more special that covers it was passed over; a half is never summed with the other.
    if (gradient_terms(other.variant.terms) == other.variant.terms ||
        force_terms(other.variant.terms) == other.variant.terms) {
      EXPECT_LE(work, pair_flops(PairTerms{}, wanted.dimension, other.variant.terms));
    }
  }
}

TEST(KernelTableTest, EveryHalfOfEverySceneIsCoveredByTheMostSpecialKernel) {
  for (const Isa isa : compiled_isas()) {
    const KernelTable& table = kernels_of(isa);
    for (const int dimension : {2, 3}) {
      for (const TermSet scene : all_scenes()) {
        for (const TermSet half : {gradient_terms(scene), force_terms(scene)}) {
          const SweepVariant wanted{dimension, half};
          expect_most_special(table.sweeps, table.sweep_for(wanted), wanted);
          expect_most_special(table.mixed, table.mixed_sweep_for(wanted), wanted);
        }
      }
    }
  }
}

TEST(KernelTableTest, ASweepOfBothHalvesSumsBothOrIsNotThere) {
  constexpr TermSet halves{Term::velocity_gradient, Term::momentum};
  for (const Isa isa : compiled_isas()) {
    const KernelTable& table = kernels_of(isa);
    for (const TermSet scene : all_scenes()) {
      const PairSweep<double> sweep = table.sweep_for({3, scene});
      for (const CompiledSweep<double>& compiled : table.sweeps) {
        if (sweep != nullptr && compiled.sweep == sweep) {
          EXPECT_TRUE(compiled.variant.terms.covers(scene | halves));
        }
      }
    }
    // Verlet's sweep of the preset "paper" is one in every set.
    const TermSet paper{Term::continuity, Term::velocity_gradient, Term::momentum, Term::viscosity,
                        Term::artificial_stress};
    EXPECT_NE(table.sweep_for({2, paper}), nullptr);
    EXPECT_NE(table.mixed_sweep_for({3, paper}), nullptr);
  }
}

TEST(KernelTableTest, StaysSmall) {
  for (const Isa isa : compiled_isas()) {
    const KernelTable& table = kernels_of(isa);
    EXPECT_LE(table.sweeps.size() + table.mixed.size(), 38u) << isa_name(isa);
    EXPECT_GT(table.cluster_size, 0);
  }
  // A set that a machine only has besides a better one needs no special kernels.
  if (compiled_isas().size() > 1) {
    EXPECT_LE(kernels_of(compiled_isas().front()).sweeps.size(), 10u);
  }
}

TEST(KernelTableTest, EveryEntryIsThere) {
  for (const Isa isa : compiled_isas()) {
    const KernelTable& table = kernels_of(isa);
    for (const std::size_t d : {0u, 1u}) {
      for (const auto& sweeps : table.wall_sweep) EXPECT_NE(sweeps[d], nullptr);
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
