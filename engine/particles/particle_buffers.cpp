// SPDX-License-Identifier: BSD-3-Clause
/// Storage of the soil particles.
#include "engine/particles/particle_buffers.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "engine/parallel.hpp"

namespace scarp {

ParticleBuffers::ParticleBuffers(int dimension, std::vector<ParticleGroup> groups,
                                 std::span<const Field> used, std::span<const FieldRow> declared)
    : dimension_(dimension),
      groups_(std::move(groups)),
      data_(static_cast<std::size_t>(Field::count) + declared.size()) {
  for (const ParticleGroup& group : groups_) slots_ += group.capacity;
  ids_.assign(static_cast<std::size_t>(slots_), -1);
  const auto add = [&](bool of_the_run, const FieldRow& field) {
    if (of_the_run) rows_.push_back(field);
  };
  const auto stored = [](const FieldRow& field) { return field.lifetime != Lifetime::derived; };
  for (const FieldRow& field : field_list)
    add(stored(field) && std::find(used.begin(), used.end(), field.field) != used.end(), field);
  for (const FieldRow& field : declared) add(true, field);
  for (const FieldRow& field : field_list) add(!stored(field), field);
  for (const FieldRow& field : rows_) {
    if (!stored(field)) continue;
    for (int c = 0; c < component_count(field.rank); ++c) {
      if (!stores_component(field.rank, c, dimension)) continue;
      data_[static_cast<std::size_t>(field.field)][static_cast<std::size_t>(c)].resize(
          static_cast<std::size_t>(slots_));
    }
    put_initial(field);
  }
}

bool ParticleBuffers::has(Field field) const {
  return std::any_of(rows_.begin(), rows_.end(), [field](const FieldRow& row) {
    return row.field == field && row.lifetime != Lifetime::derived;
  });
}

const double* ParticleBuffers::declared(std::string_view name) const {
  return component(std::find_if(rows_.begin(), rows_.end(), [name](const FieldRow& row) {
                     return row.field >= declared_field(0) && row.name == name;
                   })->field);
}

double* ParticleBuffers::declared(std::string_view name) {
  return const_cast<double*>(std::as_const(*this).declared(name));
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

double ParticleBuffers::largest_spacing() const {
  double largest = 0.0;
  for (const ParticleGroup& group : groups_) largest = std::max(largest, group.spacing);
  return largest;
}

double ParticleBuffers::mass() const {
  double sum = 0.0;
  for (const ParticleGroup& group : groups_) sum += static_cast<double>(group.count) * group.mass;
  return sum;
}
double ParticleBuffers::inertia() const {
  double sum = 0.0;
  for (const ParticleGroup& group : groups_)
    sum += static_cast<double>(group.count) * group.inertia();
  return sum;
}

void ParticleBuffers::rearrange(std::vector<ParticleGroup> groups,
                                std::span<const std::int64_t> from) {
  slots_ = std::ssize(from);
  groups_ = std::move(groups);
  const auto gather = [&](auto& array, const auto& before) {
    for (std::size_t k = 0; k < from.size(); ++k) {
      if (from[k] >= 0) array[k] = before[static_cast<std::size_t>(from[k])];
    }
  };
  const auto before = data_;
  for (auto& field : data_) {
    for (auto& array : field) {
      if (!array.empty()) array.assign(from.size(), 0.0);
    }
  }
  for (const FieldRow& field : rows_) put_initial(field);
  for (std::size_t f = 0; f < data_.size(); ++f) {
    for (std::size_t c = 0; c < data_[f].size(); ++c) {
      if (!data_[f][c].empty()) gather(data_[f][c], before[f][c]);
    }
  }
  const std::vector<std::int64_t> ids = std::exchange(ids_, {});
  ids_.assign(from.size(), -1);
  gather(ids_, ids);
}

std::vector<std::int64_t> ParticleBuffers::exchange(
    std::span<const std::int64_t> slots, std::span<const std::vector<std::int64_t>> new_ids) {
  std::vector<ParticleGroup> groups = groups_;
  std::vector<std::int64_t> from, added;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    ParticleGroup& group = groups[g];
    group.first = static_cast<std::int64_t>(from.size());
    for (std::int64_t k = groups_[g].first; k < groups_[g].end(); ++k) {
      if (!std::binary_search(slots.begin(), slots.end(), k)) from.push_back(k);
    }
    added.push_back(static_cast<std::int64_t>(from.size()));
    group.count = added.back() - group.first + std::ssize(new_ids[g]);
    group.capacity =
        slots.empty() ? std::max(group.capacity, padded(group.count)) : padded(group.count);
    // Arrays are never empty: those of a field that is not stored are.
    if (g == 0) group.capacity = std::max(group.capacity, group_alignment);
    from.resize(static_cast<std::size_t>(group.padded_end()), -1);
  }
  rearrange(std::move(groups), from);
  for (std::size_t g = 0; g < groups_.size(); ++g)
    std::copy(new_ids[g].begin(), new_ids[g].end(), ids_.begin() + added[g]);
  return added;
}

std::int64_t ParticleBuffers::add(std::size_t group, std::span<const std::int64_t> new_ids) {
  std::vector<std::vector<std::int64_t>> by_group(groups_.size());
  by_group[group].assign(new_ids.begin(), new_ids.end());
  return exchange({}, by_group)[group];
}

void ParticleBuffers::remove(std::span<const std::int64_t> slots) {
  exchange(slots, std::vector<std::vector<std::int64_t>>(groups_.size()));
}

void ParticleBuffers::permute(int threads, std::span<const std::int32_t> order) {
  const auto each = [&](const auto& visit) {
    parallel_chunks(threads, slots_, particle_chunk, [&](std::int64_t begin, std::int64_t end) {
      for (auto k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(end); ++k)
        visit(k);
    });
  };
  const auto gather = [&](const auto& from, auto& to) {
    each([&](std::size_t k) { to[k] = from[static_cast<std::size_t>(order[k])]; });
  };
  RawVector<double> spare(
      static_cast<std::size_t>(slots_));  // what one array leaves, the next takes
  for (const FieldRow& field : rows_) {
    if (field.lifetime != Lifetime::state) continue;
    for (auto& array : data_[static_cast<std::size_t>(field.field)]) {
      if (array.empty()) continue;
      gather(array, spare);
      array.swap(spare);
    }
  }
  RawVector<std::int64_t> spare_ids(static_cast<std::size_t>(slots_));
  gather(ids_, spare_ids);
  each([&](std::size_t k) { ids_[k] = spare_ids[k]; });
}

void ParticleBuffers::put_initial(const FieldRow& field) {
  for (int c = 0; c < component_count(field.rank); ++c) {
    double* array = component(field.field, c);
    if (array == nullptr) continue;
    switch (field.initial.from) {
      case Initial::From::value:
        std::fill_n(array, slots_, field.initial.value);
        break;
      case Initial::From::position:
        std::copy_n(component(Field::position, c), slots_, array);
        break;
      case Initial::From::reference_density:
        for (const ParticleGroup& group : groups_)
          std::fill_n(array + group.first, group.capacity, group.reference_density);
        break;
    }
  }
}

void ParticleBuffers::start_from_here() {
  for (const FieldRow& field : rows_) {
    if (field.initial.from == Initial::From::position) put_initial(field);
  }
}

void ParticleBuffers::reset() {
  for (const FieldRow& field : rows_) {
    if (field.reset == Reset::reset) put_initial(field);
  }
}

std::size_t ParticleBuffers::bytes() const {
  std::size_t sum = ids_.size() * sizeof(std::int64_t);
  for (const auto& field : data_) {
    for (const auto& array : field) sum += array.size() * sizeof(double);
  }
  return sum;
}

}  // namespace scarp
