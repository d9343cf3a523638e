// SPDX-License-Identifier: BSD-3-Clause
/// Scenes for Python: the reader of the program, and what a scene says.

#include <algorithm>

#include "engine/check/warnings.hpp"
#include "engine/cli/texts.hpp"
#include "engine/python/bind.hpp"
#include "engine/scene/scene_reader.hpp"
#include "engine/scene/units.hpp"

namespace scarp::python {
namespace {

kernels::Unit unit_named(const std::string& name) {
  using kernels::Unit;
  if (name == "length") return Unit::length;
  if (name == "time") return Unit::time;
  if (name == "pressure") return Unit::pressure;
  throw py::value_error("no unit for '" + name + "'");
}

/// Names of the items of a list of the scene.
template <class Item>
std::vector<std::string> names(const std::vector<Item>& items) {
  std::vector<std::string> found(items.size());
  std::transform(items.begin(), items.end(), found.begin(),
                 [](const Item& item) { return item.name; });
  return found;
}

SceneOverrides overrides(const std::string& preset, std::optional<double> spacing) {
  return {preset, spacing};
}

}  // namespace

void bind_scene(py::module_& module) {
  module.def(
      "quantity",
      [](const std::string& text, const std::string& unit) {
        return parse_quantity(text, unit_named(unit));
      },
      py::arg("text"), py::arg("unit"), "A text with a unit, such as \"100 kPa\", in SI.");
  module.def(
      "template_text",
      [](const std::string& name) { return std::string(cli::template_named(name).text); },
      py::arg("name"), "The scene that `scarp new NAME` writes.");
  py::class_<Scene>(module, "Scene", "A scene that has been read and checked.")
      .def_static(
          "read",
          [](const std::string& path, const std::string& preset, std::optional<double> spacing) {
            return read_scene(path, overrides(preset, spacing));
          },
          py::arg("path"), py::arg("preset") = "", py::arg("spacing") = py::none())
      .def_static(
          "read_text",
          [](const std::string& text, const std::string& name, const std::string& preset,
             std::optional<double> spacing) {
            return read_scene_text(text, name, overrides(preset, spacing));
          },
          py::arg("text"), py::arg("name"), py::arg("preset") = "", py::arg("spacing") = py::none())
      .def_readonly("title", &Scene::title)
      .def_readonly("file", &Scene::file)
      .def_readonly("text", &Scene::text)
      .def_readonly("dimension", &Scene::dimension)
      .def_readonly("spacing", &Scene::spacing)
      .def_readonly("gravity", &Scene::gravity)
      .def_property_readonly("preset", [](const Scene& scene) { return scene.numerics.preset; })
      .def_property_readonly("materials", [](const Scene& scene) { return names(scene.materials); })
      .def_property_readonly("walls", [](const Scene& scene) { return names(scene.walls); })
      .def_property_readonly("stages", [](const Scene& scene) { return names(scene.stages); })
      .def_property_readonly("probes", [](const Scene& scene) { return names(scene.probes); })
      .def("warnings", [](const Scene& scene) { return warnings(scene); });
}

}  // namespace scarp::python
