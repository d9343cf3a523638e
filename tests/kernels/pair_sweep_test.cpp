// SPDX-License-Identifier: BSD-3-Clause
/// Every compiled pair sweep against the scalar reference.
#include <algorithm>
#include <iterator>
#include <map>
#include <string>

#include "engine/sweep/narrow_records.hpp"
#include "kernels/pair/term_rows.hpp"
#include "tests/kernels/pair_sweep_cases.hpp"

namespace scarp::test {
namespace {

using namespace kernels;

std::string describe(const KernelTable& table, const SweepVariant& v) {
  std::string text = std::string(table.name) + " " + std::to_string(v.dimension) + "D";
  for (const TermRow& row : term_rows) {
    if (v.terms.has(row.term)) text += std::string(", ") + row.name;
  }
  return text;
}

/// Compares one output of all soil particles. Rounding of a sum of N terms: N eps times the
/// largest, times 64 for the terms themselves, whose positions in units of h (up to 16 here) cancel
/// in x_i - x_j.
template <class Pick>
void expect_field(const std::vector<ReferenceRate>& expected, const double* actual,
                  const char* name, double unit, Pick pick) {
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const ReferenceSum sum = pick(expected[i]);
    // A particle pairs with itself at a distance of 1e-15 h, which leaves 1e-15 times a rounding of
    // its stress.
    const double tolerance = 64.0 * unit * (expected[i].neighbours + 1) * sum.largest + 1e-4 * unit;
    ASSERT_NEAR(actual[i], sum.value, tolerance) << name << " of particle " << i;
  }
}

/// `fit_error`: of F^n over the greater of it and 1, for the terms of the artificial stress.
void expect_rates(const std::vector<ReferenceRate>& expected, SweepOutput& out,
                  const SweepVariant& v, double fit_error, double unit = epsilon) {
  const int dim = v.dimension;
  if (v.terms.has(Term::continuity)) {
    expect_field(expected, out.field(SweepOutput::density_rate), "density rate", unit,
                 [](const auto& r) { return r.density_rate; });
  }
  if (v.terms.has(Term::velocity_gradient)) {
    for (int a = 0; a < dim; ++a) {
      for (int b = 0; b < dim; ++b) {
        expect_field(expected, out.field(SweepOutput::velocity_gradient + 3 * a + b),
                     "velocity gradient", unit,
                     [&](const auto& r) { return r.velocity_gradient[3 * a + b]; });
      }
    }
  }
  if (v.terms.has(Term::moment)) {
    for (const int c :
         dim == 2 ? std::vector<int>{xx, yy, xy} : std::vector<int>{xx, yy, zz, xy, yz, zx}) {
      expect_field(expected, out.field(SweepOutput::moment + c), "moment", unit,
                   [&](const auto& r) { return r.moment[c]; });
    }
  }
  if (v.terms.has(Term::diffusion)) {
    for (int c = 0; c < (dim == 2 ? 4 : 6); ++c) {
      expect_field(expected, out.field(SweepOutput::diffusion_rate + c), "diffusion", unit,
                   [&](const auto& r) { return r.diffusion_rate[c]; });
    }
    expect_field(expected, out.field(SweepOutput::diffusion_slope), "diffusion slope", unit,
                 [](const auto& r) { return r.diffusion_slope; });
  }
  if (!v.terms.has(Term::momentum)) return;
  for (int a = 0; a < dim; ++a) {
    for (std::size_t i = 0; i < expected.size(); ++i) {
      const ReferenceRate& rate = expected[i];
      const double tolerance = 64.0 * unit * (rate.neighbours + 1) * rate.acceleration[a].largest +
                               fit_error * 2 * rate.neighbours * dim * rate.largest_artificial;
      ASSERT_NEAR(out.field(SweepOutput::acceleration + a)[i], rate.acceleration[a].value,
                  tolerance)
          << "acceleration of particle " << i;
    }
  }
  if (!v.terms.has(Term::viscosity)) return;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    ASSERT_NEAR(out.field(SweepOutput::approach_rate)[i], expected[i].approach_rate,
                450.0 * unit * expected[i].approach_rate)
        << "approach rate of particle " << i;
  }
}

