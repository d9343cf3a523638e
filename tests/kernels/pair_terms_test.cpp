// SPDX-License-Identifier: BSD-3-Clause
/// What pair terms say of themselves, held against what they do; and a term from outside.
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include <xsimd/xsimd.hpp>

#include "kernels/pair/pair_sweep.hpp"
#include "kernels/pair/term_rows.hpp"
#include "tests/kernels/counted_number.hpp"
#include "tests/kernels/pair_sweep_cases.hpp"

namespace scarp::test {
namespace {

using namespace kernels;

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

ReferenceParticles block(int dimension) {
  BlockOptions options = block_for(dimension);
  options.cells = dimension == 2 ? 8 : 5;
  return random_block(options, 23);
}

/// Outputs of a sweep over everything; NaN where it wrote nothing.
SweepOutput swept(const PackedParticles& packed, const CompiledSweep<double>& compiled) {
  PairSweepView<double> view =
      packed.sweep_view(compiled.variant.terms.has(Term::artificial_stress));
  SweepOutput out(packed.slots());
  out.attach(view);
  compiled.sweep(view, 0, packed.soil_clusters());
  return out;
}

/// Every compiled sweep of the best instruction set with particles in its clusters.
template <class Check>
void each_sweep(Check&& check) {
  const KernelTable& table = kernels_of(available_isas().back());
  for (const CompiledSweep<double>& compiled : table.sweeps) {
    const int dimension = compiled.variant.dimension;
    const ReferenceSettings settings = settings_for(ReferenceSmoothing::cubic_spline, dimension);
    SCOPED_TRACE(std::to_string(dimension) + "D, terms " +
                 std::to_string(compiled.variant.terms.bits));
    check(compiled, PackedParticles(block(dimension), settings, table.cluster_size,
                                    packing_for(compiled.variant.terms)));
  }
}

bool same(SweepOutput& a, SweepOutput& b) {
  return std::memcmp(a.values.data(), b.values.data(), a.values.size() * sizeof(double)) == 0;
}

/// In 2D the third components are not stored, and a corrected stress finds room without the
/// diffusivity.
bool is_used(int slot, const SweepVariant& v) {
  const bool third = slot == record_z || slot == record_velocity_z || slot >= record_stress + 4;
  if (v.dimension == 3 || !third) return true;
  if (v.terms.has(Term::hourglass_viscosity) && slot >= record_stress) return true;
  return slot == record_sound_speed ||
         (slot == record_diffusivity && !v.terms.has(Term::force_correction));
}
/// Slots of dummies that terms read beyond those of soil; 2D has the stress's first four.
SlotSet read_of_dummies(const SweepVariant& v) {
  SlotSet slots;
  for (const TermRow& row : term_rows) {
    if (v.terms.has(row.term)) slots = slots | row.reads_of_dummies;
  }
  return v.dimension == 3 || slots.bits == 0 ? slots : SlotSet{record_stress, 4};
}

TEST(PairTermsTest, ReadNoSlotOfARecordButThoseTheyName) {
  each_sweep([](const CompiledSweep<double>& compiled, PackedParticles packed) {
    SweepOutput clean = swept(packed, compiled);
    const SlotSet read = slots_read(compiled.variant.terms);
    for (std::int64_t k = 0; k < packed.slots(); ++k) {
      for (int slot = 0; slot < record_size; ++slot) {
        const bool of_dummy = (packed.is_dummy(k) || k + 1 == packed.slots()) &&
                              read_of_dummies(compiled.variant).has(slot);
        if (!of_dummy && (!read.has(slot) || !is_used(slot, compiled.variant)))
          packed.record(k)[slot] = not_a_number;
      }
    }
    SweepOutput poisoned = swept(packed, compiled);
    EXPECT_TRUE(same(clean, poisoned));
  });
}

TEST(PairTermsTest, NameNoSlotThatTheyDoNotRead) {
  each_sweep([](const CompiledSweep<double>& compiled, const PackedParticles& packed) {
    SweepOutput clean = swept(packed, compiled);
    const SlotSet read = slots_read(compiled.variant.terms);
    for (int slot = 0; slot < record_size; ++slot) {
      if (!read.has(slot) || !is_used(slot, compiled.variant)) continue;
      // In 2D no force comes of zz; a corrected stress has another component there.
      if (compiled.variant.dimension == 2 && slot == int{record_stress} + int{zz} &&
          !compiled.variant.terms.has(Term::force_correction))
        continue;
      PackedParticles changed = packed;
      for (std::int64_t k = 0; k < changed.slots(); ++k)
        changed.record(k)[slot] *= slot == record_density ? 2.0 : 1.0 + 1e-3;
      SweepOutput out = swept(changed, compiled);
      EXPECT_FALSE(same(clean, out)) << "slot " << slot;
    }
  });
}

TEST(PairTermsTest, WriteTheFieldsTheyNameAndNoOthers) {
  each_sweep([](const CompiledSweep<double>& compiled, const PackedParticles& packed) {
    SweepOutput out = swept(packed, compiled);
    const int dimension = compiled.variant.dimension;
    for (const TermRow& row : term_rows) {
      int place = row.first_output;
      for (const FieldUse& use : row.writes) {
        for (int c = 0; c < use.components; ++c, ++place) {
          const bool third = use.components == 9   ? c / 3 == 2 || c % 3 == 2
                             : use.components == 3 ? c == 2
                                                   : c >= 4;
          // Of the moment zz is left out as well: 2D has no thickness.
          const bool flat = dimension == 2 && (third || (row.term == Term::moment && c == zz));
          const bool written = !std::isnan(out.field(place)[0]);
          EXPECT_EQ(written, compiled.variant.terms.has(row.term) && !flat)
              << row.name << ", " << use.name << " " << c;
        }
      }
    }
  });
}

TEST(PairTermsTest, ChangeNothingButWhatTheyNameAndAddTo) {
  // Sweeps whose sets differ: what both write must agree but for the fields that the terms that one
  // has more name or add to. A term may move the rounding of others, as the densities that the
  // viscosity divides by do.
  each_sweep([](const CompiledSweep<double>& more, const PackedParticles& packed) {
    SweepOutput with = swept(packed, more);
    for (const CompiledSweep<double>& less : kernels_of(available_isas().back()).sweeps) {
      if (less.variant.dimension != more.variant.dimension ||
          packing_for(less.variant.terms) != packing_for(more.variant.terms))
        continue;
      SweepOutput without = swept(packed, less);
      const TermSet difference = more.variant.terms.without(less.variant.terms) |
                                 less.variant.terms.without(more.variant.terms);
      TermSet moved = difference;
      for (const TermRow& row : term_rows) {
        if (difference.has(row.term)) moved = moved | row.adds_to;
      }
      for (const TermRow& row : term_rows) {
        if (moved.has(row.term) || !more.variant.terms.has(row.term)) continue;
        int values = 0;
        for (const FieldUse& use : row.writes) values += use.components;
        for (int c = row.first_output; c < row.first_output + values; ++c) {
          double largest = 0.0;
          for (std::size_t k = 0; k < with.slots; ++k) {
            if (!std::isnan(with.field(c)[k]))
              largest = std::fmax(largest, std::fabs(with.field(c)[k]));
          }
          for (std::size_t k = 0; k < with.slots; ++k) {
            if (!std::isnan(with.field(c)[k])) {
              ASSERT_NEAR(with.field(c)[k], without.field(c)[k], 1e-12 * largest) << row.name;
            }
          }
        }
      }
    }
  });
}

TEST(PairTermsTest, AddNothingWhereTheSecondLineIsZero) {
  // What `marked` is for: a block of pairs without marks may be skipped.
  each_sweep([](const CompiledSweep<double>& compiled, PackedParticles packed) {
    if (!compiled.variant.terms.has(Term::artificial_stress)) return;
    for (std::int64_t k = 0; k < packed.slots(); ++k) {
      std::fill_n(packed.second(k), ArtificialStress::second_slots, 0.0);
      packed.mark(k) = 0;
    }
    SweepOutput skipped = swept(packed, compiled);
    for (std::int64_t k = 0; k < packed.slots(); ++k) packed.mark(k) = 1;
    SweepOutput summed = swept(packed, compiled);
    for (std::size_t n = 0; n < summed.values.size(); ++n) {
      if (!std::isnan(summed.values[n])) {
        ASSERT_EQ(summed.values[n], skipped.values[n]);
      }
    }
  });
}

template <int Dim>
void expect_flops() {
  for (std::uint32_t bits = 0; bits < 1u << term_count; ++bits) {
    TermSet set;
    set.bits = bits;
    EXPECT_EQ(pair_flops(PairTerms{}, Dim, set), counted_flops<Dim>(set)) << "terms " << bits;
  }
}
TEST(PairTermsTest, CostTheFlopsTheyName) {
  expect_flops<2>();
  expect_flops<3>();
}

/// A term that is not the library's: diffusion of a scalar, say of water, which stands in the
/// second line; 2 sum_j V_j (w_i - w_j) (x_ij . grad W)/(r^2 + 0.01 h^2), with lengths in h.
struct ScalarDiffusion : PairTerm {
  static constexpr Term term = static_cast<Term>(term_count);
  static constexpr PairNeeds needs{.regularised = true};
  static constexpr ActsOn acts_on = ActsOn::soil;
  static constexpr std::array writes{FieldUse{"water_rate", 1}};
  static constexpr int second_slots = 1;

