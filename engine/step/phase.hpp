// SPDX-License-Identifier: BSD-3-Clause
/// A phase of a step, and what it reads and writes.
#pragma once

#include <cstdint>
#include <span>

#include "engine/particles/field_list.hpp"

namespace scarp {

struct State;

/// What a phase touches besides the fields of the particles: packed records; cells and lists; what
/// walls and their dummies do; the history variables that the soil models declare.
enum class Part { records, lists, walls, history };

/// A set of fields and parts. Fields may be in it that a run does not store.
class DataSet {
 public:
  constexpr DataSet() = default;
  template <class... Item>
  constexpr DataSet(Item... items) : bits_((std::uint64_t{0} | ... | bit(items))) {}

  template <class Item>
  constexpr bool has(Item item) const {
    return (bits_ & bit(item)) != 0;
  }
  constexpr DataSet operator|(DataSet other) const {
    DataSet sum;
    sum.bits_ = bits_ | other.bits_;
    return sum;
  }
  constexpr DataSet operator&(DataSet other) const {
    DataSet common;
    common.bits_ = bits_ & other.bits_;
    return common;
  }
  constexpr DataSet without(DataSet other) const {
    DataSet rest;
    rest.bits_ = bits_ & ~other.bits_;
    return rest;
  }

 private:
  static constexpr int field_count = static_cast<int>(Field::count);
  static_assert(field_count + 4 <= 64);
  static constexpr std::uint64_t bit(Part part) {
    return std::uint64_t{1} << (field_count + static_cast<int>(part));
  }
  static constexpr std::uint64_t bit(Field field) {
    if (field >= declared_field(0)) return bit(Part::history);
    return std::uint64_t{1} << static_cast<int>(field);
  }
  static constexpr std::uint64_t bit(DataSet set) { return set.bits_; }

  std::uint64_t bits_ = 0;
};

/// The fields of the table for which is(row) holds, and the history variables.
template <class Is>
constexpr DataSet fields_where(Is is) {
  DataSet set(Part::history);
  for (const FieldRow& field : field_list) {
    if (is(field)) set = set | DataSet(field.field);
  }
  return set;
}
/// What a sort carries along.
inline constexpr DataSet state_fields =
    fields_where([](const FieldRow& field) { return field.lifetime == Lifetime::state; });
/// What a neighbour reads of a particle.
inline constexpr DataSet ghost_fields =
    fields_where([](const FieldRow& field) { return field.ghost == Ghost::ghost; });

/// `reads` is what has to be current before the phase: of an engine that holds a part of the soil
/// on ghosts too, where the field table says that a neighbour reads the field. `writes` is all that
/// the phase may change. A field of which it changes a part is in both.
struct Phase {
  const char* name;
  DataSet reads, writes;
  void (*run)(State&);
};

using PhaseList = std::span<const Phase>;

}  // namespace scarp
