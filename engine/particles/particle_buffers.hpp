// SPDX-License-Identifier: BSD-3-Clause
/// Storage of the soil particles: one array per field component, grouped by material.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/particles/aligned_vector.hpp"
#include "engine/particles/field_list.hpp"

namespace scarp {

/// Consecutive particles of one material: slots [first, first + count), padded to `capacity`.
struct ParticleGroup {
  std::int64_t first = 0;
  std::int64_t count = 0;
  std::int64_t capacity = 0;
  std::size_t material = 0;

  std::int64_t end() const { return first + count; }
  std::int64_t padded_end() const { return first + capacity; }
};

/// Slots of a group are a multiple of this: every vector and cluster size divides it.
inline constexpr std::int64_t group_alignment = 16;

constexpr std::int64_t padded(std::int64_t count) {
  return (count + group_alignment - 1) / group_alignment * group_alignment;
}

/// SoA arrays of a chosen set of fields. Padding slots stay at rest far away with density 1.
class ParticleBuffers {
 public:
  ParticleBuffers() = default;
  ParticleBuffers(int dimension, std::vector<ParticleGroup> groups, std::span<const Field> used);

  bool has(Field field) const { return used_[static_cast<std::size_t>(field)]; }
  /// The array of one component, or null where the field is not used or the component not stored.
  double* component(Field field, int index = 0);
  const double* component(Field field, int index = 0) const;
  template <std::size_t N>
  void components(Field field, double* (&out)[N]) {
    for (std::size_t k = 0; k < N; ++k) out[k] = component(field, static_cast<int>(k));
  }
  template <std::size_t N>
  void components(Field field, const double* (&out)[N]) const {
    for (std::size_t k = 0; k < N; ++k) out[k] = component(field, static_cast<int>(k));
  }

  int dimension() const { return dimension_; }
  std::int64_t slots() const { return slots_; }
  std::int64_t count() const;
  const std::vector<ParticleGroup>& groups() const { return groups_; }
  const ParticleGroup& group_of(std::int64_t slot) const;
  std::vector<std::int64_t>& ids() { return ids_; }  ///< permanent id by slot; -1 in padding
  const std::vector<std::int64_t>& ids() const { return ids_; }

  /// Moves slot order[k] to slot first + k within each group, for every field of lifetime `state`.
  void permute(int threads, std::span<const std::int32_t> order);
  std::size_t bytes() const;

 private:
  int dimension_ = 2;
  std::int64_t slots_ = 0;
  std::vector<ParticleGroup> groups_;
  std::array<bool, static_cast<std::size_t>(Field::count)> used_{};
  std::array<std::array<AlignedVector<double>, 9>, static_cast<std::size_t>(Field::count)> data_;
  std::vector<std::int64_t> ids_;
};

}  // namespace scarp