  template <class B, int Dim>
  struct Sums {
    B weight_sum = B(0), weighted = B(0);

    template <class Pair>
    void add(Pair& pair) {
      const B weight =
          B(2) * pair.gradient * pair.distance_squared * pair.inverse_regularised_distance();
      weight_sum = weight_sum + weight;
      weighted = fma(weight, pair.template second<ScalarDiffusion>(constant<0>), weighted);
    }
    template <class Own>
    void store(const Own& own, double* const* out) const {
      own.put(out[0],
              own.template second<ScalarDiffusion>(0) * own.fold(weight_sum) - own.fold(weighted));
    }
  };
};
/// In the place of the force correction, whose values fill the second line.
using WithWater = TermList<Continuity, VelocityGradient, Moment, StressDiffusion, ArtificialStress,
                           Momentum, Viscosity, ScalarDiffusion>;

TEST(PairTermsTest, ATermFromOutsideIsSummedWithTheOthers) {
  using Arch = xsimd::default_arch;
  constexpr int size = cluster_size<double, Arch>;
  const ReferenceSettings settings = settings_for(ReferenceSmoothing::cubic_spline, 2);
  const ReferenceParticles particles = block(2);
  PackedParticles packed(particles, settings, size);
  constexpr int place = first_second<WithWater, ScalarDiffusion>,
                output = first_output<WithWater, ScalarDiffusion>;
  ASSERT_EQ(place, 6);  // behind the artificial stress
  for (std::int64_t k = 0; k < packed.slots(); ++k) {
    packed.second(k)[place] = std::sin(3.0 * packed.record(k)[record_x]);
    packed.mark(k) = 1;
  }
  PairSweepView<double> view = packed.sweep_view(true);
  SweepOutput out(packed.slots());
  out.attach(view);
  std::vector<double> water(static_cast<std::size_t>(packed.slots()), not_a_number);
  view.output[output] = water.data();
  constexpr TermSet set{Term::momentum, Term::viscosity, Term::artificial_stress,
                        ScalarDiffusion::term};
  pair_sweep<Arch, double, 2, set, WithWater>(view, 0, packed.soil_clusters());

  const double h = settings.smoothing_length;
  for (std::size_t i = 0; i < particles.soil_count; ++i) {
    ReferenceSum sum;
    const auto scalar = [&](std::size_t k) {
      return std::sin(3.0 * (particles.position[k][0] / h));
    };
    for (std::size_t j = 0; j < particles.size(); ++j) {
      if (i == j || particles.is_wall(j)) continue;
      const double dx = particles.position[i][0] - particles.position[j][0],
                   dy = particles.position[i][1] - particles.position[j][1];
      const double r = std::hypot(dx, dy);
      if (r >= 2.0 * h) continue;
      const double slope = smoothing_slope_reference(settings.smoothing, 2, r, h);
      sum.add(2.0 * particles.volume[j] * slope / settings.lattice_moment * (r / h) /
              ((r / h) * (r / h) + 0.01) * (scalar(i) - scalar(j)));
    }
    // As for the other sums: 64 eps times the terms, of which there are about 20.
    ASSERT_NEAR(water[i], sum.value, 64.0 * epsilon * 25 * sum.largest + 1e-10);
  }
  // The others are summed as without it.
  SweepOutput plain(packed.slots());
  plain.attach(view);
  pair_sweep<Arch, double, 2, TermSet{Term::momentum, Term::viscosity, Term::artificial_stress}>(
      view, 0, packed.soil_clusters());
  EXPECT_TRUE(same(out, plain));
}

}  // namespace
}  // namespace scarp::test
