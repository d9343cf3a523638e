// SPDX-License-Identifier: BSD-3-Clause
/// Fields that are derived from others.
#include "engine/particles/readable.hpp"

#include <algorithm>

namespace scarp {
namespace {

double stored(const ParticleBuffers& particles, Field field, std::int64_t slot, int component) {
  const double* array = particles.component(field, component);
  return array != nullptr ? array[slot] : 0.0;
}

std::int64_t permanent_id(const Readable& from, std::int64_t slot) {
  return from.particles.ids()[static_cast<std::size_t>(slot)];
}

}  // namespace

double Readable::value(const FieldRow& field, std::int64_t slot, int component) const {
  return field.derived != nullptr ? field.derived(*this, slot, component)
                                  : stored(particles, field.field, slot, component);
}

double displacement_of(const Readable& from, std::int64_t slot, int component) {
  return stored(from.particles, Field::position, slot, component) -
         stored(from.particles, Field::reference_position, slot, component);
}

double id_of(const Readable& from, std::int64_t slot, int) {
  return static_cast<double>(permanent_id(from, slot));
}

double material_of(const Readable& from, std::int64_t slot, int) {
  return static_cast<double>(from.particles.group_of(slot).material);
}

double lost_of(const Readable& from, std::int64_t slot, int) {
  return std::binary_search(from.lost_ids.begin(), from.lost_ids.end(), permanent_id(from, slot))
             ? 1.0
             : 0.0;
}

}  // namespace scarp
