// SPDX-License-Identifier: GPL-2.0-only
/// One process's part of the soil.
#include "engine/distributed/soil_parts.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <new>

#include <fmt/format.h>

#include "engine/checkpoint/scene_text.hpp"
#include "engine/distributed/failure.hpp"
#include "engine/errors.hpp"
#include "engine/neighbours/neighbours.hpp"
#include "engine/scene/scene.hpp"

namespace scarp::distributed {
namespace {

/// Adds the wall time of its life.
class Stopwatch {
 public:
  explicit Stopwatch(double& sum) : sum_(sum) {}
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;
  ~Stopwatch() { sum_ += std::chrono::duration<double>(Clock::now() - began_).count(); }

 private:
  using Clock = std::chrono::steady_clock;
  double& sum_;
  Clock::time_point began_ = Clock::now();
};

/// Soil beyond this is on its way to nowhere; LAMMPS would end the process over a box of any size
/// in which nothing can be told apart.
constexpr double farthest = 1e7;

/// The first particle that no box can hold.
void require_places(const ParticleBuffers& soil) {
  for (const ParticleGroup& group : soil.groups()) {
    for (std::int64_t k = group.first; k < group.end(); ++k) {
      Instability found;
      double worst = 0.0;
      for (int a = 0; a < soil.dimension(); ++a) {
        const double x = soil.component(Field::position, a)[k];
        found.position[static_cast<std::size_t>(a)] = x;
        if (!(std::abs(x) <= farthest)) worst = x;
      }
      if (worst == 0.0) continue;
      found.particle = soil.ids()[static_cast<std::size_t>(k)];
      found.field = std::string("position");
      found.unit = std::string("m");
      found.value = worst;
      found.limit = farthest;
      found.cause = "a grain thrown out of every box that processes could share";
      found.advice = "half the cfl first, as `retry` under [run] does by itself";
      throw SimulationInstability(found);
    }
  }
}

void require_enough(const ParticleBuffers& all, int processes) {
  if (all.count() < processes) {
    throw Error(fmt::format(
        "scarp-lammps: {} processes for {} particles. Try at most as many processes as particles; "
        "below some thousand particles each they only wait for each other.",
        processes, all.count()));
  }
  const std::int64_t last = *std::max_element(all.ids().begin(), all.ids().end());
  if (last <= most_particles) return;
  throw Error(fmt::format(
      "scarp-lammps: particle {} has an id above {}, up to which this LAMMPS (SMALLBIG) tells "
      "particles apart. Try fewer particles.",
      last, most_particles));
}

}  // namespace

SoilParts::SoilParts(Processes& processes, bool rebalance, int threads)
    : processes_(processes), rebalance_(rebalance), threads_(threads) {}

void SoilParts::throw_failure_of_another() {
  in_call_ = false;
  for (int from = 0; from < processes_.count(); ++from) {
    Message message = processes_.broadcast({}, from);
    if (!message.bytes().empty()) throw_failure(std::move(message));
  }
  throw Error("scarp-lammps: another process has stopped");
}

void SoilParts::join(Processes::Join how, std::span<double> values) {
  if (!divided_ || processes_.count() == 1) return;
  const Stopwatch stopwatch(waits_.joins);
  if (processes_.join(how, values)) throw_failure_of_another();
}

void SoilParts::gather(std::vector<double>& values) {
  if (!divided_) return;
  meet();
  processes_.gather(values, true);
}

void SoilParts::collect(std::vector<double>& values) {
  if (!divided_) return;
  meet();
  processes_.gather(values, false);
}

/// All leave the call. Without memory nobody can tell how far this process has come, and the others
/// may be in the midst of an exchange: that ends them all.
void SoilParts::abort() noexcept {
  if (!in_call_ || processes_.count() == 1) return;
  in_call_ = false;
  const std::exception_ptr thrown = std::current_exception();
  if (!thrown) processes_.end_all(1);
  try {
    std::rethrow_exception(thrown);
  } catch (const std::bad_alloc&) {
    std::fputs("scarp-lammps: not enough memory.\n", stderr);
    processes_.end_all(1);
  } catch (...) {
  }
  try {
    processes_.join(Processes::Join::nothing, {}, true);
    const Message own = failure_message(thrown);
    for (int from = 0; from < processes_.count(); ++from) {
      // Those that have not failed are gone with the first failure that they hear.
      if (!processes_.broadcast(own, from).bytes().empty()) break;
    }
  } catch (...) {
    processes_.end_all(1);
  }
}

void SoilParts::begin(const JointCall& call) {
  if (call.scene != nullptr && processes_.count() > 1 && soil_may_sleep(*call.scene)) {
    throw SceneError(
        fmt::format("not offered by scarp-lammps: soil asleep (sleep = {:g} under [numerics]). Try "
                    "0, or scarp.",
                    call.scene->numerics.sleep));
  }
  if (call.member == JointCall::Member::make) divided_ = false;
  if (call.scene != nullptr) halo_ = halo_of(*call.scene);
  if (leads() && processes_.count() > 1 && !in_call_) {
    Message order;
    order.put(Order::Kind::call);
    order.put(call.member);
    order.put(call.number);
    order.put(call.name);
    std::string scene;
    if (call.scene != nullptr) scene = scene_text(*call.scene);
    order.put(std::string_view(scene));
    order.put(static_cast<int>(call.snapshot != nullptr));
    if (call.snapshot != nullptr) put_snapshot(order, *call.snapshot);
    processes_.broadcast(order);
  }
  in_call_ = true;
}

void SoilParts::end() {
  meet();
  in_call_ = false;
}

Order SoilParts::next_order() {
  Message message = processes_.broadcast({});
  Order order;
  order.kind = message.take<Order::Kind>();
  if (order.kind == Order::Kind::finish) {
    order.exit_code = message.take<int>();
    add_up_traffic();
    return order;
  }
  order.call.member = message.take<JointCall::Member>();
  order.call.number = message.take<double>();
  order.name = message.take_text();
  order.scene = message.take_text();
  if (message.take<int>() != 0) order.snapshot = take_snapshot_from(message);
  return order;
}

void SoilParts::finish(int exit_code) {
  if (processes_.count() == 1) return;
  Message order;
  order.put(Order::Kind::finish);
  order.put(exit_code);
  processes_.broadcast(order);
  add_up_traffic();
}

void SoilParts::add_up_traffic() {
  std::int64_t* const counts[] = {&traffic_.deals, &traffic_.moved, &traffic_.refreshes,
                                  &traffic_.messages, &traffic_.values};
  for (std::int64_t* count : counts) {
    auto sum = static_cast<double>(*count);
    processes_.join(Processes::Join::sum, {&sum, 1});
    *count = static_cast<std::int64_t>(sum);
  }
}

void SoilParts::divide(ParticleBuffers& soil) {
  divided_ = true;
  if (processes_.count() == 1) return;
  const Stopwatch stopwatch(waits_.deals);
  require_enough(soil, processes_.count());
  require_places(soil);
  meet();
  traffic_before_ = traffic_;
  decomposition_ =
      std::make_unique<Decomposition>(processes_.communicator(), soil, halo_, rebalance_, threads_);
  decomposition_->divide(soil);
}

void SoilParts::deal(ParticleBuffers& soil, ParticleBuffers& ghosts) {
  if (processes_.count() == 1) return;
  const Stopwatch stopwatch(waits_.deals);
  require_places(soil);
  meet();
  decomposition_->deal(soil, ghosts);
  take_balance(static_cast<double>(soil.count()), static_cast<double>(ghosts.count()));
}

void SoilParts::take_balance(double own, double ghosts) {
  double most = own, all = own;
  maximum({&most, 1});
  sum_each({&all, &ghosts});
  balance_.last = most * processes_.count() / all;
  if (deals_ == 0.0) balance_.first = balance_.last;
  balance_.most = std::max(balance_.most, balance_.last);
  ghosts_ += ghosts / all;
  balance_.ghosts = ghosts_ / ++deals_;
}

void SoilParts::refresh(const ParticleBuffers& soil, ParticleBuffers& ghosts,
                        const DataSet& fields) {
  if (processes_.count() == 1) return;
  const Stopwatch stopwatch(waits_.refreshes);
  decomposition_->refresh(soil, ghosts, fields);
  const Traffic& more = decomposition_->traffic();
  traffic_ = {traffic_before_.deals + more.deals, traffic_before_.moved + more.moved,
              traffic_before_.refreshes + more.refreshes, traffic_before_.messages + more.messages,
              traffic_before_.values + more.values};
}

}  // namespace scarp::distributed