/// Every fourth dummy is an inner point, without a volume: only terms of walls are summed over it.
ReferenceParticles with_inner_points(ReferenceParticles p) {
  for (std::size_t k = 0; k < p.size(); ++k) {
    if (p.is_wall(k) && k % 4 == 0) p.volume[k] = 0.0;
  }
  return p;
}

/// Particles without the parts that a variant does not use.
std::vector<ReferenceRate> reference_for(ReferenceParticles p, ReferenceSettings s, TermSet terms) {
  s.corrected = packing_for(terms) != Packing::plain;
  if (!terms.has(Term::hourglass_viscosity)) s.hourglass_viscosity = 0.0;
  if (!terms.has(Term::viscosity)) s.viscosity_alpha = s.viscosity_beta = 0.0;
  if (!terms.has(Term::artificial_stress)) {
    for (auto& r : p.artificial_stress) r = {};
  }
  return pair_sweep_reference(p, s);
}

class PairSweepTest : public testing::TestWithParam<SweepCase> {
 protected:
  const int dimension_ = std::get<1>(GetParam());
  const ReferenceSettings settings_ = settings_for(std::get<0>(GetParam()), dimension_);
  const ReferenceParticles particles_ = with_inner_points(random_block(block_for(dimension_), 7));
  // Largest error of the fit of F^n for n = 2.55 (artificial_stress_test holds it to this).
  const double fit_error_ = std::get<0>(GetParam()) == ReferenceSmoothing::yang_liu       ? 2e-7
                            : std::get<0>(GetParam()) == ReferenceSmoothing::cubic_spline ? 7e-6
                                                                                          : 1.5e-4;
};

TEST_P(PairSweepTest, EveryCompiledVariantAgreesWithTheReference) {
  std::map<std::uint32_t, std::vector<ReferenceRate>> references;  // by terms
  for (const Isa isa : available_isas()) {
    const KernelTable& table = kernels_of(isa);
    for (const CompiledSweep<double>& compiled : table.sweeps) {
      const SweepVariant& v = compiled.variant;
      if (v.dimension != dimension_) continue;
      SCOPED_TRACE(describe(table, v));
      const PackedParticles packed(particles_, settings_, table.cluster_size, packing_for(v.terms));
      PairSweepView<double> view = packed.sweep_view(v.terms.has(Term::artificial_stress));
      SweepOutput out(packed.slots());
      out.attach(view);
      compiled.sweep(view, 0, packed.soil_clusters());
      std::vector<ReferenceRate>& expected = references[v.terms.bits];
      if (expected.empty()) expected = reference_for(particles_, settings_, v.terms);
      expect_rates(expected, out, v, fit_error_);
    }
  }
}

/// Single precision: 24 bits of every quantity and positions to 2^-19 h, which is 55 units of 24
/// bits at the smallest distance here, 0.5 h. The terms' derivatives take a few times that.
constexpr double mixed_epsilon = 8.0 * 0x1p-24;

TEST_P(PairSweepTest, EveryMixedVariantAgreesToSinglePrecision) {
  for (const Isa isa : available_isas()) {
    const KernelTable& table = kernels_of(isa);
    for (const CompiledSweep<float>& compiled : table.mixed) {
      const SweepVariant& v = compiled.variant;
      if (v.dimension != dimension_) continue;
      SCOPED_TRACE(describe(table, v));
      const PackedParticles packed(particles_, settings_, table.mixed_cluster_size,
                                   packing_for(v.terms));
      PairSweepView<double> wide = packed.sweep_view(v.terms.has(Term::artificial_stress));
      SweepOutput out(packed.slots());
      out.attach(wide);
      NarrowRecords narrow;
      compiled.sweep(narrow.narrow(1, wide, packed.slots() - 1), 0, packed.soil_clusters());
      expect_rates(reference_for(particles_, settings_, v.terms), out, v, 1e-6 + fit_error_,
                   mixed_epsilon);
    }
  }
}

