// SPDX-License-Identifier: BSD-3-Clause
/// A simulation as Python holds it: who may touch it when, and until when a view of it is valid.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "engine/python/bind.hpp"
#include "engine/python/numpy_model.hpp"
#include "engine/python/run_outputs.hpp"
#include "engine/simulation.hpp"

namespace scarp::python {

/// When `Session::run` ends, and whom it calls.
struct RunRequest {
  std::optional<double> until{};  ///< simulated time [s]; empty: the end of the last stage
  std::optional<double> every{};  ///< simulated time between calls [s]; empty: each step
  py::object callback{};          ///< without arguments; `False` ends the run; None: nobody
  std::string folder{};           ///< of the outputs; empty: none
  bool overwrite = false;
};

/// Steps release Python's lock, so that another thread could come in between. All members are
/// called with the lock held, and refuse what would read half a step or change what is being read:
/// Errors: Error.
class Session : public std::enable_shared_from_this<Session> {
 public:
  Session(Simulation simulation, const RunOptions& options,
          std::unique_ptr<RunOutputs> outputs = {})
      : simulation_(std::move(simulation)), options_(options), outputs_(std::move(outputs)) {}

  /// To be read: between steps, by the thread that runs it also from within its callback.
  const Simulation& read() const;
  void step();
  void run(const RunRequest& request);
  void set_field(const std::string& name, const std::vector<double>& values);
  void end_stage();
  void perturb(double speed);
  void set_step_factor(double factor);
  void set_model(const std::string& material, py::function update, const py::dict& history);
  py::dict model_history(const std::string& material) const;
  std::shared_ptr<Session> clone() const;

  /// Counts changes of the particles; what was seen before the last one is not valid.
  std::uint64_t generation() const { return generation_; }
  void pin() { ++pins_; }
  void unpin() { --pins_; }

 private:
  class Change;
  bool call(const py::object& callback);

  Simulation simulation_;
  RunOptions options_;
  std::unique_ptr<RunOutputs> outputs_;
  std::map<std::string, std::shared_ptr<NumpyModel>> models_;  ///< by material
  std::uint64_t generation_ = 0;
  int pins_ = 0;  ///< views that are being read
  bool changing_ = false, calling_back_ = false;
  std::thread::id changer_;
};

/// One component of a field in the order of memory, without a copy.
class Slots {
 public:
  Slots(std::shared_ptr<Session> session, std::string field, std::size_t component);

  /// Whether the particles are still those that were there when it was made.
  bool valid() const { return session_->generation() == generation_; }
  /// An array that cannot be written, to be let go of before `unpin`. Errors: Error if it is not
  /// valid.
  py::array pin();
  void unpin() { session_->unpin(); }

 private:
  py::array array() const;

  std::shared_ptr<Session> session_;
  std::string field_;
  std::size_t component_;
  std::uint64_t generation_;
};

}  // namespace scarp::python
