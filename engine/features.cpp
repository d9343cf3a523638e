// SPDX-License-Identifier: BSD-3-Clause
/// What a run uses and what was left out, for `scarp check`.
#include "engine/features.hpp"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "engine/state.hpp"
#include "kernels/pair/term_rows.hpp"

namespace scarp {

namespace {

std::string models_of(const Scene& scene) {
  std::set<std::string> names;
  for (const Material& material : scene.materials) names.insert(material.model.name());
  return fmt::format("{}", fmt::join(names, " and "));
}

}  // namespace

std::vector<UsedFeature> used_features(const State& state) {
  const Numerics& n = state.scene.numerics;
  const bool three = state.scene.dimension == 3;
  const auto bytes = [&](const std::vector<Field>& fields) {
    int stored = 0;
    for (const Field field : fields) {
      for (int c = 0; c < component_count(row(field).rank); ++c) {
        stored += stores_component(row(field).rank, c, state.scene.dimension) ? 8 : 0;
      }
    }
    return fmt::format("{} bytes per particle", stored);
  };
  const bool plastic = std::any_of(state.scene.materials.begin(), state.scene.materials.end(),
                                   [](const Material& m) { return m.model.yields(); });
  const bool verlet = n.integrator == Integrator::verlet;
  std::vector<UsedFeature> features{
      {"third dimension", three,
       three ? "3D sweep" : "2D sweep: z, yz and zx are neither stored nor summed"}};
  for (const kernels::TermRow& row : kernels::term_rows) {
    if (*row.text == '\0') continue;
    const bool used = state.kernels.terms.has(row.term);
    std::string note = !used && *row.left_out != '\0' ? row.left_out : row.text;
    note += fmt::format("; {} flops a pair", row.flops(state.scene.dimension));
    const std::vector<Field> fields = fields_of({row.term});
    if (!fields.empty()) note += ", " + bytes(fields);
    features.push_back({row.name, used, std::move(note)});
  }
  const std::vector<UsedFeature> others{
      {"lattice normalisation", n.lattice_normalisation, "folded into the particle volumes: free"},
      {"plasticity", plastic,
       plastic ? fmt::format("passes of {}, {} bytes of history per particle",
                             models_of(state.scene), 8 * history_of(state.scene).size())
               : "elastic pass, no plastic strain stored"},
      {"second time level", verlet,
       bytes({Field::previous_velocity, Field::previous_density, Field::previous_stress})},
      {"second sweep per step", !verlet, "kick-drift-kick sweeps gradient and force apart"},
      {"walls", state.boundary.walls.count() > 0,
       fmt::format("{} dummy particles, swept only near soil", state.boundary.walls.dummy_count())},
      {"mirror images",
       state.boundary.images.count() > 0 ||
           std::any_of(state.scene.walls.begin(), state.scene.walls.end(),
                       [](const Wall& w) { return w.kind == WallKind::free_slip; }),
       "soil near free-slip walls is mirrored"},
      {"relaxed packing", state.packing.moved > 0,
       state.packing.moved > 0
           ? fmt::format("{} particles near walls off the lattice; sum V grad W {:.2g}/dx",
                         state.packing.moved, state.packing.residual)
           : "at the start only, where walls do not meet the lattice"},
      {"moving walls",
       std::any_of(state.scene.walls.begin(), state.scene.walls.end(),
                   [](const Wall& w) { return w.velocity != Vec3{}; }),
       "dummies are moved every step"},
      {"sleep", soil_may_sleep(state.scene),
       "soil at rest is left out, 16 particles at once: " +
           bytes({Field::asleep, Field::stirred_time, Field::stirred_history}) +
           ", and a graph of the lists"},
      {"energy balance", state.scene.output.energy,
       bytes({Field::stress_work, Field::plastic_work, Field::diffusion_work}) +
           ", one to three more force sweeps every 10 steps"},
  };
  features.insert(features.end(), others.begin(), others.end());
  return features;
}

}  // namespace scarp
