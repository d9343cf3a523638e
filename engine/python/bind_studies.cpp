// SPDX-License-Identifier: BSD-3-Clause
/// Factor of safety, error estimates and element tests for Python.

#include <algorithm>

#include "engine/cli/fos_output.hpp"
#include "engine/converge/study.hpp"
#include "engine/element/element_path.hpp"
#include "engine/errors.hpp"
#include "engine/fos/dilation_note.hpp"
#include "engine/fos/strength_reduction.hpp"
#include "engine/python/bind.hpp"
#include "engine/run/run.hpp"
#include "engine/scene/nearest_name.hpp"

namespace scarp::python {
namespace {

py::dict trial_of(const Trial& trial) {
  return dict_of({{"reduction", py::cast(trial.reduction)},
                  {"fails", py::cast(trial.fails)},
                  {"end", py::cast(cli::word(trial.end))},
                  {"displacement", py::cast(trial.displacement)},
                  {"speed", py::cast(trial.speed)},
                  {"time", py::cast(trial.time)},
                  {"steps", py::cast(trial.steps)},
                  {"wall_s", py::cast(trial.wall_s)}});
}

py::dict fos(const Scene& scene, const SearchOptions& search, const CriterionOptions& wanted,
             const RunOptions& options, const py::object& progress) {
  check_reducible(scene);
  const Criterion criterion = choose_criterion(scene, wanted);
  const auto proceed = [](const Simulation&) { return true; };
  const auto done = [&](const FactorOfSafety& found, const Trial& trial) {
    if (progress.is_none() || found.trials.empty()) return;
    const py::gil_scoped_acquire lock;
    progress(trial_of(trial));
  };
  std::optional<StandingSlope> standing;
  FactorOfSafety found;
  {
    const py::gil_scoped_release free;
    standing = settle_standing(scene, options, criterion, proceed);
    if (standing) found = find_factor(standing->slope, search, proceed, done);
  }
  if (!standing) throw Stopped();
  const Criterion& used = standing->slope.criterion();
  py::list trials;
  for (const Trial& trial : found.trials) trials.append(trial_of(trial));
  std::vector<std::string> notes;
  if (const auto note = dilation_note(scene, found.bracket.factor())) notes.push_back(*note);
  return dict_of({{"factor", py::cast(found.bracket.factor())},
                  {"stands", py::cast(found.bracket.stands)},
                  {"fails", py::cast(found.bracket.fails)},
                  {"complete", py::cast(found.bracket.complete)},
                  {"elastic", trial_of(found.elastic)},
                  {"trials", trials},
                  {"notes", py::cast(notes)},
                  {"strengthening", py::cast(standing->strengthening)},
                  {"settle_time", py::cast(standing->settle_time)},
                  {"height", py::cast(used.height)},
                  {"limit", py::cast(used.limit)},
                  {"ramp", py::cast(used.ramp)},
                  {"window", py::cast(used.window)},
                  {"probe", py::cast(used.probe)}});
}

SpacingRun run_at(const Scene& scene, const RunOptions& options) {
  Simulation simulation(scene, options);
  SpacingRun done;
  done.spacing = scene.spacing;
  done.wall_s = run(simulation, {.warn = warn});
  done.particles = static_cast<double>(simulation.soil_count());
  done.steps = static_cast<double>(simulation.last_step().step);
  done.mass = simulation.soil_mass();
  done.values = end_values(simulation);
  return done;
}

py::list quantities_of(const Study& study) {
  py::list found;
  for (const Convergence& c : study.quantities) {
    std::vector<double> values(c.values.size());
    std::transform(c.values.begin(), c.values.end(), values.begin(),
                   [](const ValueAtSpacing& at) { return at.value; });
    found.append(dict_of({{"name", py::cast(c.quantity.name)},
                          {"unit", py::cast(c.quantity.unit)},
                          {"values", py::cast(values)},
                          {"trend", py::cast(word(c.estimate.trend))},
                          {"observed_order", py::cast(c.estimate.observed_order)},
                          {"order", py::cast(c.estimate.order)},
                          {"extrapolated", py::cast(c.estimate.extrapolated)},
                          {"errors", py::cast(c.estimate.error)},
                          {"remark", py::cast(remark(c.estimate))}}));
  }
  return found;
}

/// `scenes`: the same scene from coarse to fine.
py::dict converge(const std::vector<Scene>& scenes, const RunOptions& options,
                  const py::object& progress) {
  if (scenes.size() != 3) throw py::value_error("three spacings are needed");
  const std::vector<EndQuantity> quantities = end_quantities(scenes.front());
  std::array<SpacingRun, 3> runs;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    {
      const py::gil_scoped_release free;
      runs[k] = run_at(scenes[k], options);
    }
    if (!progress.is_none())
      progress(runs[k].spacing, runs[k].wall_s, runs[k].particles, runs[k].steps);
  }
  const Study study = assess(quantities, runs, scenes.front().dimension);
  py::list rows, advice;
  for (const SpacingRun& one : study.runs) {
    rows.append(dict_of({{"spacing", py::cast(one.spacing)},
                         {"wall_s", py::cast(one.wall_s)},
                         {"particles", py::cast(one.particles)},
                         {"steps", py::cast(one.steps)},
                         {"mass", py::cast(one.mass)}}));
  }
  for (const Advice& one : study.advice) {
    advice.append(dict_of({{"target", py::cast(one.target)},
                           {"spacing", py::cast(one.spacing)},
                           {"wall_s", py::cast(one.wall_s)},
                           {"decided_by", py::cast(one.decided_by)}}));
  }
  return dict_of({{"runs", rows},
                  {"quantities", quantities_of(study)},
                  {"advice", advice},
                  {"notes", py::cast(study.notes)}});
}

ElementPath path_named(const std::string& name) {
  const auto found = std::find(element_path_names.begin(), element_path_names.end(), name);
  if (found == element_path_names.end())
    throw py::value_error("path: there is no '" + name + "'. " +
                          did_you_mean(name, element_path_names));
  return static_cast<ElementPath>(found - element_path_names.begin());
}

/// Columns of the samples; in the plane without those that stay 0.
py::dict table_of(const ElementResult& result) {
  py::dict table;
  const auto add = [&](const std::string& name, const auto& value_of) {
    std::vector<double> column(result.samples.size());
    std::transform(result.samples.begin(), result.samples.end(), column.begin(), value_of);
    table[py::str(name)] = array_of(std::move(column));
  };
  constexpr std::array<const char*, 6> components{"xx", "yy", "zz", "xy", "yz", "zx"};
  const std::size_t count = result.dimension == 2 ? 4 : 6;
  for (std::size_t c = 0; c < count; ++c)
    add(std::string("strain_") + components[c],
        [c](const ElementSample& sample) { return sample.strain[c]; });
  for (std::size_t c = 0; c < count; ++c)
    add(std::string("stress_") + components[c],
        [c](const ElementSample& sample) { return sample.stress[c]; });
  add("I1", [](const ElementSample& sample) { return sample.first_invariant; });
  add("sqrt_J2", [](const ElementSample& sample) { return sample.root_j2; });
  add("deviator", [](const ElementSample& sample) { return deviator(sample); });
  add("volumetric_strain", [](const ElementSample& sample) { return sample.volumetric_strain; });
  if (!result.plastic) return table;
  add("yield_function", [](const ElementSample& sample) { return sample.yield_function; });
  for (std::size_t h = 0; h < result.history.size(); ++h)
    add(result.history[h].name, [h](const ElementSample& sample) { return sample.history[h]; });
  add("plastic_volumetric_strain",
      [](const ElementSample& sample) { return sample.plastic_volumetric_strain; });
  return table;
}

py::dict element(const Scene& scene, const std::string& path, const std::string& material,
                 double confining, double strain, int steps, const RunOptions& options) {
  const ElementTest test{path_named(path), material, confining, strain, steps};
  ElementResult result;
  {
    const py::gil_scoped_release free;
    result = run_element(scene, test, options);
  }
  return dict_of({{"table", table_of(result)},
                  {"isa", py::cast(result.isa)},
                  {"constants", py::cast(result.constants)},
                  {"bulk_modulus", py::cast(result.bulk_modulus)},
                  {"shear_modulus", py::cast(result.shear_modulus)},
                  {"first_yield", py::cast(result.first_yield)},
                  {"control_error", py::cast(result.control_error)}});
}

}  // namespace

