// SPDX-License-Identifier: BSD-3-Clause
/// The step of each integrator, literally.
#include "engine/step/step_phases.hpp"

#include "engine/state.hpp"
#include "engine/watch/watch.hpp"

namespace scarp {
namespace {

namespace p = phases;

// As a std::array of deduced type gcc 12 would put them into memory that can be written.
constexpr Phase verlet_stage_start[]{p::enter_stage, p::start_ledger};
constexpr Phase verlet_renewal[]{p::start_ledger};
constexpr Phase verlet_step[]{p::pack_soil,      p::decide_rebuild,    p::rebuild_lists,
                              p::pack_images,    p::extrapolate_walls, p::sweep_all,
                              p::update_sleep,   p::sample_energy,     p::choose_time_step,
                              p::advance_verlet, p::hold_off_faces,    p::watch,
                              p::end_step};

/// The first kick needs the acceleration.
constexpr Phase kick_drift_kick_stage_start[]{
    p::enter_stage, p::pack_soil,         p::decide_rebuild, p::rebuild_lists,
    p::pack_images, p::extrapolate_walls, p::sweep_force,    p::start_ledger};
constexpr Phase kick_drift_kick_renewal[]{p::pack_soil,   p::decide_rebuild,    p::rebuild_lists,
                                          p::pack_images, p::extrapolate_walls, p::sweep_force,
                                          p::start_ledger};
constexpr Phase kick_drift_kick_step[]{
    p::update_sleep,   p::choose_time_step,  p::kick_half,      p::hold_off_faces,
    p::drift_half,     p::pack_soil,         p::decide_rebuild, p::rebuild_lists,
    p::pack_images,    p::extrapolate_walls, p::sweep_gradient, p::advance_stress,
    p::drift_half,     p::pack_soil,         p::decide_rebuild, p::rebuild_lists,
    p::pack_images,    p::extrapolate_walls, p::sweep_force,    p::kick_half,
    p::hold_off_faces, p::sample_energy,     p::watch,          p::end_step};

/// Where forces are corrected they need the moment, which is that of the place at the start, later
/// that of mid-step, turned.
constexpr Phase corrected_stage_start[]{
    p::enter_stage,       p::pack_soil,      p::decide_rebuild, p::rebuild_lists, p::pack_images,
    p::extrapolate_walls, p::sweep_gradient, p::take_moment,    p::pack_forces,   p::pack_images,
    p::extrapolate_walls, p::sweep_force,    p::start_ledger};
constexpr Phase corrected_renewal[]{p::pack_soil,         p::decide_rebuild,    p::rebuild_lists,
                                    p::pack_images,       p::extrapolate_walls, p::sweep_gradient,
                                    p::take_moment,       p::pack_forces,       p::pack_images,
                                    p::extrapolate_walls, p::sweep_force,       p::start_ledger};
constexpr Phase corrected_step[]{
    p::update_sleep,   p::choose_time_step,  p::kick_half,      p::hold_off_faces,
    p::drift_half,     p::pack_soil,         p::decide_rebuild, p::rebuild_lists,
    p::pack_images,    p::extrapolate_walls, p::sweep_gradient, p::advance_stress,
    p::drift_half,     p::pack_forces,       p::decide_rebuild, p::rebuild_lists,
    p::pack_images,    p::extrapolate_walls, p::sweep_force,    p::kick_half,
    p::hold_off_faces, p::sample_energy,     p::watch,          p::end_step};
constexpr Phase corrected_verlet_step[]{p::pack_soil,
                                        p::decide_rebuild,
                                        p::rebuild_lists,
                                        p::pack_images,
                                        p::extrapolate_walls,
                                        p::sweep_gradient,
                                        p::take_moment,
                                        p::pack_forces,
                                        p::pack_images,
                                        p::extrapolate_walls,
                                        p::sweep_force,
                                        p::update_sleep,
                                        p::sample_energy,
                                        p::choose_time_step,
                                        p::advance_verlet,
                                        p::hold_off_faces,
                                        p::watch,
                                        p::end_step};

}  // namespace

StepPhases phases_of(Integrator integrator, bool corrects_forces) {
  const bool verlet = integrator == Integrator::verlet;
  if (verlet && corrects_forces) return {verlet_stage_start, corrected_verlet_step, verlet_renewal};
  if (verlet) return {verlet_stage_start, verlet_step, verlet_renewal};
  if (corrects_forces) return {corrected_stage_start, corrected_step, corrected_renewal};
  return {kick_drift_kick_stage_start, kick_drift_kick_step, kick_drift_kick_renewal};
}

}  // namespace scarp
