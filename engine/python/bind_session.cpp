// SPDX-License-Identifier: BSD-3-Clause
/// `_core.Session`: what `scarp.Simulation` is made of.

#include <algorithm>

#include "engine/boundary/facet_geometry.hpp"
#include "engine/check/start_warnings.hpp"
#include "engine/cli/resumed_run.hpp"
#include "engine/cli/run_record.hpp"
#include "engine/energy/energy_balance.hpp"
#include "engine/errors.hpp"
#include "engine/output/checkpoint_file.hpp"
#include "engine/python/session.hpp"

namespace scarp::python {
namespace {

using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

std::shared_ptr<Session> new_session(const Scene& scene, std::optional<int> threads,
                                     const std::string& isa, bool oversubscribe) {
  const RunOptions options = run_options(threads, isa, oversubscribe);
  const py::gil_scoped_release free;
  return std::make_shared<Session>(Simulation(scene, options), options);
}

std::shared_ptr<Session> resumed_session(const Scene& scene, const std::string& path,
                                         std::optional<int> threads, const std::string& isa,
                                         bool oversubscribe) {
  const RunOptions options = run_options(threads, isa, oversubscribe);
  const py::gil_scoped_release free;
  return std::make_shared<Session>(Simulation(scene, read_checkpoint(path), options), options);
}

/// The scene of a run's folder as it was recorded, what replaced its preset and spacing, and the
/// run with its outputs.
py::tuple resumed_folder(const std::string& folder, std::optional<int> threads,
                         const std::string& isa) {
  const cli::RunRecord record = cli::read_record(folder);
  auto lock = std::make_unique<FolderLock>(folder);
  if (cli::run_is_finished(folder))
    throw Error("'" + folder + "': the run is complete; there is nothing to go on with.");
  const Scene scene = read_scene_text(record.scene_text, record.scene_name, record.overrides);
  const RunOptions options = run_options(threads, isa.empty() ? record.isa : isa, false);
  std::shared_ptr<Session> session;
  {
    const py::gil_scoped_release free;
    const cli::RunToResume run{folder, scene, options};
    std::optional<cli::ResumedRun> resumed = cli::go_on(run, warn);
    if (!resumed) resumed.emplace(cli::start_over(run));
    auto outputs =
        std::make_unique<RunOutputs>(resumed->simulation, std::move(lock),
                                     std::move(resumed->writer), std::move(resumed->recovery));
    session =
        std::make_shared<Session>(std::move(resumed->simulation), options, std::move(outputs));
  }
  return py::make_tuple(scene, record.overrides.preset, record.overrides.spacing, session);
}

/// Rows of a table with so many columns; fewer than three are padded with zeros.
template <std::size_t Columns>
std::vector<std::array<double, Columns>> rows(const Numbers& table, const char* what) {
  const auto given = static_cast<std::size_t>(table.ndim() == 2 ? table.shape(1) : 0);
  if (given < std::min<std::size_t>(2, Columns) || given > Columns)
    throw py::value_error(std::string(what) + ": it needs one row for each particle");
  std::vector<std::array<double, Columns>> found(static_cast<std::size_t>(table.shape(0)));
  for (std::size_t k = 0; k < found.size(); ++k) {
    found[k] = {};
    std::copy_n(table.data() + k * given, given, found[k].begin());
  }
  return found;
}

std::shared_ptr<Session> session_of_particles(
    const Scene& scene, const Numbers& position, const std::optional<Numbers>& velocity,
    const std::optional<std::vector<std::size_t>>& material,
    const std::optional<std::vector<std::int64_t>>& id, const std::optional<Numbers>& stress,
    const std::optional<std::vector<double>>& density, std::optional<int> threads,
    const std::string& isa, bool oversubscribe) {
  Particles particles{.position = rows<3>(position, "position")};
  if (velocity) particles.velocity = rows<3>(*velocity, "velocity");
  if (stress) particles.stress = rows<6>(*stress, "stress");
  particles.material = material.value_or(std::vector<std::size_t>{});
  particles.id = id.value_or(std::vector<std::int64_t>{});
  particles.density = density.value_or(std::vector<double>{});
  const RunOptions options = run_options(threads, isa, oversubscribe);
  const py::gil_scoped_release free;
  return std::make_shared<Session>(Simulation(scene, particles, options), options);
}

py::tuple report_of(const StepReport& report) {
  return py::make_tuple(report.step, report.time, report.stage_time, report.time_step,
                        name_of(report.limit), report.max_velocity);
}

py::array_t<double> field_of(const Session& session, const std::string& name) {
  const Simulation& simulation = session.read();
  std::vector<double> values = simulation.field(name);
  const std::size_t columns = values.size() / std::max<std::size_t>(simulation.soil_count(), 1);
  return array_of(std::move(values), std::max<std::size_t>(columns, 1));
}

py::dict probe_of(const Simulation& simulation, const std::string& name) {
  const ProbeSample sample = simulation.probe(name);
  py::dict history;
  std::size_t next = 0;
  for (const auto& variable : history_of(simulation.scene())) {
    if (variable.output) history[variable.name] = sample.history.at(next++);
  }
  const auto array = [](const auto& values) { return array_of({values.begin(), values.end()}); };
  return dict_of({{"name", py::cast(sample.probe)},
                  {"position", array(sample.position)},
                  {"displacement", array(sample.displacement)},
                  {"velocity", array(sample.velocity)},
                  {"stress", array(sample.stress)},
                  {"density", py::cast(sample.density)},
                  {"history", history}});
}

py::dict energy_of(const EnergyBalance& e) {
  return dict_of({{"kinetic", py::cast(e.kinetic)},
                  {"kinetic_added", py::cast(e.kinetic_added)},
                  {"potential", py::cast(e.potential)},
                  {"elastic", py::cast(e.elastic)},
                  {"plastic", py::cast(e.plastic)},
                  {"viscous", py::cast(e.viscous)},
                  {"damping", py::cast(e.damping)},
                  {"wall", py::cast(e.wall)},
                  {"artificial_stress", py::cast(e.artificial_stress)},
                  {"gradient_residue", py::cast(e.gradient_residue)},
                  {"diffusion", py::cast(e.diffusion)},
                  {"sleep", py::cast(e.sleep)},
                  {"hooks", py::cast(e.hooks)},
                  {"imbalance", py::cast(e.imbalance)}});
}

/// Corners, three numbers each, and the walls of the faces.
py::tuple faces_of(const Simulation& simulation) {
  std::vector<double> positions, walls;
  for (const WallFace& face : simulation.wall_faces()) {
    for (const Vec3& corner : geometry::corners(face.facet, simulation.scene().dimension))
      positions.insert(positions.end(), corner.begin(), corner.end());
    walls.push_back(static_cast<double>(face.wall));
  }
  return py::make_tuple(array_of(std::move(positions), 3), array_of(std::move(walls)));
}

py::list fields_of(const Simulation& simulation) {
  py::list found;
  for (const FieldInfo& field : simulation.fields()) {
    found.append(py::make_tuple(field.name, field.unit, field.components, field.description,
                                field.numbers != FieldInfo::Numbers::real));
  }
  return found;
}

py::dict reactions_of(const Simulation& simulation) {
  py::dict forces;
  for (const WallReaction& reaction : simulation.wall_reactions())
    forces[py::str(reaction.wall)] = array_of({reaction.force.begin(), reaction.force.end()});
  return forces;
}

}  // namespace

void bind_session(py::module_& module) {
  const auto none = py::none();
  py::class_<Slots>(module, "Slots", "One component of a field in the order of memory.")
      .def(py::init<std::shared_ptr<Session>, std::string, std::size_t>(), py::arg("session"),
           py::arg("field"), py::arg("component"))
      .def_property_readonly("valid", &Slots::valid)
      .def("pin", &Slots::pin)
      .def("unpin", &Slots::unpin);
  py::class_<Session, std::shared_ptr<Session>>(module, "Session", "A simulation.")
      .def(py::init(&new_session), py::arg("scene"), py::arg("threads") = none, py::arg("isa") = "",
           py::arg("oversubscribe") = false)
      .def_static("resume", &resumed_session, py::arg("scene"), py::arg("path"),
                  py::arg("threads") = none, py::arg("isa") = "", py::arg("oversubscribe") = false)
      .def_static("resume_folder", &resumed_folder, py::arg("folder"), py::arg("threads") = none,
                  py::arg("isa") = "")
      .def_static("from_particles", &session_of_particles, py::arg("scene"), py::arg("position"),
                  py::arg("velocity") = none, py::arg("material") = none, py::arg("id") = none,
                  py::arg("stress") = none, py::arg("density") = none, py::arg("threads") = none,
                  py::arg("isa") = "", py::arg("oversubscribe") = false)
      .def("step", &Session::step)
      .def(
          "run",
          [](Session& session, std::optional<double> until, std::optional<double> every,
             py::object callback, std::string folder, bool overwrite) {
            session.run({until, every, std::move(callback), std::move(folder), overwrite});
          },
          py::arg("until") = none, py::arg("every") = none, py::arg("callback") = none,
          py::arg("folder") = "", py::arg("overwrite") = false)
      .def("end_stage", &Session::end_stage)
      .def("perturb", &Session::perturb, py::arg("speed"))
      .def("clone", &Session::clone)
      .def(
          "save",
          [](const Session& session, const std::string& path) {
            write_checkpoint(path, session.read().snapshot());
          },
          py::arg("path"))
      .def("field", &field_of, py::arg("name"))
      .def(
          "set_field",
          [](Session& session, const std::string& name, const Numbers& values) {
            session.set_field(name, {values.data(), values.data() + values.size()});
          },
          py::arg("name"), py::arg("values"))
      .def("set_model", &Session::set_model, py::arg("material"), py::arg("update"),
           py::arg("history"))
      .def("model_history", &Session::model_history, py::arg("material"))
      .def_property(
          "step_factor", [](const Session& session) { return session.read().step_factor(); },
          &Session::set_step_factor)
      .def("fields", [](const Session& session) { return fields_of(session.read()); })
      .def("ids",
           [](const Session& session) {
             const std::vector<std::int64_t> ids = session.read().ids();
             return py::array_t<std::int64_t>(static_cast<py::ssize_t>(ids.size()), ids.data());
           })
      .def("wall_positions",
           [](const Session& session) { return array_of(session.read().wall_positions(), 3); })
      .def("wall_faces", [](const Session& session) { return faces_of(session.read()); })
      .def(
          "probe",
          [](const Session& session, const std::string& name) {
            return probe_of(session.read(), name);
          },
          py::arg("name"))
      .def("energy", [](const Session& session) { return energy_of(session.read().energy()); })
      .def("reactions", [](const Session& session) { return reactions_of(session.read()); })
      .def("lost",
           [](const Session& session) {
             const LostSoil& lost = session.read().lost_soil();
             return py::make_tuple(lost.particles, lost.mass);
           })
      .def("last_step",
           [](const Session& session) { return report_of(session.read().last_step()); })
      .def("start_warnings",
           [](const Session& session) { return check::start_warnings(session.read()); })
      .def_property_readonly("finished",
                             [](const Session& session) { return session.read().finished(); })
      .def_property_readonly("stage_index",
                             [](const Session& session) { return session.read().stage_index(); })
      .def_property_readonly("stage_ended",
                             [](const Session& session) { return session.read().stage_ended(); })
      .def_property_readonly(
          "stage_reached_rest",
          [](const Session& session) { return session.read().stage_reached_rest(); })
      .def_property_readonly("soil_count",
                             [](const Session& session) { return session.read().soil_count(); })
      .def_property_readonly("wall_count",
                             [](const Session& session) { return session.read().wall_count(); })
      .def_property_readonly("soil_mass",
                             [](const Session& session) { return session.read().soil_mass(); })
      .def_property_readonly(
          "smoothing_length",
          [](const Session& session) { return session.read().smoothing_length(); })
      .def_property_readonly("isa", [](const Session& session) { return session.read().isa(); })
      .def_property_readonly("threads",
                             [](const Session& session) { return session.read().threads(); })
      .def_property_readonly("rebuild_count",
                             [](const Session& session) { return session.read().rebuild_count(); });
}

}  // namespace scarp::python
