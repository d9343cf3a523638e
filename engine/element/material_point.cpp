// SPDX-License-Identifier: BSD-3-Clause
/// A vector of equal lanes around the stress pass.
#include "engine/element/material_point.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "engine/errors.hpp"
#include "engine/setup.hpp"

namespace scarp {
namespace {

/// As many as the widest vector has; all equal, so that none can stray.
constexpr std::size_t lane_count = 8;
using Lanes = std::array<double, lane_count>;

kernels::SymTensor<double> tensor_of(const std::array<double, 6>& s) {
  return {s[0], s[1], s[2], s[3], s[4], s[5]};
}

const Material& named(const Scene& scene, std::string_view material) {
  return scene.materials[material_named(scene, material)];
}

}  // namespace

MaterialPoint::MaterialPoint(const Scene& scene, std::string_view material, int dimension,
                             const RunOptions& options, double strength_reduction)
    : constants_(stress_pass_constants(scene, named(scene, material), strength_reduction)),
      table_(&choose_table(options)),
      model_(named(scene, material).model),
      dimension_(dimension) {
  if (dimension != 2 && dimension != 3)
    throw SceneError(fmt::format("a material point in {} dimensions: try 2 or 3.", dimension));
  constants_.leap = 1.0;
  constants_.plastic_share = 1.0;
  constants_.diffusion_cap = 0.0;
}

PointState MaterialPoint::at(const std::array<double, 6>& stress) const {
  PointState state;
  state.stress = stress;
  state.density = constants_.reference_density;
  const auto fields = model().state_fields;
  for (std::size_t h = 0; h < fields.size(); ++h) state.history[h] = fields[h].initial_value;
  return state;
}

PointState MaterialPoint::advance(const PointState& from,
                                  const GradientIncrement& increment) const {
  alignas(64) std::array<Lanes, 6> stress, moment;
  alignas(64) std::array<Lanes, 9> gradient;
  alignas(64) Lanes density, density_rate;
  alignas(64) std::array<Lanes, kernels::most_state_fields> history;
  kernels::ParticleView view{};
  for (std::size_t c = 0; c < 6; ++c) {
    stress[c].fill(from.stress[c]);
    moment[c].fill(c < 3 ? 1.0 : 0.0);  // a whole neighbourhood
    view.stress[c] = stress[c].data();
    view.moment[c] = moment[c].data();
  }
  for (std::size_t c = 0; c < 9; ++c) {
    gradient[c].fill(increment[c]);
    view.velocity_gradient[c] = gradient[c].data();
  }
  density.fill(from.density);
  density_rate.fill(-from.density * (increment[0] + increment[4] + increment[8]));
  for (std::size_t h = 0; h < history.size(); ++h) {
    history[h].fill(from.history[h]);
    view.history[h] = history[h].data();
  }
  view.density = density.data();
  view.density_rate = density_rate.data();
  const kernels::ModelPasses& passes = table_->passes_of(model());
  passes.stress[static_cast<std::size_t>(dimension_ - 2)](view, constants_, 0, lane_count);

  PointState to = from;
  for (std::size_t c = 0; c < 6; ++c) to.stress[c] = stress[c][0];
  to.density = density[0];
  for (std::size_t h = 0; h < history.size(); ++h) to.history[h] = history[h][0];
  const auto& l = increment;
  const std::array<double, 6> strain{
      l[0], l[4], l[8], 0.5 * (l[1] + l[3]), 0.5 * (l[5] + l[7]), 0.5 * (l[6] + l[2])};
  for (std::size_t c = 0; c < 6; ++c) to.strain[c] += strain[c];
  return to;
}

std::map<std::string, double> MaterialPoint::shown() const {
  const auto names = model().shown;
  std::vector<double> values(names.size());
  model().show(constants_.model, values);
  std::map<std::string, double> all;
  for (std::size_t k = 0; k < names.size(); ++k) all[names[k].name] = values[k];
  return all;
}

double MaterialPoint::first_invariant(const PointState& state) const {
  return trace(tensor_of(state.stress));
}

double MaterialPoint::root_j2(const PointState& state) const {
  return kernels::root_j2(deviator(tensor_of(state.stress)));
}

double MaterialPoint::yield_function(const PointState& state) const {
  return model().yield_function(constants_.model, tensor_of(state.stress), state.history);
}

double MaterialPoint::plastic_volumetric_strain(const PointState& state,
                                                const PointState& start) const {
  const double total = state.strain[0] + state.strain[1] + state.strain[2] - start.strain[0] -
                       start.strain[1] - start.strain[2];
  return total - (first_invariant(state) - first_invariant(start)) / (3.0 * moduli().bulk_modulus);
}

}  // namespace scarp
