// SPDX-License-Identifier: BSD-3-Clause
/// Settles a slope, with more strength where its own does not hold it.

#include <algorithm>
#include <limits>

#include "engine/fos/displacement.hpp"
#include "engine/fos/strength_reduction.hpp"
#include "engine/particles/soil_above.hpp"

namespace scarp {
namespace {

/// Strengthening beyond which a slope is given up.
constexpr double most_strengthening = 16.0;

/// A slope that has moved this many times its limit is not waited for.
constexpr double given_up = 3.0;

/// Gathering all displacements is not free.
constexpr std::uint64_t look_steps = 50;

/// How far the judged point has moved while its slope settled.
class Yielding {
 public:
  Yielding(const Simulation& start, const Criterion& criterion)
      : probe_(criterion.probe), position_(start.field("position")) {
    const Scene& scene = start.scene();
    const Vec3 up = upward(scene), &g = scene.gravity;
    double low = std::numeric_limits<double>::infinity(), high = -low, softness = 0.0;
    for (std::size_t i = 0; i + 2 < position_.size(); i += 3) {
      const double height =
          up[0] * position_[i] + up[1] * position_[i + 1] + up[2] * position_[i + 2];
      low = std::min(low, height);
      high = std::max(high, height);
    }
    for (const Material& m : scene.materials) {
      softness = std::max(softness, m.density * size_of(g) / m.model.moduli().wave_modulus());
    }
    const bool still = std::all_of(scene.walls.begin(), scene.walls.end(), [](const Wall& wall) {
      return wall.velocity == Vec3{} && wall.removed_at.empty();
    });
    limit_ = still ? criterion.limit + 0.5 * softness * (high - low) * (high - low)
                   : std::numeric_limits<double>::infinity();
    if (!probe_.empty()) probe_start_ = start.probe(probe_).position;
  }
  /// What elastic settlement explains and the criterion allows beyond it [m]; infinite where walls
  /// move or go, which soil follows.
  double limit() const { return limit_; }
  double moved(const Simulation& now) const {
    if (!probe_.empty()) {
      const Vec3 at = now.probe(probe_).position;
      return size_of({at[0] - probe_start_[0], at[1] - probe_start_[1], at[2] - probe_start_[2]});
    }
    return farthest(position_, now);
  }

 private:
  std::string probe_;
  std::vector<double> position_;
  Vec3 probe_start_{};
  double limit_ = 0.0;
};

/// A scene whose stages before the last have so many times their strength.
Scene strengthened(Scene scene, double strengthening) {
  for (std::size_t s = 0; s + 1 < scene.stages.size(); ++s) {
    scene.stages[s].strength_reduction /= strengthening;
    for (auto& [material, factor] : scene.stages[s].material_strength_reduction)
      factor /= strengthening;
  }
  return scene;
}

}  // namespace

std::optional<StandingSlope> settle_standing(const Scene& scene, const RunOptions& options,
                                             const Criterion& criterion, const Proceed& proceed,
                                             const std::function<void(double)>& told,
                                             const SettleStart& start) {
  for (double strengthening = start.strengthening;; strengthening *= 2.0) {
    const bool first = strengthening == start.strengthening;
    const bool last = strengthening >= most_strengthening;
    Simulation simulation(strengthened(scene, strengthening), options);
    const Yielding yielding(simulation, criterion);
    if (first && start.state) simulation = Simulation(simulation.scene(), *start.state, options);
    bool stopped = false, gave_way = false;
    const bool settled = settle(simulation, [&](const Simulation& now) {
      stopped = proceed && !proceed(now);
      const bool looks = now.last_step().step % look_steps == 0;
      gave_way = gave_way || (!last && looks && yielding.moved(now) > given_up * yielding.limit());
      return !stopped && !gave_way;
    });
    if (stopped) return {};
    if (settled && (last || yielding.moved(simulation) <= yielding.limit())) {
      const double time = simulation.last_step().time;
      StrengthReduction slope(std::move(simulation), criterion);
      if (first && start.elastic) slope.take_elastic(*start.elastic);
      const std::optional<Trial> elastic =
          slope.elastic() ? slope.elastic() : slope.measure_elastic(proceed);
      if (!elastic) return {};
      if (last || !elastic->fails) return StandingSlope{std::move(slope), strengthening, time};
    }
    if (told) told(2.0 * strengthening);
  }
}

}  // namespace scarp
