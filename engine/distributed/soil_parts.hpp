// SPDX-License-Identifier: GPL-2.0-only
/// One process's part of the soil, and how the parts stay one simulation.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/distributed/decomposition.hpp"
#include "engine/distributed/processes.hpp"
#include "engine/step/reduction.hpp"

namespace scarp::distributed {

/// What the first process asks the others to do.
struct Order {
  enum class Kind { call, finish } kind = Kind::finish;
  JointCall call{};
  std::string name, scene;           ///< what `call.name` views; the scene of `make` in words
  std::optional<Snapshot> snapshot;  ///< what `call.snapshot` is
  int exit_code = 0;
};

/// How the soil was shared out over a run.
struct Balance {
  double first = 1.0, last = 1.0,
         most = 1.0;    ///< particles of the fullest process over the mean
  double ghosts = 0.0;  ///< of all processes over all particles, the mean of all deals
};

/// Wall time of one process [s].
struct Waits {
  double deals = 0.0, refreshes = 0.0, joins = 0.0;
};

/// The first process runs the commands of scarp; whenever they call a member of Simulation in which
/// all take part it tells the others, which make the same call. Where one process throws within
/// such a call, all leave it: the others with what that one threw.
class SoilParts : public Reduction {
 public:
  SoilParts(Processes& processes, bool rebalance, int threads);

  void maximum(std::span<double> values) override { join(Processes::Join::maximum, values); }
  void minimum(std::span<double> values) override { join(Processes::Join::minimum, values); }
  void sum(std::span<double> values) override { join(Processes::Join::sum, values); }
  void gather(std::vector<double>& values) override;
  void collect(std::vector<double>& values) override;
  bool leads() const override { return processes_.leads(); }
  void begin(const JointCall& call) override;
  void end() override;
  void divide(ParticleBuffers& soil) override;
  void deal(ParticleBuffers& soil, ParticleBuffers& ghosts) override;
  void refresh(const ParticleBuffers& soil, ParticleBuffers& ghosts,
               const DataSet& fields) override;
  void abort() noexcept override;

  /// In all but the first process: waits for what to do.
  Order next_order();
  /// In the first: lets the others go.
  void finish(int exit_code);
  /// Whether a call was left in which the others still are.
  bool in_call() const { return in_call_; }

  /// Of all deals so far, the same in all processes.
  const Balance& balance() const { return balance_; }
  /// Of this process; after `finish` of all.
  const Traffic& traffic() const { return traffic_; }
  const Waits& waits() const { return waits_; }

 private:
  void join(Processes::Join how, std::span<double> values);
  /// Errors: what another process has thrown.
  void meet() { join(Processes::Join::nothing, {}); }
  [[noreturn]] void throw_failure_of_another();
  void add_up_traffic();
  void take_balance(double own, double ghosts);

  Processes& processes_;
  bool rebalance_;
  int threads_;
  bool in_call_ = false;
  bool divided_ = false;  ///< else each process holds all soil
  double halo_ = 0.0;
  std::unique_ptr<Decomposition> decomposition_;
  Balance balance_;
  double ghosts_ = 0.0, deals_ = 0.0;
  Traffic traffic_, traffic_before_;
  Waits waits_;
};

}  // namespace scarp::distributed
