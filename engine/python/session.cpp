// SPDX-License-Identifier: BSD-3-Clause
/// Steps without Python's lock, and views that end with them.
#include "engine/python/session.hpp"

#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "engine/errors.hpp"

namespace scarp::python {

/// While it lives the particles change; views made before are over from its beginning.
class Session::Change {
 public:
  explicit Change(Session& session) : session_(session) {
    if (session.calling_back_ && session.changer_ == std::this_thread::get_id()) {
      throw Error(
          "run() is going on: its callback may read the simulation, and end the run by returning "
          "False, but not change it.");
    }
    if (session.changing_)
      throw Error("the simulation is in a step on another thread. Try to wait for it.");
    if (session.pins_ > 0)
      throw Error("a view of the simulation is being read on another thread. Try to wait for it.");
    session.changing_ = true;
    session.changer_ = std::this_thread::get_id();
    ++session.generation_;
  }
  Change(const Change&) = delete;
  Change& operator=(const Change&) = delete;
  ~Change() { session_.changing_ = false; }

 private:
  Session& session_;
};

const Simulation& Session::read() const {
  const bool mine = calling_back_ && changer_ == std::this_thread::get_id();
  if (changing_ && !mine)
    throw Error("the simulation is in a step on another thread. Try to wait for it.");
  return simulation_;
}

void Session::step() {
  const Change change(*this);
  const py::gil_scoped_release free;
  simulation_.step();
}

/// Called from a run without Python's lock, between two steps.
bool Session::call(const py::object& callback) {
  const py::gil_scoped_acquire lock;
  ++generation_;
  calling_back_ = true;
  struct End {
    bool& flag;
    ~End() { flag = false; }
  } const end{calling_back_};
  const py::object answer = callback();
  ++generation_;  // its views end with the next step
  return !answer.is(py::bool_(false));
}

void Session::run(const RunRequest& request) {
  const Change change(*this);
  if (!request.folder.empty() && !models_.empty() && simulation_.scene().retries > 0)
    throw Error(
        "a run with a model in Python cannot go back. Try retry = 0 in [run] of the scene.");
  if (!request.folder.empty() && !outputs_) {
    if (simulation_.last_step().step > 0)
      throw Error("the outputs of a run begin at its start. Try a new Simulation, or no folder.");
    const py::gil_scoped_release free;
    outputs_ =
        std::make_unique<RunOutputs>(simulation_, options_, request.folder, request.overwrite);
  } else if (outputs_ && !request.folder.empty() && outputs_->folder() != request.folder) {
    throw Error(fmt::format("the outputs of this run are in '{}'. Try the same folder, or none.",
                            outputs_->folder().string()));
  }
  RunCourse course;
  if (outputs_) outputs_->join(course);
  course.warn = warn;
  if (request.until) {
    course.until = [&](const Simulation& now) {
      return now.finished() || now.last_step().time >= *request.until;
    };
  }
  const bool calls = !request.callback.is_none();
  const double interval = request.every.value_or(0.0);
  const auto next_after = [interval](double time) {
    return interval > 0.0 ? interval * (std::floor(time / interval) + 1.0) : 0.0;
  };
  double next = next_after(simulation_.last_step().time);
  bool goes_on = true, lost = simulation_.lost_soil().particles > 0;
  course.after_step = [&](const Simulation& now) {
    if (!lost && now.lost_soil().particles > 0) {
      lost = true;
      warn(now.lost_soil().message(now.soil_count()) + " The run goes on.");
    }
    const double time = now.last_step().time;
    if (calls && (time >= next || now.finished())) {
      next = next_after(time);
      goes_on = call(request.callback);
    }
    return goes_on;
  };
  try {
    const py::gil_scoped_release free;
    const double seconds = scarp::run(simulation_, course);
    if (outputs_ && course.until && simulation_.finished() && goes_on)
      outputs_->finish(simulation_, seconds);
  } catch (...) {
    outputs_.reset();
    throw;
  }
  if (simulation_.finished() || !goes_on) outputs_.reset();
}

void Session::set_field(const std::string& name, const std::vector<double>& values) {
  const Change change(*this);
  simulation_.set_field(name, values);
}

void Session::end_stage() {
  const Change change(*this);
  simulation_.end_stage();
}

void Session::perturb(double speed) {
  const Change change(*this);
  simulation_.perturb(speed);
}

void Session::set_step_factor(double factor) {
  const Change change(*this);
  simulation_.set_step_factor(factor);
}

void Session::set_model(const std::string& material, py::function update, const py::dict& history) {
  const Change change(*this);
  if (models_.count(material) > 0)
    throw Error(fmt::format("material '{}' has a model in Python already.", material));
  models_[material] = attach_model(simulation_, material, std::move(update), history);
}

py::dict Session::model_history(const std::string& material) const {
  static_cast<void>(read());
  const auto found = models_.find(material);
  if (found == models_.end())
    throw Error(fmt::format("material '{}' has no model in Python.", material));
  return found->second->history();
}

std::shared_ptr<Session> Session::clone() const {
  const Simulation& simulation = read();
  if (!models_.empty())
    throw Error("a simulation with a model in Python cannot be copied: both would share it.");
  return std::make_shared<Session>(simulation.clone(), options_);
}

Slots::Slots(std::shared_ptr<Session> session, std::string field, std::size_t component)
    : session_(std::move(session)),
      field_(std::move(field)),
      component_(component),
      generation_(session_->generation()) {
  static_cast<void>(array());  // a name or component that is not there is an error now
}

py::array Slots::array() const {
  const Simulation& simulation = session_->read();
  const py::capsule owner(new std::shared_ptr<Session>(session_),
                          [](void* data) { delete static_cast<std::shared_ptr<Session>*>(data); });
  if (field_ == "id") {
    const auto ids = simulation.view("position").ids;
    return py::array_t<std::int64_t>(static_cast<py::ssize_t>(ids.size()), ids.data(), owner);
  }
  const FieldView view = simulation.view(field_);
  if (component_ >= view.components.size()) {
    throw Error(fmt::format("field '{}' has no such component in {}D; it has {}.", field_,
                            simulation.scene().dimension, view.components.size()));
  }
  const auto values = view.components[component_];
  return py::array_t<double>(static_cast<py::ssize_t>(values.size()), values.data(), owner);
}

py::array Slots::pin() {
  if (!valid()) {
    throw Error(fmt::format(
        "this view of '{}' is over: the simulation has been stepped or changed since, and the "
        "particles may lie in another order. Try to take a new view, or field(), which copies.",
        field_));
  }
  py::array found = array();
  found.attr("setflags")(py::arg("write") = false);
  session_->pin();
  return found;
}

}  // namespace scarp::python