/// Three materials, one for each sixteen particles of soil, which every cluster size divides, and
/// one for each image.
TEST_P(PairSweepTest, StressDiffusesBetweenNeighboursOfOneMaterial) {
  ReferenceParticles particles = particles_;
  for (std::size_t k = 0; k < particles.size(); ++k)
    particles.material.push_back(static_cast<int>(k < particles.soil_count ? k / 16 % 3 : k % 3));
  const std::vector<ReferenceRate> expected = pair_sweep_reference(particles, settings_),
                                   of_one = pair_sweep_reference(particles_, settings_);
  ASSERT_NE(expected[0].diffusion_rate[0].value, of_one[0].diffusion_rate[0].value);
  constexpr TermSet diffusion{Term::diffusion};
  for (const Isa isa : available_isas()) {
    const KernelTable& table = kernels_of(isa);
    for (const CompiledSweep<double>& compiled : table.sweeps) {
      const SweepVariant& v = compiled.variant;
      if (v.dimension != dimension_ || !v.terms.covers(diffusion)) continue;
      SCOPED_TRACE(describe(table, v));
      const PackedParticles packed(particles, settings_, table.cluster_size, packing_for(v.terms));
      PairSweepView<double> view = packed.sweep_view(v.terms.has(Term::artificial_stress));
      SweepOutput out(packed.slots());
      out.attach(view);
      compiled.sweep(view, 0, packed.soil_clusters());
      expect_rates(expected, out, {dimension_, diffusion}, 0.0);
    }
    for (const CompiledSweep<float>& compiled : table.mixed) {
      const SweepVariant& v = compiled.variant;
      if (v.dimension != dimension_ || !v.terms.covers(diffusion)) continue;
      SCOPED_TRACE(describe(table, v));
      const PackedParticles packed(particles, settings_, table.mixed_cluster_size,
                                   packing_for(v.terms));
      PairSweepView<double> wide = packed.sweep_view(v.terms.has(Term::artificial_stress));
      SweepOutput out(packed.slots());
      out.attach(wide);
      NarrowRecords narrow;
      compiled.sweep(narrow.narrow(1, wide, packed.slots() - 1), 0, packed.soil_clusters());
      expect_rates(expected, out, {dimension_, diffusion}, 0.0, mixed_epsilon);
    }
  }
}

TEST_P(PairSweepTest, MixedSweepsKnowNoOrigin) {
  // The block 1000 smoothing lengths away. Floats would know such positions to 6e-5 h.
  const double away = 1000.0 * settings_.smoothing_length;
  ReferenceParticles moved = particles_;
  for (std::size_t k = 0; k < moved.size(); ++k) moved.position[k][0] += away;
  const KernelTable& table = kernels_of(available_isas().back());
  std::vector<std::vector<double>> results;
  for (const ReferenceParticles* p :
       {&particles_, static_cast<const ReferenceParticles*>(&moved)}) {
    const PackedParticles packed(*p, settings_, table.mixed_cluster_size);
    PairSweepView<double> wide = packed.sweep_view(false);
    SweepOutput out(packed.slots());
    out.attach(wide);
    NarrowRecords narrow;
    table.mixed_sweep_for({dimension_, {Term::momentum, Term::viscosity}})(
        narrow.narrow(1, wide, packed.slots() - 1), 0, packed.soil_clusters());
    results.emplace_back(out.field(SweepOutput::acceleration),
                         out.field(SweepOutput::acceleration) + p->soil_count);
  }
  // Rounding of the double positions at 1000 h moves some of them to the next step.
  for (std::size_t i = 0; i < particles_.soil_count; ++i)
    EXPECT_NEAR(results[0][i], results[1][i], 1e-5 * std::fabs(results[0][i]) + 1e-2);
}

TEST_P(PairSweepTest, GeneralVariantsServeScenesThatUseLess) {
  ReferenceSettings inviscid = settings_;
  inviscid.viscosity_alpha = inviscid.viscosity_beta = 0.0;
  const std::vector<ReferenceRate> expected = reference_for(particles_, settings_, {});
  for (const Isa isa : available_isas()) {
    const KernelTable& table = kernels_of(isa);
    const PackedParticles packed(particles_, inviscid, table.cluster_size);
    for (const CompiledSweep<double>& compiled : table.sweeps) {
      // Those that correct read other records, and serve only scenes that do.
      if (compiled.variant.dimension != dimension_ ||
          packing_for(compiled.variant.terms) != Packing::plain)
        continue;
      SCOPED_TRACE(describe(table, compiled.variant));
      PairSweepView<double> view = packed.sweep_view(false);
      SweepOutput out(packed.slots());
      out.attach(view);
      compiled.sweep(view, 0, packed.soil_clusters());
      constexpr TermSet plain{Term::continuity, Term::velocity_gradient, Term::momentum};
      expect_rates(expected, out, {dimension_, compiled.variant.terms & plain}, 0.0);
    }
  }
}

