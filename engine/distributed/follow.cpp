// SPDX-License-Identifier: GPL-2.0-only
/// What all processes but the first do.
#include "engine/distributed/follow.hpp"

#include <exception>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "engine/checkpoint/scene_text.hpp"
#include "engine/errors.hpp"
#include "engine/simulation.hpp"

namespace scarp::distributed {
namespace {

using Member = JointCall::Member;

/// The scene of the first process: that of the simulation so far, or by the reader of this one.
Scene same_scene(SoilParts& parts, const std::optional<Simulation>& simulation,
                 const std::function<Scene()>& load, const Order& order) {
  parts.begin(order.call);
  return or_abort(&parts, [&] {
    if (simulation && scene_text(simulation->scene()) == order.scene) return simulation->scene();
    Scene scene = load();
    const std::string difference = first_difference(order.scene, scene_text(scene));
    if (difference.empty()) return scene;
    throw SceneError(fmt::format(
        "{}: another process reads another scene there: {}. Try a folder that all machines share.",
        scene.file, difference));
  });
}

void call(std::optional<Simulation>& simulation, const Order& order) {
  switch (order.call.member) {
    case Member::make:
      break;  // below
    case Member::step:
      simulation->step();
      break;
    case Member::set_step_factor:
      simulation->set_step_factor(order.call.number);
      break;
    case Member::field:
      static_cast<void>(simulation->field(order.name));
      break;
    case Member::ids:
      static_cast<void>(simulation->ids());
      break;
    case Member::snapshot:
      static_cast<void>(simulation->snapshot());
      break;
    case Member::require_sound:
      simulation->require_sound();
      break;
    case Member::energy:
      static_cast<void>(simulation->energy());
      break;
    case Member::wall_reactions:
      static_cast<void>(simulation->wall_reactions());
      break;
    case Member::probe:
      static_cast<void>(simulation->probe(static_cast<std::size_t>(order.call.number)));
      break;
    case Member::density_bound_count:
      static_cast<void>(simulation->density_bound_count());
      break;
    case Member::face_hold_count:
      static_cast<void>(simulation->face_hold_count());
      break;
  }
}

}  // namespace

int follow(const std::shared_ptr<SoilParts>& parts, const std::function<Scene()>& load,
           const RunOptions& options) {
  std::optional<Simulation> simulation;
  for (;;) {
    const Order order = parts->next_order();
    if (order.kind == Order::Kind::finish) return order.exit_code;
    try {
      if (order.call.member != Member::make) {
        call(simulation, order);
        continue;
      }
      const Scene scene = same_scene(*parts, simulation, load, order);
      // As in the first process the simulation before goes only when there is a new one.
      Simulation made =
          order.snapshot ? Simulation(scene, *order.snapshot, options) : Simulation(scene, options);
      simulation.emplace(std::move(made));
    } catch (const std::exception&) {
      // The first process has heard of it, and says so.
    }
  }
}

}  // namespace scarp::distributed
