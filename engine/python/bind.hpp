// SPDX-License-Identifier: BSD-3-Clause
/// What the parts of the Python module share.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <initializer_list>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/run_options.hpp"

namespace scarp::python {

namespace py = pybind11;

void bind_errors(py::module_& module);
void bind_scene(py::module_& module);
void bind_session(py::module_& module);
void bind_studies(py::module_& module);

/// Whether a signal handler of Python has raised something, such as KeyboardInterrupt; what it was
/// is raised where `Stopped` reaches Python. Looks every tenth of a second, because that takes
/// Python's lock.
bool stopped_by_signal();

/// Options of a run that Python may stop.
RunOptions run_options(std::optional<int> threads, std::string isa, bool oversubscribe);

/// Raises Python's RuntimeWarning; where warnings are errors, throws it.
void warn(const std::string& words);

/// Hands the numbers over to an array with so many columns; one column: of one dimension.
py::array_t<double> array_of(std::vector<double> values, std::size_t columns = 1);

/// A dict of these items, in their order.
py::dict dict_of(std::initializer_list<std::pair<const char*, py::object>> items);

}  // namespace scarp::python
