// SPDX-License-Identifier: BSD-3-Clause
/// Everything a run consists of, by what each folder owns.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <vector>

#include "engine/boundary/boundary.hpp"
#include "engine/boundary/relaxed_packing.hpp"
#include "engine/energy/energy.hpp"
#include "engine/integrate/integrate.hpp"
#include "engine/neighbours/neighbours.hpp"
#include "engine/particles/particle_buffers.hpp"
#include "engine/particles/probe_sample.hpp"
#include "engine/run_options.hpp"
#include "engine/sleep/sleep.hpp"
#include "engine/stages/stages.hpp"
#include "engine/step/phase.hpp"
#include "engine/step/reduction.hpp"
#include "engine/sweep/pair_sweeps.hpp"
#include "engine/team.hpp"
#include "engine/watch/lost_soil.hpp"

namespace scarp {

struct State {
  Scene scene;
  RunOptions options;
  std::shared_ptr<Reduction> reduction = std::make_shared<Reduction>();
  Team team;
  int threads = 1;  ///< of this step
  ChosenKernels kernels;
  double smoothing_length = 0.0;
  double lattice_moment = 1.0;
  bool start_is_geostatic = false;  ///< stress at the start, where no particle brings its own

  ParticleBuffers particles;
  ParticleBuffers ghosts;      ///< soil near the own that somebody else moves; neighbours only
  DataSet changed;             ///< fields of the soil of which ghosts elsewhere may be outdated
  RelaxedPacking packing;      ///< of the soil when it was made
  std::size_t soil_count = 0;  ///< of all parts
  double soil_mass = 0.0;      ///< of all parts [kg]
  RecordScaling scaling;
  SweepInput sweep;
  Neighbours neighbours;
  Sleep sleep;
  Boundary boundary;
  std::vector<kernels::StressPassConstants> material_constants;
  std::uint64_t density_bounds = 0;            ///< how often they acted
  std::vector<ProbeParticle> probe_particles;  ///< by probe

  StageClock stage;
  StepClock clock;
  StepLimits limits;
  StepReport report;
  EnergyLedger ledger;
  LostSoil lost;
  std::vector<std::int64_t> lost_ids;  ///< ascending

  bool is_lost(std::int64_t slot) const {
    return !lost_ids.empty() && std::binary_search(lost_ids.begin(), lost_ids.end(),
                                                   particles.ids()[static_cast<std::size_t>(slot)]);
  }
};

}  // namespace scarp
