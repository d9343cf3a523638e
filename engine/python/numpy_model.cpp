// SPDX-License-Identifier: BSD-3-Clause
/// Gathers what a model needs, calls it, puts the stress back.
#include "engine/python/numpy_model.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "engine/errors.hpp"
#include "kernels/constitutive/stress_pass.hpp"

namespace scarp::python {
namespace {

constexpr int stress_columns = 6;

/// Components of a symmetric tensor that a run stores.
int stored_columns(int dimension, int columns) {
  return dimension == 3 || columns == 1 ? columns : 4;
}

template <int Dim>
kernels::SymTensor<double> corrected_rate(const kernels::Tensor<double>& l,
                                          const kernels::SymTensor<double>& m, bool conjugate) {
  return kernels::symmetric_part(conjugate ? kernels::conjugate_gradient(l, m)
                                           : kernels::corrected_gradient<Dim>(l, m));
}

}  // namespace

NumpyModel::NumpyModel(std::string material, int dimension, std::vector<std::int64_t> ids,
                       const Numerics& numerics, py::function update, const py::dict& history)
    : material_(std::move(material)),
      dimension_(dimension),
      ids_(std::move(ids)),
      corrected_(numerics.gradient_correction),
      conjugate_(numerics.corrects_force()),
      update_(std::move(update)) {
  for (const auto& [name, initial] : history) {
    py::array_t<double> values(static_cast<py::ssize_t>(ids_.size()));
    std::fill_n(values.mutable_data(), ids_.size(), py::cast<double>(initial));
    history_[name] = values;
  }
}

void NumpyModel::find_slots(const PhaseView& view) {
  const auto ids = view.ids();
  if (std::equal(ids.begin(), ids.end(), order_.begin(), order_.end())) return;
  order_.assign(ids.begin(), ids.end());
  slots_.assign(ids_.size(), 0);
  for (std::size_t slot = 0; slot < ids.size(); ++slot) {
    const auto place = std::lower_bound(ids_.begin(), ids_.end(), ids[slot]);
    if (ids[slot] >= 0 && place != ids_.end() && *place == ids[slot])
      slots_[static_cast<std::size_t>(place - ids_.begin())] = slot;
  }
}

py::array_t<double> NumpyModel::gathered(const PhaseView& view, const char* field,
                                         int columns) const {
  py::array_t<double> values = columns == 1
                                   ? py::array_t<double>(static_cast<py::ssize_t>(ids_.size()))
                                   : py::array_t<double>({static_cast<py::ssize_t>(ids_.size()),
                                                          static_cast<py::ssize_t>(columns)});
  double* to = values.mutable_data();
  std::fill_n(to, values.size(), 0.0);
  const auto width = static_cast<std::size_t>(columns);
  for (int c = 0; c < stored_columns(dimension_, columns); ++c) {
    const auto from = view.read(field, c);
    for (std::size_t k = 0; k < ids_.size(); ++k)
      to[k * width + static_cast<std::size_t>(c)] = from[slots_[k]];
  }
  return values;
}

py::array_t<double> NumpyModel::strain(const PhaseView& view) const {
  py::array_t<double> values(
      {static_cast<py::ssize_t>(ids_.size()), static_cast<py::ssize_t>(stress_columns)});
  double* to = values.mutable_data();
  std::array<std::span<const double>, 9> gradient{};
  for (int c = 0; c < 9; ++c) {
    if (c / 3 < dimension_ && c % 3 < dimension_)
      gradient[static_cast<std::size_t>(c)] = view.read("velocity_gradient", c);
  }
  std::array<std::span<const double>, 6> moment{};
  if (corrected_) {
    for (int c = 0; c < stress_columns; ++c) {
      const bool plane = c == 0 || c == 1 || c == 3;  // zz of the moment is 1 in 2D
      if (plane || dimension_ == 3) moment[static_cast<std::size_t>(c)] = view.read("moment", c);
    }
  }
  const double time = view.time_step();
  for (std::size_t k = 0; k < ids_.size(); ++k) {
    const std::size_t slot = slots_[k];
    const auto at = [slot](std::span<const double> from, double otherwise) {
      return from.empty() ? otherwise : from[slot];
    };
    kernels::Tensor<double> l;
    for (std::size_t a = 0; a < 3; ++a) {
      for (std::size_t b = 0; b < 3; ++b) l.m[a][b] = at(gradient[3 * a + b], 0.0);
    }
    const kernels::SymTensor<double> m{at(moment[0], 1.0), at(moment[1], 1.0), at(moment[2], 1.0),
                                       at(moment[3], 0.0), at(moment[4], 0.0), at(moment[5], 0.0)};
    const kernels::SymTensor<double> rate =
        dimension_ == 2 ? corrected_rate<2>(l, m, conjugate_) : corrected_rate<3>(l, m, conjugate_);
    const std::array<double, 6> row{rate.xx, rate.yy, rate.zz, rate.xy, rate.yz, rate.zx};
    for (std::size_t c = 0; c < row.size(); ++c) to[k * row.size() + c] = time * row[c];
  }
  return values;
}

py::array_t<double> NumpyModel::checked(const py::handle& values, py::ssize_t columns,
                                        const std::string& what) const {
  using Array = py::array_t<double, py::array::c_style | py::array::forcecast>;
  const Array array = Array::ensure(values);
  if (!array) throw py::error_already_set();
  const auto count = static_cast<py::ssize_t>(ids_.size());
  const bool fits = columns == 1
                        ? array.ndim() == 1 && array.shape(0) == count
                        : array.ndim() == 2 && array.shape(0) == count && array.shape(1) == columns;
  if (!fits) {
    throw Error(fmt::format(
        "the model of '{}' left {} of another shape than {}.", material_, what,
        columns == 1 ? fmt::format("({},)", count) : fmt::format("({}, {})", count, columns)));
  }
  if (!std::all_of(array.data(), array.data() + array.size(),
                   [](double value) { return std::isfinite(value); })) {
    throw Error(
        fmt::format("the model of '{}' left {} with a value that is not finite.", material_, what));
  }
  return array;
}

void NumpyModel::before_pass(const PhaseView& view) {
  const py::gil_scoped_acquire lock;
  find_slots(view);
  stress_before_ = gathered(view, "stress", stress_columns);
}

void NumpyModel::after_pass(PhaseView& view) {
  const py::gil_scoped_acquire lock;
  const py::array_t<double> trial = gathered(view, "stress", stress_columns);
  const py::object answer = update_(trial, stress_before_, strain(view),
                                    gathered(view, "density", 1), history_, view.time_step());
  const py::array_t<double> stress = checked(answer, stress_columns, "a stress");
  for (const auto& [name, values] : history_) {
    const std::string words = "a history variable '" + py::cast<std::string>(name) + "'";
    history_[name] = checked(values, 1, words);
  }
  const double* from = stress.data();
  for (int c = 0; c < stored_columns(dimension_, stress_columns); ++c) {
    const auto to = view.write("stress", c);
    for (std::size_t k = 0; k < ids_.size(); ++k)
      to[slots_[k]] = from[k * stress_columns + static_cast<std::size_t>(c)];
  }
}

std::shared_ptr<NumpyModel> attach_model(Simulation& simulation, const std::string& material,
                                         py::function update, const py::dict& history) {
  const Scene& scene = simulation.scene();
  const std::size_t index = material_named(scene, material);
  if (scene.materials[index].model.name() != LinearElastic::name) {
    throw Error(fmt::format(
        "material '{}' is of the model '{}'. A model in Python corrects an elastic step: try model "
        "= \"linear_elastic\" in the scene.",
        material, scene.materials[index].model.name()));
  }
  if (scene.numerics.integrator != Integrator::kick_drift_kick) {
    throw Error(
        "a model in Python needs the integrator \"kick_drift_kick\", which takes the stress over "
        "one step at a time. Try preset = \"modern\".");
  }
  const std::vector<std::int64_t> ids = simulation.ids();
  const std::vector<double> materials = simulation.field("material");
  std::vector<std::int64_t> own;
  for (std::size_t k = 0; k < ids.size(); ++k) {
    if (materials[k] == static_cast<double>(index)) own.push_back(ids[k]);
  }
  auto model = std::make_shared<NumpyModel>(material, scene.dimension, std::move(own),
                                            scene.numerics, std::move(update), history);
  simulation.on_phase("advance_stress", When::before,
                      [model](PhaseView& view) { model->before_pass(view); });
  simulation.on_phase("advance_stress", When::after,
                      [model](PhaseView& view) { model->after_pass(view); });
  return model;
}

}  // namespace scarp::python
