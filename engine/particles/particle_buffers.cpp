// SPDX-License-Identifier: BSD-3-Clause
/// Storage of the soil particles.
#include "engine/particles/particle_buffers.hpp"

#include <algorithm>
#include <utility>

#include "engine/parallel.hpp"

namespace scarp {

ParticleBuffers::ParticleBuffers(int dimension, std::vector<ParticleGroup> groups,
                                 std::span<const Field> used)
    : dimension_(dimension), groups_(std::move(groups)) {
  for (const ParticleGroup& group : groups_) slots_ += group.capacity;
  ids_.assign(static_cast<std::size_t>(slots_), -1);
  for (const Field field : used) {
    const auto index = static_cast<std::size_t>(field);
    used_[index] = true;
    const double padding = field == Field::density || field == Field::previous_density ? 1.0 : 0.0;
    for (int c = 0; c < component_count(row(field).rank); ++c) {
      if (stores_component(row(field).rank, c, dimension)) {
        data_[index][static_cast<std::size_t>(c)].assign(static_cast<std::size_t>(slots_), padding);
      }
    }
  }
}

const double* ParticleBuffers::component(Field field, int index) const {
  const auto& array = data_[static_cast<std::size_t>(field)][static_cast<std::size_t>(index)];
  return array.empty() ? nullptr : array.data();
}

double* ParticleBuffers::component(Field field, int index) {
  return const_cast<double*>(std::as_const(*this).component(field, index));
}

std::int64_t ParticleBuffers::count() const {
  std::int64_t sum = 0;
  for (const ParticleGroup& group : groups_) sum += group.count;
  return sum;
}

const ParticleGroup& ParticleBuffers::group_of(std::int64_t slot) const {
  return *std::find_if(groups_.begin(), groups_.end(),
                       [slot](const ParticleGroup& group) { return slot < group.padded_end(); });
}

void ParticleBuffers::permute(int threads, std::span<const std::int32_t> order) {
  const auto gather = [&](auto& array) {
    auto sorted = array;
    parallel_chunks(threads, slots_, particle_chunk, [&](std::int64_t begin, std::int64_t end) {
      for (std::int64_t k = begin; k < end; ++k) {
        sorted[static_cast<std::size_t>(k)] =
            array[static_cast<std::size_t>(order[static_cast<std::size_t>(k)])];
      }
    });
    array.swap(sorted);
  };
  for (const FieldRow& field : field_list) {
    if (field.lifetime != Lifetime::state) continue;
    for (auto& array : data_[static_cast<std::size_t>(field.field)]) {
      if (!array.empty()) gather(array);
    }
  }
  gather(ids_);
}

std::size_t ParticleBuffers::bytes() const {
  std::size_t sum = ids_.size() * sizeof(std::int64_t);
  for (const auto& field : data_) {
    for (const auto& array : field) sum += array.size() * sizeof(double);
  }
  return sum;
}

}  // namespace scarp
