// SPDX-License-Identifier: BSD-3-Clause
/// The pair terms and kernels of a scene.
#include "engine/sweep/chosen_kernels.hpp"

#include <algorithm>
#include <string_view>

#include "kernels/pair/term_rows.hpp"

namespace scarp {
namespace {

using kernels::FieldUse;
using kernels::TermRow;

/// Does not compile where there is none of that name and size.
constexpr Field known_field(const FieldUse& use) {
  for (const FieldRow& row : field_list) {
    if (std::string_view(row.name) == use.name && component_count(row.rank) == use.components)
      return row.field;
  }
  throw "a pair term names a field that the table does not have";
}
constexpr bool know_all_fields() {
  for (const TermRow& row : kernels::term_rows) {
    for (const FieldUse& use : row.writes) known_field(use);
    for (const FieldUse& use : row.reads_fields) known_field(use);
  }
  return true;
}
static_assert(know_all_fields());

}  // namespace

std::vector<std::int32_t> first_alike(const std::vector<Material>& materials) {
  std::vector<std::int32_t> found;
  for (const Material& material : materials) {
    const kernels::ElasticModuli own = material.model.moduli();
    const auto first = std::ranges::find_if(materials, [&](const Material& other) {
      const kernels::ElasticModuli moduli = other.model.moduli();
      return moduli.bulk_modulus == own.bulk_modulus && moduli.shear_modulus == own.shear_modulus &&
             other.model.yields() == material.model.yields();
    });
    found.push_back(static_cast<std::int32_t>(first - materials.begin()));
  }
  if (std::ranges::all_of(found, [](std::int32_t first) { return first == 0; })) found.clear();
  return found;
}

Field field_of(const FieldUse& use) { return known_field(use); }

kernels::TermSettings term_settings(const Numerics& n, bool yields) {
  kernels::TermSettings settings;
  settings.gradient_correction = n.gradient_correction;
  settings.force_correction = n.corrects_force();
  settings.yields = yields;
  settings.viscosity_alpha = n.viscosity_alpha;
  settings.viscosity_beta = n.viscosity_beta;
  settings.hourglass_viscosity = n.hourglass_viscosity;
  settings.artificial_stress = n.artificial_stress;
  settings.stress_diffusion = n.stress_diffusion;
  return settings;
}

ChosenKernels choose_kernels(const Scene& scene, bool yields, const kernels::KernelTable& table) {
  const bool mixed = scene.numerics.precision == Precision::mixed;
  ChosenKernels chosen;
  chosen.table = &table;
  chosen.cluster_size = mixed ? table.mixed_cluster_size : table.cluster_size;
  chosen.settings = term_settings(scene.numerics, yields);
  chosen.terms = kernels::used_terms(chosen.settings);
  chosen.slots = kernels::slots_read(chosen.terms);
  const auto kernel = [&](kernels::TermSet terms) {
    const kernels::SweepVariant wanted{scene.dimension, terms};
    if (mixed) return SweepKernel{nullptr, table.mixed_sweep_for(wanted)};
    return SweepKernel{table.sweep_for(wanted), nullptr};
  };
  const auto sweep = [&](kernels::TermSet terms) {
    return ChosenSweep{kernel(terms),
                       kernel(terms.without(kernels::marked_terms(kernels::PairTerms{})))};
  };
  // Forces want the inertia where the density rate wants the mass.
  if (scene.numerics.integrator == Integrator::verlet && !chosen.corrects_forces() &&
      !scales_mass(scene))
    chosen.fused = sweep(chosen.terms);
  chosen.gradient = sweep(kernels::gradient_terms(chosen.terms));
  chosen.force = sweep(kernels::force_terms(chosen.terms));
  return chosen;
}

std::vector<Field> fields_of(kernels::TermSet terms) {
  std::vector<Field> fields;
  const auto add = [&fields](std::span<const FieldUse> uses) {
    for (const FieldUse& use : uses) {
      if (use.if_stored) continue;
      const Field field = field_of(use);
      if (std::ranges::count(fields_of_every_run, field) == 0 &&
          std::ranges::count(fields, field) == 0)
        fields.push_back(field);
    }
  };
  for (const TermRow& row : kernels::term_rows) {
    if (!terms.has(row.term)) continue;
    add(row.writes);
    add(row.reads_fields);
  }
  return fields;
}

int output_place(Field field) {
  for (const TermRow& row : kernels::term_rows) {
    int place = row.first_output;
    for (const FieldUse& use : row.writes) {
      if (field_of(use) == field) return place;
      place += use.components;
    }
  }
  return kernels::most_outputs;  // no term writes it
}

}  // namespace scarp
