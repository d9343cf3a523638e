// SPDX-License-Identifier: BSD-3-Clause
/// What a program that hooks into a step sees of a phase.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace scarp {

struct Phase;
class HookMeter;
class ParticleBuffers;
struct State;

/// Whether a hook is called before its phase or after it.
enum class When { before, after };

/// A phase by its name, with the names of those fields of the run that it reads and writes, and
/// "records" (what the sweeps read, packed), "lists" (cells and neighbour lists) and "walls".
struct PhaseInfo {
  std::string name;
  std::vector<std::string> reads, writes;
};
PhaseInfo describe(const Phase& phase, const ParticleBuffers& particles);

/// Wall time of one phase of the step, over all steps so far.
struct PhaseTime {
  std::string phase;
  double seconds = 0.0;
};

/// The particles as a hook finds them, in the order of memory: SI, one array for each component.
/// Nothing is copied. Valid within the call only: particles are put in another order now and then.
class PhaseView {
 public:
  PhaseView(State& state, const Phase& phase, When when, HookMeter& meter)
      : state_(state), phase_(phase), when_(when), meter_(meter) {}

  std::string_view phase() const;
  double time() const;       ///< simulated time at the start of the step [s]
  double time_step() const;  ///< of this step; until it is chosen of the step before [s]
  /// Permanent id of each slot; -1 where a slot only pads and holds no particle.
  std::span<const std::int64_t> ids() const;
  /// One component (x, y, z; xx, yy, zz, xy, yz, zx; or 3 a + b of a tensor) of a field for each
  /// slot. Errors: Error for a field or component that the run does not store, and for a rate that
  /// the phase neither reads nor writes: it may be of another order or step.
  std::span<const double> read(std::string_view field, int component = 0) const;
  /// The same to be changed. Errors: also for a field that the phase does not read (before it) or
  /// write (after it): nothing may depend on the change, or something does that came before.
  std::span<double> write(std::string_view field, int component = 0);

 private:
  State& state_;
  const Phase& phase_;
  When when_;
  HookMeter& meter_;
};

using PhaseHook = std::function<void(PhaseView&)>;

}  // namespace scarp
