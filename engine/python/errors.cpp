// SPDX-License-Identifier: BSD-3-Clause
/// Errors of the library as exceptions of Python, and signals of Python as a wish to stop.

#include "engine/errors.hpp"

#include <chrono>
#include <exception>
#include <utility>

#include "engine/cli/ending.hpp"
#include "engine/python/bind.hpp"
#include "engine/scene/units.hpp"

namespace scarp::python {
namespace {

/// The exception classes; a module lives as long as its process.
struct Kinds {
  PyObject *error = nullptr, *scene = nullptr, *file = nullptr, *checkpoint = nullptr,
           *instability = nullptr;
};
Kinds kinds;

/// What a signal handler has raised and nobody has been told of yet.
thread_local std::exception_ptr raised;

PyObject* new_kind(py::module_& module, const char* name, const char* doc, const py::tuple& bases) {
  const std::string full = std::string("scarp.") + name;
  PyObject* kind = PyErr_NewExceptionWithDoc(full.c_str(), doc, bases.ptr(), nullptr);
  if (kind == nullptr) throw py::error_already_set();
  module.attr(name) = py::handle(kind);
  return kind;
}

void raise_instability(const SimulationInstability& error) {
  const py::object value = py::handle(kinds.instability)(error.what());
  if (const auto& what = error.what_happened()) {
    value.attr("step") = what->step;
    value.attr("time") = what->time;
    value.attr("stage") = what->stage;
    value.attr("particle") = what->particle;
    value.attr("position") =
        py::make_tuple(what->position[0], what->position[1], what->position[2]);
    value.attr("field") = what->field;
    value.attr("unit") = what->unit;
    value.attr("value") = what->value;
    value.attr("limit") = what->limit;
    value.attr("cause") = what->cause;
    value.attr("advice") = what->advice;
  }
  PyErr_SetObject(kinds.instability, value.ptr());
}

void raise_stopped() {
  if (const std::exception_ptr mine = std::exchange(raised, nullptr)) std::rethrow_exception(mine);
  PyErr_SetNone(PyExc_KeyboardInterrupt);
}

/// The most special kind first.
void translate(std::exception_ptr thrown) {
  try {
    if (thrown) std::rethrow_exception(std::move(thrown));
  } catch (const Stopped&) {
    raise_stopped();
  } catch (const SimulationInstability& error) {
    raise_instability(error);
  } catch (const SceneError& error) {
    PyErr_SetString(kinds.scene, error.what());
  } catch (const CheckpointError& error) {
    PyErr_SetString(kinds.checkpoint, error.what());
  } catch (const FileError& error) {
    PyErr_SetString(kinds.file, error.what());
  } catch (const Error& error) {
    PyErr_SetString(kinds.error, error.what());
  } catch (const UnitError& error) {
    PyErr_SetString(PyExc_ValueError, error.what());
  } catch (const cli::UsageError& error) {
    PyErr_SetString(PyExc_ValueError, error.what());
  }
}

}  // namespace

bool stopped_by_signal() {
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::milliseconds interval(100);
  thread_local Clock::time_point last;
  if (raised) return true;
  const Clock::time_point now = Clock::now();
  if (now - last < interval) return false;
  last = now;
  const py::gil_scoped_acquire lock;
  if (PyErr_CheckSignals() == 0) return false;
  raised = std::make_exception_ptr(py::error_already_set());
  return true;
}

void warn(const std::string& words) {
  const py::gil_scoped_acquire lock;
  if (PyErr_WarnEx(PyExc_RuntimeWarning, words.c_str(), 2) != 0) throw py::error_already_set();
}

void bind_errors(py::module_& module) {
  const auto bases = [](auto... kind) { return py::make_tuple(py::handle(kind)...); };
  kinds.error =
      new_kind(module, "Error", "Base of all errors that scarp reports.", bases(PyExc_Exception));
  kinds.scene = new_kind(module, "SceneError",
                         "A scene that cannot be run; the message names line, key, value, why it "
                         "is wrong and what to try.",
                         bases(kinds.error, PyExc_ValueError));
  kinds.file = new_kind(module, "FileError", "A file that cannot be read or written.",
                        bases(kinds.error, PyExc_OSError));
  kinds.checkpoint =
      new_kind(module, "CheckpointError",
               "A checkpoint that cannot be gone on from: damaged, of another scene or version.",
               bases(kinds.error));
  kinds.instability = new_kind(
      module, "SimulationInstability",
      "A run that left the physical range. The state stays readable. Attributes: step, time [s], "
      "stage, particle (its id), position [m], field, unit, value, limit, cause, advice.",
      bases(kinds.error, PyExc_ArithmeticError));
  py::register_exception_translator(translate);
}

}  // namespace scarp::python
