// SPDX-License-Identifier: BSD-3-Clause
/// Storage of the soil particles: one array per field component, grouped by material.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "engine/particles/aligned_vector.hpp"
#include "engine/particles/field_list.hpp"

namespace scarp {

/// Particles of one kind.
struct ParticleKind {
  std::size_t material = 0;
  double reference_density = 1.0;  ///< [kg/m3]
  double spacing = 0.0;            ///< dx [m]
  double smoothing_length = 0.0;   ///< h [m]
  double volume = 0.0;             ///< dx^d [m3, m2 in 2D]
  double mass = 0.0;               ///< what weighs, and what density counts [kg, per metre in 2D]
  double mass_scaling = 1.0;       ///< inertia over mass. Equation: I2

  double inertia() const { return mass * mass_scaling; }
  /// What the weight alone accelerates it by.
  std::array<double, 3> fall(const std::array<double, 3>& gravity) const {
    return {gravity[0] / mass_scaling, gravity[1] / mass_scaling, gravity[2] / mass_scaling};
  }
};

/// Consecutive particles of one kind: slots [first, first + count), padded to `capacity`.
struct ParticleGroup : ParticleKind {
  std::int64_t first = 0;
  std::int64_t count = 0;
  std::int64_t capacity = 0;

  std::int64_t end() const { return first + count; }
  std::int64_t padded_end() const { return first + capacity; }
};

/// Slots of a group are a multiple of this: every vector and cluster size divides it.
inline constexpr std::int64_t group_alignment = 16;

/// Calls f(group, begin, end) for each group's part of the slots [begin, end), padding included.
template <class F>
void each_group(std::span<const ParticleGroup> groups, std::int64_t begin, std::int64_t end,
                F&& f) {
  for (const ParticleGroup& group : groups) {
    const std::int64_t from = std::max(begin, group.first), to = std::min(end, group.padded_end());
    if (from < to) f(group, from, to);
  }
}

constexpr std::int64_t padded(std::int64_t count) {
  return (count + group_alignment - 1) / group_alignment * group_alignment;
}

/// SoA arrays of the fields that a run uses. Padding slots keep the initial value of each field.
class ParticleBuffers {
 public:
  ParticleBuffers() = default;
  /// `declared`: rows of fields beyond `field_list`, which soil models bring along; the k-th is
  /// the field `declared_field(k)`.
  ParticleBuffers(int dimension, std::vector<ParticleGroup> groups, std::span<const Field> used,
                  std::span<const FieldRow> declared = {});

  /// The fields of the run in the table's order: stored and declared ones, then derived ones.
  const std::vector<FieldRow>& rows() const { return rows_; }
  bool has(Field field) const;
  /// The array of a declared scalar field by its name. Pre: it is there.
  double* declared(std::string_view name);
  const double* declared(std::string_view name) const;
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
  double largest_spacing() const;                    ///< of the groups [m]
  double mass() const;                               ///< of all particles [kg]
  double inertia() const;                            ///< of all particles [kg]
  std::vector<std::int64_t>& ids() { return ids_; }  ///< permanent id by slot; -1 in padding
  const std::vector<std::int64_t>& ids() const { return ids_; }

  /// Adds particles with these ids behind those of a group and returns the slot of the first. Their
  /// fields have the initial values. Slots of the groups behind may move.
  std::int64_t add(std::size_t group, std::span<const std::int64_t> new_ids);
  /// Removes the particles in these slots, which ascend. Those behind close up and groups give up
  /// capacity they no longer need; a group without particles stays.
  void remove(std::span<const std::int64_t> slots);

  /// Both at once: removes these slots and adds so many particles to each group, with the ids of
  /// `new_ids` by group. Returns the slot of the first that was added to each.
  std::vector<std::int64_t> exchange(std::span<const std::int64_t> slots,
                                     std::span<const std::vector<std::int64_t>> new_ids);

  /// Moves slot order[k] to slot first + k within each group, for every field of lifetime `state`.
  void permute(int threads, std::span<const std::int32_t> order);
  /// Gives the fields that count from the present position their start; where particles are put.
  void start_from_here();
  /// Puts the initial value back into every field that is reset at the end of a stage.
  void reset();
  std::size_t bytes() const;

 private:
  void put_initial(const FieldRow& field);
  /// Puts the particle of slot from[k] into slot k of new groups; below 0: there is none.
  void rearrange(std::vector<ParticleGroup> groups, std::span<const std::int64_t> from);

  int dimension_ = 2;
  std::int64_t slots_ = 0;
  std::vector<ParticleGroup> groups_;
  std::vector<FieldRow> rows_;
  /// By field; without particles as well, so that nothing is found there.
  std::vector<std::array<RawVector<double>, 9>> data_{static_cast<std::size_t>(Field::count)};
  std::vector<std::int64_t> ids_;
};

}  // namespace scarp
