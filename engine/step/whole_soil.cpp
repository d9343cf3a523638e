// SPDX-License-Identifier: BSD-3-Clause
/// What all parts of a soil hold, put together in the part that leads.
#include "engine/step/whole_soil.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <span>

#include "engine/particles/probe_reading.hpp"
#include "engine/particles/slots_by_id.hpp"
#include "engine/scene/soil_model.hpp"

namespace scarp {
namespace {

/// Ids of a part in ascending order, then those of the others; as numbers of floating point, which
/// tell whole numbers apart up to 2^53.
std::vector<double> collected_ids(const ParticleBuffers& own,
                                  const std::vector<std::int64_t>& slots, Reduction& parts) {
  std::vector<double> ids;
  for (const std::int64_t slot : slots)
    ids.push_back(static_cast<double>(own.ids()[static_cast<std::size_t>(slot)]));
  parts.collect(ids);
  return ids;
}

}  // namespace

std::vector<std::int64_t> whole_ids(const ParticleBuffers& own, Reduction& parts) {
  const std::vector<double> all = collected_ids(own, slots_by_id(own), parts);
  std::vector<std::int64_t> ids(all.begin(), all.end());
  std::sort(ids.begin(), ids.end());
  return ids;
}

std::vector<double> whole_field(const Readable& own, const FieldRow& field, Reduction& parts) {
  const std::vector<std::int64_t> slots = slots_by_id(own.particles);
  std::vector<double> values;
  for (const std::int64_t slot : slots) {
    for (int c = 0; c < component_count(field.rank); ++c)
      values.push_back(own.value(field, slot, c));
  }
  const std::vector<double> ids = collected_ids(own.particles, slots, parts);
  parts.collect(values);
  if (ids.size() == slots.size()) return values;  // there are no others
  std::vector<std::size_t> order(ids.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&ids](std::size_t a, std::size_t b) { return ids[a] < ids[b]; });
  const auto width = static_cast<std::size_t>(component_count(field.rank));
  std::vector<double> sorted;
  sorted.reserve(values.size());
  for (const std::size_t k : order) {
    const auto first = values.begin() + static_cast<std::ptrdiff_t>(k * width);
    sorted.insert(sorted.end(), first, first + static_cast<std::ptrdiff_t>(width));
  }
  return sorted;
}

std::optional<ParticleBuffers> whole_soil(const ParticleBuffers& own, bool (*kept)(const FieldRow&),
                                          Reduction& parts) {
  const auto count = static_cast<double>(own.count());
  const bool is_all = parts.sum_of(count) == count;
  if (parts.minimum_of(is_all ? 1.0 : 0.0) == 1.0) return {};  // all parts take the same way
  std::vector<std::vector<std::int64_t>> others;
  for (const ParticleGroup& group : own.groups()) {
    std::vector<double> ids(own.ids().begin() + group.first, own.ids().begin() + group.end());
    parts.collect(ids);
    others.emplace_back(ids.begin() + group.count, ids.end());
  }
  ParticleBuffers whole = own;
  whole.exchange({}, others);
  for (const FieldRow& field : own.rows()) {
    if (!kept(field)) continue;
    for (int c = 0; c < component_count(field.rank); ++c) {
      const double* from = own.component(field.field, c);
      if (!stores_component(field.rank, c, own.dimension())) continue;
      for (std::size_t g = 0; g < others.size(); ++g) {
        const ParticleGroup& group = own.groups()[g];
        std::vector<double> values;
        if (group.count > 0) values.assign(from + group.first, from + group.end());
        parts.collect(values);
        std::copy(values.begin(), values.end(),
                  whole.component(field.field, c) + whole.groups()[g].first);
      }
    }
  }
  return whole;
}

ProbeSample whole_probe(const Scene& scene, const ParticleBuffers& own, const ProbeParticle& probe,
                        Reduction& parts) {
  const auto& ids = own.ids();
  const bool here = std::find(ids.begin(), ids.end(), probe.particle) != ids.end();
  const bool anywhere = parts.sum_of(here ? 1.0 : 0.0) > 0.0;
  ProbeSample sample;
  if (here || !anywhere) sample = read_probe(scene, own, probe);
  const std::vector<kernels::StateField> history = history_of(scene);
  sample.probe = probe.probe;
  sample.history.resize(static_cast<std::size_t>(std::count_if(
      history.begin(), history.end(), [](const auto& field) { return field.output; })));
  for (const std::span<double> values :
       {std::span<double>(sample.position), std::span<double>(sample.displacement),
        std::span<double>(sample.velocity), std::span<double>(sample.stress),
        std::span<double>(&sample.density, 1), std::span<double>(sample.history)})
    parts.sum(values);
  return sample;
}

}  // namespace scarp
