// SPDX-License-Identifier: BSD-3-Clause
/// Starts a beam and follows its first mode.
#include "validation/cases/beam/swing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "engine/errors.hpp"
#include "engine/output/text_file.hpp"
#include "engine/scene/smoothing_choice.hpp"

namespace scarp::validation {
namespace {

/// The mode as a field of velocity or displacement, -y psi and W, at the places of a start.
class ModeField {
 public:
  ModeField(const Simulation& start, const BendingMode& mode) {
    const std::vector<double> position = start.field("position");
    for (std::size_t k = 0; k < position.size(); k += 3) {
      const double x = position[k], y = position[k + 1];
      field_.insert(field_.end(), {-y * mode.rotation(x), mode.deflection(x), 0.0});
    }
    for (const double value : field_) square_ += value * value;
  }
  std::vector<double> times(double factor) const {
    std::vector<double> product = field_;
    for (double& value : product) value *= factor;
    return product;
  }
  /// Of the mode in another field, by least squares.
  double amount_in(const std::vector<double>& other) const {
    double sum = 0.0;
    for (std::size_t k = 0; k < field_.size(); ++k) sum += field_[k] * other[k];
    return sum / square_;
  }

 private:
  std::vector<double> field_;
  double square_ = 0.0;
};

/// Half the way from the lowest to the highest value.
struct HalfWay {
  double lowest = 0.0, highest = 0.0;
  void note(double value) {
    lowest = std::fmin(lowest, value);
    highest = std::fmax(highest, value);
  }
  double value() const { return 0.5 * (highest - lowest); }
};

/// When a quantity passes zero, by linear interpolation between samples.
class Crossings {
 public:
  void note(double time, double value) {
    if (value * value_ < 0.0) {
      last_ = time_ + (time - time_) * value_ / (value_ - value);
      if (count_++ == 0) first_ = last_;
    }
    time_ = time;
    value_ = value;
  }
  /// Crossings are half a period apart. NaN before the second.
  double period() const {
    return count_ < 2 ? std::nan("") : 2.0 * (last_ - first_) / (count_ - 1);
  }

 private:
  double time_ = 0.0, value_ = 0.0, first_ = 0.0, last_ = 0.0;
  int count_ = 0;
};

}  // namespace

double viscous_share(const Scene& scene, const BendingMode& mode, double radians) {
  const Material& soil = scene.materials.front();
  const double poisson = soil.model.parameter("poisson_ratio"), plane = poisson / (1.0 - poisson);
  const double mean = (3.0 - 2.0 * plane + 3.0 * plane * plane) / 8.0;
  const double h = smoothing_length_of(scene);
  const double rate = 0.5 * soil.density * scene.numerics.viscosity_alpha * h * soil.sound_speed() *
                      mean * mode.frequency() / Beam(scene).modulus;
  return -std::expm1(-rate * radians);
}

Swing swing(CaseRun& run, const std::string& name, Scene scene, const Start& start,
            std::optional<Simulation>& last) {
  const BendingMode mode(Beam(scene), start.support);
  const double period = 2.0 * std::numbers::pi / mode.frequency();
  scene.stages.front().duration = start.periods * period;
  for (Body& body : scene.bodies) body.velocity_field.clear();
  last.emplace(scene, run.options().run);
  const ModeField field(*last, mode);
  last->set_field("velocity", field.times(start.deflection * mode.frequency()));
  const double kinetic = last->energy().kinetic;
  const auto energy_of = [&](const Simulation& now) {
    const EnergyBalance energy = now.energy();
    return (energy.kinetic + energy.elastic) / kinetic;
  };

  std::string file = name;
  std::erase(file, ',');
  std::replace(file.begin(), file.end(), ' ', '_');
  CsvFile table(run.folder() / fmt::format("deflection_{}.csv", file),
                {"time [periods]", "deflection [-]", "closed_form [-]", "energy [-]"});
  Swing swing;
  Crossings crossings;
  HalfWay first, latest;
  double next = 0.0;
  // 200 samples a period: peaks are missed by 1e-4 of their height at most.
  const auto sample = [&](const Simulation& now) {
    const double time = now.last_step().time;
    if (time < next) return;
    next += period / 200.0;
    crossings.note(time, field.amount_in(now.field("velocity")));
    const double deflection = field.amount_in(now.field("displacement")) / start.deflection;
    if (time <= 1.3 * period) first.note(deflection);
    if (time >= (start.periods - 1.3) * period) latest.note(deflection);
    const double energy = energy_of(now);
    swing.most_energy = std::fmax(swing.most_energy, energy);
    table << time / period << deflection << std::sin(mode.frequency() * time) << energy;
    table.end_row();
  };
  try {
    run.run_stage(name, *last, nullptr, sample);
  } catch (const SimulationInstability&) {
    swing.whole = false;
  }
  swing.periods = last->last_step().time / period;
  swing.frequency = period / crossings.period();
  swing.amplitude = first.value();
  swing.last_amplitude = latest.value();
  swing.energy = energy_of(*last);
  const EnergyBalance energy = last->energy();
  swing.viscous = energy.viscous / kinetic;
  swing.artificial_stress = energy.artificial_stress / kinetic;
  swing.gradient_residue = energy.gradient_residue / kinetic;
  return swing;
}

}  // namespace scarp::validation
