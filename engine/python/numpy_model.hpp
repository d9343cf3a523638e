// SPDX-License-Identifier: BSD-3-Clause
/// A soil model as a function of Python over all particles of a material.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "engine/python/bind.hpp"
#include "engine/simulation.hpp"

namespace scarp::python {

/// Corrects the stress after the elastic pass of each step. Arrays are in the order of the
/// particles' ids, so that the function never sees how they lie in memory.
class NumpyModel {
 public:
  /// `ids`: of the material's particles, ascending. `numerics`: of the scene.
  NumpyModel(std::string material, int dimension, std::vector<std::int64_t> ids,
             const Numerics& numerics, py::function update, const py::dict& history);

  void before_pass(const PhaseView& view);
  /// Errors: Error for a stress or history of another shape or with values that are not finite;
  /// what the function raises.
  void after_pass(PhaseView& view);

  py::dict history() const { return history_; }

 private:
  void find_slots(const PhaseView& view);
  /// One row for each particle; the columns that a run of this dimension does not store stay 0.
  py::array_t<double> gathered(const PhaseView& view, const char* field, int columns) const;
  py::array_t<double> strain(const PhaseView& view) const;
  py::array_t<double> checked(const py::handle& values, py::ssize_t columns,
                              const std::string& what) const;

  std::string material_;
  int dimension_;
  std::vector<std::int64_t> ids_;
  bool corrected_, conjugate_;       ///< the velocity gradient, and the force with it
  std::vector<std::int64_t> order_;  ///< ids in the order of memory when `slots_` were found
  std::vector<std::size_t> slots_;   ///< of each id
  py::function update_;
  py::dict history_;
  py::array_t<double> stress_before_;
};

/// Lets the function act in each step of a simulation. Errors: Error unless the material is
/// `linear_elastic` and the integrator kick-drift-kick.
std::shared_ptr<NumpyModel> attach_model(Simulation& simulation, const std::string& material,
                                         py::function update, const py::dict& history);

}  // namespace scarp::python
