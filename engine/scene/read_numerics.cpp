// SPDX-License-Identifier: BSD-3-Clause
/// [numerics]: one row per member of `Numerics`, under its own name.
#include <type_traits>

#include "engine/scene/read_parts.hpp"

namespace scarp::input {
namespace {

struct Row {
  std::string_view key;
  void (*read)(const Value&, Numerics&);
};

template <auto Member>
void real(const Value& value, Numerics& numerics) {
  numerics.*Member = value.number(kernels::Unit::none);
}
template <auto Member>
void truth(const Value& value, Numerics& numerics) {
  numerics.*Member = value.boolean();
}

template <auto Member>
void choice(const Value& value, Numerics& numerics) {
  using Choice = std::remove_reference_t<decltype(numerics.*Member)>;
  numerics.*Member = static_cast<Choice>(value.choice(words<Choice>));
}

constexpr Row rows[] = {
    {"smoothing", choice<&Numerics::smoothing>},
    {"smoothing_ratio", real<&Numerics::smoothing_ratio>},
    {"lattice_normalisation", truth<&Numerics::lattice_normalisation>},
    {"gradient_correction", truth<&Numerics::gradient_correction>},
    {"stress_rotation", choice<&Numerics::stress_rotation>},
    {"viscosity_alpha", real<&Numerics::viscosity_alpha>},
    {"viscosity_beta", real<&Numerics::viscosity_beta>},
    {"artificial_stress", real<&Numerics::artificial_stress>},
    {"artificial_stress_exponent",
     [](const Value& v, Numerics& n) {
       if (v.is_text()) v.choice("auto");
       n.artificial_stress_exponent =
           v.is_text() ? std::nullopt : unless_zero(v.number(kernels::Unit::none));
     }},
    {"stress_diffusion", real<&Numerics::stress_diffusion>},
    {"diffusion_shear_gate", real<&Numerics::diffusion_shear_gate>},
    {"integrator", choice<&Numerics::integrator>},
    {"verlet_restart_interval",
     [](const Value& v, Numerics& n) { n.verlet_restart_interval = v.integer(); }},
    {"cfl", real<&Numerics::cfl>},
    {"skin", real<&Numerics::skin>},
    {"density_minimum", real<&Numerics::density_minimum>},
    {"density_maximum", real<&Numerics::density_maximum>},
    {"precision", choice<&Numerics::precision>},
};

}  // namespace

void read_numerics(const Value& section, Numerics& numerics) {
  Keys known;
  for (const Row& row : rows) known.push_back(row.key);
  const Table table = section.table(known);
  for (const Row& row : rows) {
    if (const auto value = table.find(row.key)) row.read(*value, numerics);
  }
}

}  // namespace scarp::input
