// SPDX-License-Identifier: BSD-3-Clause
/// Storage of the particles.
#include "engine/particles/particle_buffers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/particles/readable.hpp"
#include "engine/sweep/chosen_kernels.hpp"
#include "engine/sweep/records.hpp"
#include "engine/sweep/second_lines.hpp"
#include "kernels/pair/term_rows.hpp"

namespace scarp::test {
namespace {

TEST(FieldTableTest, RowsStandInTheOrderOfTheirFieldsUnderNamesOfTheirOwn) {
  std::set<std::string> names;
  for (std::size_t k = 0; k < field_list.size(); ++k) {
    const FieldRow& field = field_list[k];
    EXPECT_EQ(field.field, static_cast<Field>(k)) << field.name;
    EXPECT_TRUE(names.insert(field.name).second) << field.name;
    EXPECT_EQ(field.derived != nullptr, field.lifetime == Lifetime::derived) << field.name;
  }
}

/// Two materials in 2D, a field in every slot, and one that a model declares.
ParticleBuffers filled(const FieldRow& declared) {
  std::vector<Field> used;
  for (const FieldRow& field : field_list) used.push_back(field.field);
  return {2,
          {{{.reference_density = 1500.0, .mass = 2.0}, 0, 3, 16},
           {{.material = 1, .reference_density = 2000.0, .mass = 5.0}, 16, 2, 16}},
          used,
          std::span(&declared, 1)};
}

constexpr FieldRow cohesion_left{declared_field(0),
                                 "cohesion_left",
                                 "Pa",
                                 Rank::scalar,
                                 Lifetime::state,
                                 {Initial::From::value, 5.0},
                                 Reset::reset,
                                 Ghost::own,
                                 Check::each_look,
                                 Readout::real,
                                 "cohesion that slip has left"};

TEST(FieldTableTest, EverySlotBeginsAtTheInitialValueOfItsRow) {
  const ParticleBuffers particles = filled(cohesion_left);
  for (const FieldRow& field : particles.rows()) {
    for (int c = 0; c < component_count(field.rank); ++c) {
      const double* array = particles.component(field.field, c);
      for (std::int64_t k = 0; array != nullptr && k < particles.slots(); ++k) {
        double expected = field.initial.value;
        if (field.initial.from == Initial::From::reference_density)
          expected = k < 16 ? 1500.0 : 2000.0;
        ASSERT_EQ(array[k], expected) << field.name << " in slot " << k;
      }
    }
  }
}

TEST(FieldTableTest, AResetPutsBackTheRowsThatSayItAndNoOthers) {
  ParticleBuffers particles = filled(cohesion_left);
  const auto changed = [](Field field, int c, std::int64_t slot) {
    return 1e3 * static_cast<double>(field) + 100.0 * c + static_cast<double>(slot);
  };
  const auto each = [&](auto&& look) {
    for (const FieldRow& field : particles.rows()) {
      for (int c = 0; c < component_count(field.rank); ++c) {
        double* array = particles.component(field.field, c);
        for (std::int64_t k = 0; array != nullptr && k < particles.slots(); ++k)
          look(field, c, k, array[k]);
      }
    }
  };
  each([&](const FieldRow& field, int c, std::int64_t k, double& value) {
    value = changed(field.field, c, k);
  });
  particles.reset();
  each([&](const FieldRow& field, int c, std::int64_t k, double& value) {
    double expected = changed(field.field, c, k);
    if (field.reset == Reset::reset) expected = field.initial.value;
    if (field.field == Field::reference_position) expected = changed(Field::position, c, k);
    ASSERT_EQ(value, expected) << field.name << " in slot " << k;
  });
}

TEST(FieldTableTest, ADeclaredFieldIsStoredSortedAndReadByItsName) {
  ParticleBuffers particles = filled(cohesion_left);
  ASSERT_TRUE(particles.has(declared_field(0)));
  particles.component(declared_field(0))[2] = 7.0;
  std::vector<std::int32_t> order(32);
  std::iota(order.begin(), order.end(), 0);
  std::swap(order[0], order[2]);
  particles.permute(1, order);
  const std::vector<std::int64_t> none;
  const auto& rows = particles.rows();
  const auto found = std::find_if(rows.begin(), rows.end(), [](const FieldRow& field) {
    return std::string_view(field.name) == "cohesion_left";
  });
  ASSERT_NE(found, rows.end());
  EXPECT_EQ((Readable{particles, none}.value(*found, 0, 0)), 7.0);
  EXPECT_EQ((Readable{particles, none}.value(*found, 1, 0)), 5.0);
}

TEST(FieldTableTest, ACopyThatCarriesTheGhostColumnHasTheRecordsOfItsOriginal) {
  ParticleBuffers original = filled(cohesion_left), copy = filled(cohesion_left);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> number(1.0, 2.0);
  for (const FieldRow& field : original.rows()) {
    for (int c = 0; c < component_count(field.rank); ++c) {
      double *from = original.component(field.field, c), *to = copy.component(field.field, c);
      for (std::int64_t k = 0; from != nullptr && k < original.slots(); ++k) {
        from[k] = number(random);
        to[k] = field.ghost == Ghost::ghost ? from[k] : std::nan("");
      }
    }
  }
  const RecordScaling scaling{3.0, 0.7, {1e7, 4e7}};
  ChosenKernels chosen;
  chosen.settings.yields = true;
  chosen.settings.viscosity_alpha = chosen.settings.artificial_stress =
      chosen.settings.stress_diffusion = 0.3;
  chosen.terms = kernels::used_terms(chosen.settings);
  const kernels::SlotSet read = kernels::slots_read(chosen.terms);
  Records records(original.slots(), 0), of_copy(copy.slots(), 0);
  const ParticleBuffers no_ghosts;
  for (const StressForm form : {StressForm::plain, StressForm::corrected}) {
    records.pack(1, Role::owned, original, scaling, read, form);
    of_copy.pack(1, Role::owned, copy, scaling, read, form);
    EXPECT_TRUE(pack_second_lines(1, {original, no_ghosts}, chosen, records));
    EXPECT_TRUE(pack_second_lines(1, {copy, no_ghosts}, chosen, of_copy));
    for (const ParticleGroup& group : original.groups()) {
      for (std::int64_t k = group.first; k < group.end(); ++k) {
        for (int slot = 0; slot < kernels::record_size; ++slot)
          ASSERT_EQ(records.record(k)[slot], of_copy.record(k)[slot]) << "slot " << slot;
        for (int value = 0; value < kernels::second_record_size; ++value)
          ASSERT_EQ(records.second(k)[value], of_copy.second(k)[value]) << "value " << value;
      }
    }
  }
}

TEST(ParticleBuffersTest, AReSortCarriesTheStateAndNoRates) {
  constexpr Field used[]{Field::density, Field::velocity_gradient};
  ParticleBuffers particles(2, {{{}, 0, 16, 16}}, used);
  std::array<std::int32_t, 16> order{};
  for (std::size_t k = 0; k < 16; ++k) {
    particles.component(Field::density)[k] = static_cast<double>(k);
    particles.component(Field::velocity_gradient, 1)[k] = static_cast<double>(k);
    order[k] = static_cast<std::int32_t>(15 - k);
  }
  particles.permute(1, order);
  EXPECT_EQ(particles.component(Field::density)[0], 15.0);
  EXPECT_EQ(particles.component(Field::velocity_gradient, 1)[0], 0.0);
}

/// Two groups of 20 and 5 particles whose x and id are 100 times the group and the number in it.
ParticleBuffers two_groups() {
  constexpr Field used[]{Field::position, Field::density, Field::acceleration};
  std::vector<ParticleGroup> groups{{{}, 0, 20, 32}, {{}, 32, 5, 16}};
  groups[1].material = 1;
  ParticleBuffers particles(2, groups, used);
  for (const ParticleGroup& group : particles.groups()) {
    for (std::int64_t k = group.first; k < group.end(); ++k) {
      const auto id = static_cast<std::int64_t>(100 * group.material) + k - group.first;
      particles.ids()[static_cast<std::size_t>(k)] = id;
      particles.component(Field::position, 0)[k] = static_cast<double>(id);
      particles.component(Field::density)[k] = 2000.0;
      particles.component(Field::acceleration, 1)[k] = static_cast<double>(-id);
    }
  }
  return particles;
}

/// Whether every particle carries its own x and rate and padding is as it should be.
void expect_sound(const ParticleBuffers& particles, std::size_t count) {
  std::size_t found = 0;
  for (const ParticleGroup& group : particles.groups()) {
    EXPECT_EQ(group.first % group_alignment, 0);
    EXPECT_EQ(group.capacity % group_alignment, 0);
    EXPECT_LE(group.count, group.capacity);
    for (std::int64_t k = group.first; k < group.padded_end(); ++k) {
      const auto id = particles.ids()[static_cast<std::size_t>(k)];
      if (k >= group.end()) {
        EXPECT_EQ(id, -1);
        EXPECT_EQ(particles.component(Field::density)[k], 1.0);
        continue;
      }
      ++found;
      EXPECT_EQ(particles.component(Field::position, 0)[k], static_cast<double>(id));
      EXPECT_EQ(particles.component(Field::acceleration, 1)[k], static_cast<double>(-id));
      EXPECT_EQ(particles.group_of(k).material, group.material);
    }
  }
  EXPECT_EQ(found, count);
  EXPECT_EQ(particles.count(), static_cast<std::int64_t>(count));
  EXPECT_EQ(particles.slots(), particles.groups().back().padded_end());
}

TEST(ParticleBuffersTest, GroupsGrowBeyondTheirCapacity) {
  ParticleBuffers particles = two_groups();
  std::vector<std::int64_t> ids;
  for (std::int64_t id = 1'000'000'000'000; ids.size() < 30; id += 7) ids.push_back(id);
  const std::int64_t first = particles.add(0, ids);
  EXPECT_EQ(first, 20);
  for (std::size_t k = 0; k < ids.size(); ++k) {
    const std::int64_t slot = first + static_cast<std::int64_t>(k);
    EXPECT_EQ(particles.component(Field::density)[slot], 1.0);
    particles.component(Field::position, 0)[slot] = static_cast<double>(ids[k]);
    particles.component(Field::acceleration, 1)[slot] = static_cast<double>(-ids[k]);
  }
  expect_sound(particles, 55);
  EXPECT_EQ(particles.groups()[1].first, 64);
}

TEST(ParticleBuffersTest, WhatFitsMovesNothing) {
  ParticleBuffers particles = two_groups();
  constexpr std::int64_t ids[]{7'000'000};
  const std::int64_t first = particles.add(1, ids);
  EXPECT_EQ(first, 37);
  particles.component(Field::position, 0)[first] = 7'000'000.0;
  particles.component(Field::acceleration, 1)[first] = -7'000'000.0;
  expect_sound(particles, 26);
  EXPECT_EQ(particles.slots(), 48);
}

TEST(ParticleBuffersTest, WhatIsRemovedLeavesNoGapAndGivesUpCapacity) {
  ParticleBuffers particles = two_groups();
  constexpr std::int64_t slots[]{0, 3, 4, 7, 19, 32, 33, 34, 35, 36};
  particles.remove(slots);
  expect_sound(particles, 15);
  EXPECT_EQ(particles.groups()[0].capacity, 16);
  EXPECT_EQ(particles.groups()[1].count, 0);
  EXPECT_EQ(particles.slots(), 16);
  // An empty group takes particles again.
  constexpr std::int64_t ids[]{500};
  const std::int64_t first = particles.add(1, ids);
  EXPECT_EQ(first, 16);
  EXPECT_EQ(particles.group_of(first).material, 1U);
}

TEST(ParticleBuffersTest, SomeGoAndOthersComeAtOnce) {
  ParticleBuffers particles = two_groups();
  constexpr std::int64_t slots[]{1, 2, 36};
  const std::vector<std::int64_t> ids[]{{9'000'001, 9'000'002}, {9'000'003}};
  const std::vector<std::int64_t> first = particles.exchange(slots, ids);
  EXPECT_EQ(first, std::vector<std::int64_t>({18, 36}));
  for (const auto& [slot, id] : {std::pair{18, 9'000'001}, {19, 9'000'002}, {36, 9'000'003}}) {
    EXPECT_EQ(particles.ids()[static_cast<std::size_t>(slot)], id);
    particles.component(Field::position, 0)[slot] = id;
    particles.component(Field::acceleration, 1)[slot] = -id;
  }
  expect_sound(particles, 25);
}

}  // namespace
}  // namespace scarp::test
