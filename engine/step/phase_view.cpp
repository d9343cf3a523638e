// SPDX-License-Identifier: BSD-3-Clause
/// Fields by name for the hooks of a phase.
#include "engine/step/phase_view.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "engine/energy/hook_work.hpp"
#include "engine/errors.hpp"
#include "engine/state.hpp"

namespace scarp {
namespace {

bool is_stored(const FieldRow& field) { return field.lifetime != Lifetime::derived; }

std::vector<std::string> names(const DataSet& set, const ParticleBuffers& particles) {
  std::vector<std::string> found;
  for (const FieldRow& field : particles.rows()) {
    if (is_stored(field) && set.has(field.field)) found.emplace_back(field.name);
  }
  for (const auto& [part, name] :
       {std::pair{Part::records, "records"}, std::pair{Part::lists, "lists"},
        std::pair{Part::walls, "walls"}}) {
    if (set.has(part)) found.emplace_back(name);
  }
  return found;
}

/// The row of a field that the run stores, and in it the component.
const FieldRow& stored(const ParticleBuffers& particles, std::string_view name, int component) {
  std::vector<std::string_view> known;
  for (const FieldRow& field : particles.rows()) {
    if (!is_stored(field)) continue;
    if (name != field.name) {
      known.emplace_back(field.name);
      continue;
    }
    if (component < 0 || component >= component_count(field.rank) ||
        !stores_component(field.rank, component, particles.dimension())) {
      throw Error(fmt::format("field '{}' has no component {} in {}D.", name, component,
                              particles.dimension()));
    }
    return field;
  }
  throw Error(fmt::format("no field '{}' is stored in this run; there are {}.", name,
                          fmt::join(known, ", ")));
}

}  // namespace

PhaseInfo describe(const Phase& phase, const ParticleBuffers& particles) {
  return {phase.name, names(phase.reads, particles), names(phase.writes, particles)};
}

std::string_view PhaseView::phase() const { return phase_.name; }
double PhaseView::time() const { return state_.report.time; }
double PhaseView::time_step() const { return state_.clock.time_step; }
std::span<const std::int64_t> PhaseView::ids() const { return state_.particles.ids(); }

std::span<const double> PhaseView::read(std::string_view field, int component) const {
  const FieldRow& row = stored(state_.particles, field, component);
  if (row.lifetime != Lifetime::state && !(phase_.reads | phase_.writes).has(row.field)) {
    throw Error(fmt::format(
        "field '{}' is a rate that phase '{}' neither reads nor writes: what it holds may be of "
        "another step. Try a phase that uses it.",
        field, phase_.name));
  }
  return {std::as_const(state_.particles).component(row.field, component),
          static_cast<std::size_t>(state_.particles.slots())};
}

std::span<double> PhaseView::write(std::string_view field, int component) {
  const FieldRow& row = stored(state_.particles, field, component);
  const bool before = when_ == When::before;
  const DataSet& touched = before ? phase_.reads : phase_.writes;
  if (!touched.has(row.field)) {
    const std::vector<std::string> known = names(touched, state_.particles);
    throw Error(fmt::format(
        "field '{}' may not be changed {} phase '{}', which does not {} it. {}", field,
        before ? "before" : "after", phase_.name, before ? "read" : "write",
        known.empty() ? "Try another phase." : fmt::format("Try {}.", fmt::join(known, ", "))));
  }
  meter_.before_change(row.field);
  state_.sleep.wake_due = state_.sleep.wanted();
  return {state_.particles.component(row.field, component),
          static_cast<std::size_t>(state_.particles.slots())};
}

}  // namespace scarp
