// SPDX-License-Identifier: BSD-3-Clause
/// The extension module `scarp._core`: the library with Python's types, no more.

#include "engine/output/results.hpp"
#include "engine/python/bind.hpp"

namespace scarp::python {

RunOptions run_options(std::optional<int> threads, std::string isa, bool oversubscribe) {
  RunOptions options;
  options.threads = threads;
  options.isa = std::move(isa);
  options.oversubscribe = oversubscribe;
  options.stop = stopped_by_signal;
  return options;
}

py::array_t<double> array_of(std::vector<double> values, std::size_t columns) {
  auto* owned = new std::vector<double>(std::move(values));
  const py::capsule owner(owned,
                          [](void* data) { delete static_cast<std::vector<double>*>(data); });
  const auto width = static_cast<py::ssize_t>(columns);
  const auto count = static_cast<py::ssize_t>(owned->size()) / width;
  if (columns == 1) return py::array_t<double>(count, owned->data(), owner);
  return py::array_t<double>({count, width}, owned->data(), owner);
}

py::dict dict_of(std::initializer_list<std::pair<const char*, py::object>> items) {
  py::dict made;
  for (const auto& [name, value] : items) made[name] = value;
  return made;
}

}  // namespace scarp::python

PYBIND11_MODULE(_core, module) {
  namespace python = scarp::python;
  module.doc() = "The compiled part of scarp. Use the package `scarp`.";
  module.attr("version") = scarp::program_version();
  python::bind_errors(module);
  python::bind_scene(module);
  python::bind_session(module);
  python::bind_studies(module);
}