void bind_studies(py::module_& module) {
  const auto none = py::none();
  module.def(
      "fos",
      [](const Scene& scene, double from, std::optional<double> to, double tolerance,
         std::optional<double> height, std::optional<double> ramp, std::optional<double> window,
         const std::string& probe, bool early_stop, std::optional<int> threads,
         const std::string& isa, const py::object& progress) {
        return fos(scene, {from, to, tolerance}, {height, ramp, window, probe, early_stop},
                   run_options(threads, isa, false), progress);
      },
      py::arg("scene"), py::arg("start") = 1.0, py::arg("to") = none, py::arg("tolerance") = 0.01,
      py::arg("height") = none, py::arg("ramp") = none, py::arg("window") = none,
      py::arg("probe") = "", py::arg("early_stop") = true, py::arg("threads") = none,
      py::arg("isa") = "", py::arg("progress") = none);
  module.def(
      "converge",
      [](const std::vector<Scene>& scenes, std::optional<int> threads, const std::string& isa,
         const py::object& progress) {
        return converge(scenes, run_options(threads, isa, false), progress);
      },
      py::arg("scenes"), py::arg("threads") = none, py::arg("isa") = "",
      py::arg("progress") = none);
  module.def(
      "element",
      [](const Scene& scene, const std::string& path, const std::string& material, double confining,
         double strain, int steps, const std::string& isa) {
        return element(scene, path, material, confining, strain, steps,
                       run_options({}, isa, false));
      },
      py::arg("scene"), py::arg("path"), py::arg("material"), py::arg("confining"),
      py::arg("strain"), py::arg("steps"), py::arg("isa") = "");
}

}  // namespace scarp::python
