// SPDX-License-Identifier: BSD-3-Clause
/// A scene at three spacings: what is compared, how far it is off, which spacing to use.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "engine/converge/richardson.hpp"
#include "engine/simulation.hpp"

namespace scarp {

/// A number of the last moment of a run: a size, or one component of it.
struct EndQuantity {
  std::string name;  ///< "crest.displacement", "crest.displacement_x", "base.force_y"
  std::string unit;
  std::size_t size = 0;  ///< index of the size it is a component of; its own for a size
  bool probe = false;    ///< displacement of a probe
};

/// Displacement of each probe since the last reset, largest displacement, force on each wall; sizes
/// before their components.
std::vector<EndQuantity> end_quantities(const Scene& scene);

/// Their values now, in the same order.
std::vector<double> end_values(const Simulation& simulation);

/// One of the three runs.
struct SpacingRun {
  double spacing = 0.0;  ///< [m]
  double wall_s = 0.0;   ///< [s]
  double particles = 0.0, steps = 0.0;
  double mass = 0.0;           ///< of the soil [kg, per metre in 2D]
  bool reused = false;         ///< taken from an earlier call
  std::vector<double> values;  ///< of the end quantities
};

/// A quantity over the three spacings.
struct Convergence {
  EndQuantity quantity;
  std::array<ValueAtSpacing, 3> values;
  ErrorEstimate estimate;
};

/// The spacing that meets a target, and what one run at it costs.
struct Advice {
  double target = 0.0;            ///< relative error
  std::optional<double> spacing;  ///< [m]; empty: none can be named
  double wall_s = 0.0;            ///< [s]
  std::string decided_by;         ///< the quantity that asks for the finest spacing, or for none
};

struct Study {
  int dimension = 2;
  std::array<SpacingRun, 3> runs;  ///< coarse to fine
  std::vector<Convergence> quantities;
  std::vector<Advice> advice;      ///< for 5 % and 2 %
  std::vector<std::string> notes;  ///< what limits the estimates
};

/// Estimates, advice and notes from the three runs. Components err relative to their size. Advice
/// is for the displacements of the probes, of the fastest-moved particle if there are none.
Study assess(const std::vector<EndQuantity>& quantities, const std::array<SpacingRun, 3>& runs,
             int dimension);

/// "probe 'crest' ..." in words: what the trend means for the reader; empty if it converges.
std::string remark(const ErrorEstimate& estimate);

}  // namespace scarp
