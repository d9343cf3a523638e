// SPDX-License-Identifier: BSD-3-Clause
/// Runs the phases of a step, with the hooks of a program and a clock beside them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/step/phase_view.hpp"
#include "engine/step/step_phases.hpp"

namespace scarp {

class PhaseRunner {
 public:
  PhaseRunner(Integrator integrator, bool corrects_forces);

  /// One step, of the next stage where one has ended. What phases and hooks throw leaves it.
  void step(State& state);
  /// After the state has been changed between two steps: makes anew what a step takes over from the
  /// one before.
  void renew(State& state) const;
  /// Errors: Error for a phase that the integrator does not have, and for an empty hook.
  void add(std::string_view phase, When when, PhaseHook hook);

  const StepPhases& phases() const { return phases_; }
  /// In order of the step, then what only the start of a stage has, each phase once.
  std::vector<PhaseTime> times() const;

 private:
  struct Hook {
    std::string phase;
    When when;
    PhaseHook call;
  };
  double times_in_a_step(std::string_view phase) const;
  void call_hooks(State& state, const Phase& phase, When when) const;
  double run(State& state, PhaseList list, std::vector<double>& seconds) const;

  StepPhases phases_;
  std::vector<double> start_seconds_, step_seconds_;  ///< by phase
  std::vector<Hook> hooks_;
};

}  // namespace scarp
