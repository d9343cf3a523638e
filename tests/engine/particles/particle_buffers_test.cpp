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
#include "engine/sweep/records.hpp"

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
  return {2, {{0, 3, 16, 0, 1500.0}, {16, 2, 16, 1, 2000.0}}, used, std::span(&declared, 1)};
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
  const std::vector<bool> none;
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
  const RecordScaling scaling{3.0, 0.7, {2.0, 5.0}, {1e7, 4e7}};
  Records records(original.slots(), 0), of_copy(copy.slots(), 0);
  records.pack_soil(1, original, scaling);
  of_copy.pack_soil(1, copy, scaling);
  EXPECT_EQ(records.pack_tension(1, original, 0.3), of_copy.pack_tension(1, copy, 0.3));
  for (const ParticleGroup& group : original.groups()) {
    for (std::int64_t k = group.first; k < group.end(); ++k) {
      for (int slot = 0; slot < kernels::record_size; ++slot)
        ASSERT_EQ(records.record(k)[slot], of_copy.record(k)[slot]) << "slot " << slot;
    }
  }
}

TEST(ParticleBuffersTest, AReSortCarriesTheStateAndNoRates) {
  constexpr Field used[]{Field::density, Field::velocity_gradient};
  ParticleBuffers particles(2, {{0, 16, 16, 0}}, used);
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

}  // namespace
}  // namespace scarp::test
