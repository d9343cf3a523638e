// SPDX-License-Identifier: BSD-3-Clause
/// Soil that somebody else moves, as neighbours of one's own.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <vector>

#include "engine/particles/generate.hpp"
#include "engine/setup.hpp"
#include "engine/state.hpp"
#include "tests/support/small_scenes.hpp"

namespace scarp::test {
namespace {

/// A free block, part of it in tension, every particle with a velocity and a stress of its own.
Scene block(const char* preset_name, bool between_smooth_walls = false) {
  Scene scene = elastic_column(preset_name, 1.5, 0.1);
  scene.materials = {clay()};
  if (!between_smooth_walls) scene.walls.clear();
  scene.bodies.clear();
  scene.stages = {stage_for("rest", 1.0)};
  scene.initial_stress = InitialStress::zero;
  return scene;
}
Particles block_particles(const char* preset_name) {
  Scene scene = block(preset_name);
  scene.bodies = elastic_column(preset_name, 1.5, 0.1).bodies;
  Particles p = generate_soil(scene);
  for (std::size_t k = 0; k < p.position.size(); ++k) {
    Vec3& x = p.position[k];
    x = {x[0] + 0.01 * std::sin(9.0 * x[1]), x[1] + 0.01 * std::cos(7.0 * x[0]), 0.0};
    p.velocity[k] = {std::sin(3.0 * x[0] + x[1]), std::cos(2.0 * x[1]), 0.0};
    p.stress.push_back({1e4 * std::sin(5.0 * x[0]), -1e4 * x[1], -2e3, 3e3 * x[0], 0.0, 0.0});
    p.density.push_back(2000.0 + 20.0 * std::sin(4.0 * x[1]));
    p.id.push_back(static_cast<std::int64_t>(100 + k));
  }
  return p;
}

template <class Keep>
Particles part_of(const Particles& all, Keep&& keep) {
  Particles part;
  for (std::size_t k = 0; k < all.position.size(); ++k) {
    if (!keep(all.position[k])) continue;
    part.position.push_back(all.position[k]);
    part.velocity.push_back(all.velocity[k]);
    part.material.push_back(0);
    part.id.push_back(all.id[k]);
    part.stress.push_back(all.stress[k]);
    part.density.push_back(all.density[k]);
  }
  return part;
}

/// The fields of the rates of a step, component by component.
std::vector<Field> fields_of_values(const State& state) {
  std::vector<Field> fields;
  for (const Field field : fields_of(state.kernels.terms)) {
    for (int c = 0; c < component_count(row(field).rank); ++c) {
      if (state.particles.component(field, c) != nullptr && field != Field::diffusivity)
        fields.push_back(field);
    }
  }
  return fields;
}

/// What another process would send between the sweeps: the moments of the ghosts, by id from a
/// state that holds all soil.
void send_moments(const State& whole, ParticleBuffers& ghosts) {
  std::map<std::int64_t, std::int64_t> slots;
  for (const ParticleGroup& group : whole.particles.groups()) {
    for (std::int64_t k = group.first; k < group.end(); ++k)
      slots[whole.particles.ids()[static_cast<std::size_t>(k)]] = k;
  }
  for (const ParticleGroup& group : ghosts.groups()) {
    for (std::int64_t k = group.first; k < group.end(); ++k) {
      for (int c = 0; c < 6; ++c) {
        if (double* moment = ghosts.component(Field::force_moment, c))
          moment[k] = whole.particles.component(
              Field::force_moment, c)[slots.at(ghosts.ids()[static_cast<std::size_t>(k)])];
      }
    }
  }
}

/// Every rate of a step by id.
std::map<std::int64_t, std::vector<double>> rates(State& state, const State* whole = nullptr) {
  for (const Phase& phase :
       {phases::pack_soil, phases::decide_rebuild, phases::rebuild_lists, phases::pack_images})
    phase.run(state);
  if (state.kernels.corrects_forces()) {
    sweep_gradient(state);
    take_moment(state);
    if (whole != nullptr) send_moments(*whole, state.ghosts);
    for (const Phase& phase : {phases::pack_forces, phases::pack_images, phases::sweep_force})
      phase.run(state);
  } else {
    sweep_all(state);
  }
  std::map<std::int64_t, std::vector<double>> all;
  for (const ParticleGroup& group : state.particles.groups()) {
    for (std::int64_t k = group.first; k < group.end(); ++k) {
      std::vector<double>& of = all[state.particles.ids()[static_cast<std::size_t>(k)]];
      for (const Field field : fields_of(state.kernels.terms)) {
        for (int c = 0; c < component_count(row(field).rank); ++c) {
          const double* values = state.particles.component(field, c);
          if (values != nullptr && field != Field::diffusivity) of.push_back(values[k]);
        }
      }
    }
  }
  return all;
}

void expect_split_sums(const char* preset_name, Precision precision, double rounding,
                       bool force_correction = false, bool between_smooth_walls = false) {
  Scene scene = block(preset_name, between_smooth_walls);
  scene.numerics.force_correction = force_correction;
  scene.numerics.precision = precision;
  const Particles all = block_particles(preset_name);
  State whole = make_state(scene, {1, {}}, &all);
  enter_stage(whole);
  const auto expected = rates(whole);

  const auto left = [](const Vec3& x) { return x[0] < 0.45; };
  const Particles own = part_of(all, left),
                  others = part_of(all, [&](const Vec3&x) { return !left(x); });
  State state = make_state(scene, {1, {}}, &own);
  // What another process would send: a buffer made like one's own, without rates.
  state.ghosts = make_state(scene, {1, {}}, &others).particles;
  enter_stage(state);
  const auto found = rates(state, &whole);
  ASSERT_EQ(found.size(), own.position.size());
  EXPECT_EQ(state.sweep.records.layout()[Role::ghost].slots, state.ghosts.slots());

  // Terms of a component that sums to little are as large as those of the others.
  const std::vector<Field> fields = fields_of_values(whole);
  std::map<Field, double> largest;
  for (const auto& [id, values] : expected) {
    for (std::size_t c = 0; c < values.size(); ++c) {
      double& of_field = largest[fields[c]];
      of_field = std::fmax(of_field, std::fabs(values[c]));
    }
  }
  for (const auto& [id, values] : found) {
    for (std::size_t c = 0; c < values.size(); ++c) {
      // The same terms in another order: a rounding for each of about 20, of the largest there is.
      ASSERT_NEAR(values[c], expected.at(id)[c], 20.0 * rounding * largest[fields[c]])
          << "value " << c;
    }
  }
}

TEST(GhostsTest, AreNeighboursLikeTheSoilTheyStandFor) {
  // Of mixed precision the origin of the records differs: positions to 2^-19 h, as terms of 20 h.
  expect_split_sums("modern", Precision::real64, 0x1p-50);
  expect_split_sums("paper", Precision::real64, 0x1p-50);
  // T is made of moments that are sums themselves: twice the roundings.
  expect_split_sums("modern", Precision::real64, 0x1p-49, true);
  expect_split_sums("paper", Precision::mixed, 8.0 * 0x1p-24);
}

TEST(GhostsTest, HaveImagesLikeTheSoilTheyStandFor) {
  expect_split_sums("modern", Precision::real64, 0x1p-50, false, true);
  expect_split_sums("paper", Precision::real64, 0x1p-50, false, true);
  // The moments of ghosts come after their images were chosen.
  expect_split_sums("modern", Precision::real64, 0x1p-49, true, true);
}

}  // namespace
}  // namespace scarp::test
