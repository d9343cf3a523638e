// SPDX-License-Identifier: BSD-3-Clause
/// Looks a field up and hands out its arrays.
#include "engine/particles/field_access.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "engine/errors.hpp"

namespace scarp {
namespace {

bool can_be_seen(const FieldRow& field) {
  return field.lifetime == Lifetime::state && field.readout != Readout::inside;
}
/// Where particles are decides about lists, walls and lost soil, not only about a number.
bool can_be_set(const FieldRow& field) {
  return can_be_seen(field) && field.field != Field::position;
}

FieldRow named(const ParticleBuffers& particles, std::string_view name,
               bool (*allowed)(const FieldRow&), const char* purpose) {
  std::string known;
  for (const FieldRow& field : particles.rows()) {
    if (!allowed(field) || !particles.has(field.field)) continue;
    if (name == field.name) return field;
    known += (known.empty() ? "" : ", ") + std::string(field.name);
  }
  throw Error(
      fmt::format("no field '{}' to be {} in this run; there are {}", name, purpose, known));
}

void require_values(const FieldRow& field, std::span<const double> values, std::size_t count) {
  if (values.size() != count) {
    throw Error(fmt::format("field '{}' takes {} values, {} for each particle, not {}.", field.name,
                            count, component_count(field.rank), values.size()));
  }
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (std::isfinite(values[k]) && (field.field != Field::density || values[k] > 0.0)) continue;
    throw Error(fmt::format("field '{}' cannot be {} (value {}). Try a finite number{}.",
                            field.name, values[k], k,
                            field.field == Field::density ? " above 0" : ""));
  }
}

}  // namespace

FieldView view_field(const ParticleBuffers& particles, std::string_view name) {
  const FieldRow field = named(particles, name, can_be_seen, "viewed");
  FieldView view{particles.ids(), {}};
  for (int c = 0; c < component_count(field.rank); ++c) {
    if (stores_component(field.rank, c, particles.dimension()))
      view.components.emplace_back(particles.component(field.field, c), view.ids.size());
  }
  return view;
}

void write_field(ParticleBuffers& particles, std::string_view name,
                 std::span<const std::int64_t> slots, std::span<const double> values) {
  const FieldRow field = named(particles, name, can_be_set, "set");
  const auto components = static_cast<std::size_t>(component_count(field.rank));
  require_values(field, values, slots.size() * components);
  for (std::size_t c = 0; c < components; ++c) {
    if (!stores_component(field.rank, static_cast<int>(c), particles.dimension())) continue;
    double* array = particles.component(field.field, static_cast<int>(c));
    for (std::size_t k = 0; k < slots.size(); ++k) array[slots[k]] = values[k * components + c];
  }
}

}  // namespace scarp