TEST_P(PairSweepTest, LeavesOutWhatNobodyAsksForAndNothingElseChanges) {
  for (const Isa isa : available_isas()) {
    const KernelTable& table = kernels_of(isa);
    for (const CompiledSweep<double>& compiled : table.sweeps) {
      const SweepVariant& v = compiled.variant;
      if (v.dimension != dimension_) continue;
      SCOPED_TRACE(describe(table, v));
      const PackedParticles packed(particles_, settings_, table.cluster_size, packing_for(v.terms));
      PairSweepView<double> view = packed.sweep_view(v.terms.has(Term::artificial_stress));
      compiled.sweep(view, 0, packed.soil_clusters());  // every pointer is null
      SweepOutput all(packed.slots());
      all.attach(view);
      compiled.sweep(view, 0, packed.soil_clusters());
      for (int wanted = 0; wanted < SweepOutput::count; ++wanted) {
        PairSweepView<double> single = packed.sweep_view(v.terms.has(Term::artificial_stress));
        SweepOutput one(packed.slots());
        single.output[wanted] = one.field(wanted);
        compiled.sweep(single, 0, packed.soil_clusters());
        for (std::size_t i = 0; i < particles_.soil_count; ++i) {
          const double a = one.field(wanted)[i], b = all.field(wanted)[i];
          ASSERT_TRUE(a == b || (std::isnan(a) && std::isnan(b)))
              << "output " << wanted << " particle " << i;
        }
      }
    }
  }
}

TEST_P(PairSweepTest, WritesOnlyItsOwnClusters) {
  for (const Isa isa : available_isas()) {
    const KernelTable& table = kernels_of(isa);
    const PackedParticles packed(particles_, settings_, table.cluster_size);
    PairSweepView<double> view = packed.sweep_view(true);
    SweepOutput out(packed.slots());
    out.attach(view);
    table.sweep_for({dimension_, {Term::momentum, Term::viscosity, Term::artificial_stress}})(view,
                                                                                              3, 5);
    for (std::int64_t slot = 0; slot < packed.slots(); ++slot) {
      const bool inside = slot >= 3 * table.cluster_size && slot < 5 * table.cluster_size;
      ASSERT_EQ(std::isnan(out.field(SweepOutput::acceleration)[slot]), !inside)
          << table.name << " slot " << slot;
    }
  }
}

TEST_P(PairSweepTest, SweepsTheActiveClustersAlone) {
  for (const Isa isa : available_isas()) {
    const KernelTable& table = kernels_of(isa);
    const PackedParticles packed(particles_, settings_, table.cluster_size);
    PairSweepView<double> view = packed.sweep_view(false);
    SweepOutput all(packed.slots()), some(packed.slots());
    const PairSweep<double> sweep =
        table.sweep_for({dimension_, {Term::momentum, Term::viscosity}});
    all.attach(view);
    sweep(view, 0, packed.soil_clusters());
    const std::int32_t active[]{1, 2, 5, 9};
    view.clusters = active;
    some.attach(view);
    sweep(view, 0, std::ssize(active));
    for (std::int64_t slot = 0; slot < packed.slots(); ++slot) {
      const bool awake = std::ranges::count(active, slot / table.cluster_size) != 0;
      const double value = some.field(SweepOutput::acceleration)[slot];
      ASSERT_EQ(std::isnan(value), !awake) << table.name << " slot " << slot;
      if (awake) {
        ASSERT_EQ(value, all.field(SweepOutput::acceleration)[slot]);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(AllFunctions, PairSweepTest, all_sweep_cases(), name_of_case);

}  // namespace
}  // namespace scarp::test
