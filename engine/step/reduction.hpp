// SPDX-License-Identifier: BSD-3-Clause
/// Where the parts of a soil come together.
#pragma once

#include <array>
#include <cstddef>
#include <exception>
#include <span>
#include <string_view>
#include <typeinfo>
#include <vector>

namespace scarp {

class DataSet;
class ParticleBuffers;
class Snapshot;
struct Scene;

/// A member of Simulation in which all parts of a soil take part, with its argument.
struct JointCall {
  enum class Member {
    make,  ///< the constructor
    step,
    set_step_factor,
    field,
    ids,
    snapshot,
    require_sound,
    energy,
    wall_reactions,
    probe,
    density_bound_count,
    face_hold_count
  };
  Member member = Member::step;
  double number = 0.0;                 ///< of set_step_factor, and the index of a probe
  std::string_view name{};             ///< of a field
  const Scene* scene = nullptr;        ///< of make
  const Snapshot* snapshot = nullptr;  ///< of make; null: from the start
};

/// Joins the minima, maxima and sums that a step takes over the whole soil (time step, rest, watch,
/// heights, energies, counts). Here: the particles of this process are all there are, every value
/// is the whole's already. An engine that holds the soil in several parts derives from it; each
/// member is then called by every part with as many values in the same order, and gives all of them
/// the same.
class Reduction {
 public:
  virtual ~Reduction() = default;
  virtual void maximum(std::span<double> /*values*/) {}
  virtual void minimum(std::span<double> /*values*/) {}
  virtual void sum(std::span<double> /*values*/) {}
  /// Appends the values of the other parts, as many as they have.
  virtual void gather(std::vector<double>& /*values*/) {}
  /// The same in the part that leads; the others may keep what they have.
  virtual void collect(std::vector<double>& /*values*/) {}
  /// Whether this part has what the whole has only once: what is collected, and counts.
  [[nodiscard]] virtual bool leads() const { return true; }

  /// Around the work of each member that all parts take part in: where one of them leads, it tells
  /// the others what to call. `end` throws what another part has thrown since all met last.
  virtual void begin(const JointCall& /*call*/) {}
  virtual void end() {}

  /// Each part has made all soil, and leaves its own. Until then, since `begin` of `make`, values
  /// are the whole's already.
  virtual void divide(ParticleBuffers& /*soil*/) {}
  /// Neighbour lists are about to be built: soil goes to the part into which it has come, with all
  /// its fields of lifetime `state`, and `ghosts` become the soil of other parts near this one's.
  virtual void deal(ParticleBuffers& /*soil*/, ParticleBuffers& /*ghosts*/) {}
  /// Gives the ghosts the present values of these fields. Slots of the soil may be in another order
  /// than after `deal` only where it was put so before the first `refresh`.
  virtual void refresh(const ParticleBuffers& /*soil*/, ParticleBuffers& /*ghosts*/,
                       const DataSet& /*fields*/) {}

  /// Called by a part that leaves its set-up, a step, or another member that reduces, by an
  /// exception: it takes no part in the reductions that follow. From then on each member must throw
  /// in every part, also where it waits already, else the others wait for ever. What it throws
  /// leaves their steps. To go on, make the parts anew from snapshots, with another reduction.
  virtual void abort() noexcept {}

  double maximum_of(double value) {
    maximum({&value, 1});
    return value;
  }
  double minimum_of(double value) {
    minimum({&value, 1});
    return value;
  }
  double sum_of(double value) {
    sum({&value, 1});
    return value;
  }
  template <std::size_t N>
  void sum_each(double* const (&places)[N]) {
    std::array<double, N> values;
    for (std::size_t k = 0; k < N; ++k) values[k] = *places[k];
    sum(values);
    for (std::size_t k = 0; k < N; ++k) *places[k] = values[k];
  }
  void sum_each(std::vector<std::array<double, 3>>& vectors) {
    std::vector<double> values;
    for (const auto& vector : vectors) values.insert(values.end(), vector.begin(), vector.end());
    sum(values);
    for (std::size_t k = 0; k < values.size(); ++k) vectors[k / 3][k % 3] = values[k];
  }
};

/// While it lives, all parts are in the same member of Simulation; what throws there is for
/// `or_abort`.
class InCall {
 public:
  InCall(Reduction& reduction, const JointCall& call) : reduction_(reduction) {
    reduction_.begin(call);
  }
  InCall(const InCall&) = delete;
  InCall& operator=(const InCall&) = delete;
  ~InCall() noexcept(false) {  // not while something else is thrown
    if (std::uncaught_exceptions() == unwinding_) reduction_.end();
  }

 private:
  Reduction& reduction_;
  int unwinding_ = std::uncaught_exceptions();
};

/// Whether no program divides the soil: all of it is here.
inline bool is_alone(const Reduction& reduction) { return typeid(reduction) == typeid(Reduction); }

/// What throws in one part of a soil does not leave the others waiting for it.
template <class Call>
decltype(auto) or_abort(Reduction* reduction, const Call& call) {
  try {
    return call();
  } catch (...) {
    if (reduction != nullptr) reduction->abort();
    throw;
  }
}

}  // namespace scarp
