// SPDX-License-Identifier: BSD-3-Clause
/// The factor of safety of a scene: one settled state, its strength cut by different factors.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/fos/cut.hpp"
#include "engine/fos/cut_states.hpp"
#include "engine/fos/limit_search.hpp"
#include "engine/simulation.hpp"

namespace scarp {

/// What a caller may set; what is empty is chosen from the scene.
struct CriterionOptions {
  std::optional<double>
      height{};                  ///< of the slope [m]; empty: from the lowest to the highest ground
  std::optional<double> ramp{};  ///< time that a cut by 1.5 takes [s]; 0: at once; empty: 1.4 free
                                 ///< falls
  std::optional<double> window{};  ///< [s]; empty: five free falls over the height
  std::string probe{};             ///< whose displacement is judged; empty: the scene's first probe
  /// False: a trial that stands runs to the end of the window, as it does where a soil softens.
  bool early_stop = true;
};

/// When a slope counts as failed: until `window` after the reduction the displacement exceeds
/// `elastic` + `limit`.
struct Criterion {
  double height = 0.0;   ///< of the slope [m]
  double limit = 0.0;    ///< 1 % of the height [m]
  double ramp = 0.0;     ///< time that a cut by 1.5 takes, others in proportion [s]
  double window = 0.0;   ///< after the cut [s]
  double span = 0.0;     ///< over which a rate is measured [s]
  double elastic = 0.0;  ///< displacement with nothing reduced [m]
  std::string probe{};   ///< its name; empty: the largest displacement of the soil
  bool early_stop = true;
};

/// Height, window and probe for a scene. Errors: SceneError that says what to change.
Criterion choose_criterion(const Scene& scene, const CriterionOptions& options);

/// Checks that a scene is one settled state and one stage to cut the strength in. Errors:
/// SceneError that says what to change.
void check_reducible(const Scene& scene);

enum class TrialEnd { limit_crossed, came_to_rest, window_over };

/// What one factor did to the slope.
struct Trial {
  double reduction = 1.0;
  bool fails = false;
  TrialEnd end = TrialEnd::window_over;
  double displacement = 0.0;  ///< largest within the run, since the settled state [m]
  double speed = 0.0;         ///< of the same point at the end of the run [m/s]
  double time = 0.0;          ///< since the settled state [s]
  std::uint64_t steps = 0;    ///< of this trial alone; it may begin where others have cut already
  double wall_s = 0.0;
};

/// Called after each step; false asks to stop.
using Proceed = std::function<bool(const Simulation&)>;

/// Runs a scene through all its stages but the last. False: it was asked to stop. Errors: those of
/// `Simulation::step()`.
bool settle(Simulation& simulation, const Proceed& proceed);

/// A trial that is yet to run, with its own copy of the state that it goes on from.
struct BegunTrial {
  StageStrength end;
  double reduction = 1.0;
  CutState from;
};

/// A trial that has run, and states on its way that others may begin from.
struct TrialResponse {
  Trial trial;
  std::vector<CutState> levels;
};

/// A settled state and the criterion that its reductions are judged by.
class StrengthReduction {
 public:
  /// `settled`: after `settle`.
  StrengthReduction(Simulation settled, const Criterion& criterion);

  /// The response with the strength it settled with. Unless even this fails, what moves then is no
  /// failure and counts as the elastic response from here on. Empty: asked to stop. Errors:
  /// SimulationInstability.
  std::optional<Trial> measure_elastic(const Proceed& proceed);
  const std::optional<Trial>& elastic() const { return elastic_; }

  /// Takes the elastic response that was measured before.
  void take_elastic(const Trial& trial);

  /// The response to one factor. It depends on the factor alone, although it is computed from
  /// where others have cut the strength so far already. A slope that fails on the way there is
  /// the trial of the factor that the cut had come to. Empty: asked to stop. Errors:
  /// SimulationInstability.
  std::optional<Trial> respond(double reduction, const Proceed& proceed);

  /// The three parts of `respond`, for trials side by side: `run` may go on in another thread while
  /// this one does anything else with this object but `measure_elastic` and `take_elastic`.
  /// `options`: threads of the trial, and whether it is to stop.
  BegunTrial begin(double reduction, const RunOptions& options) const;
  std::optional<TrialResponse> run(BegunTrial begun, const Proceed& proceed) const;
  Trial take(TrialResponse response);
  /// Whether `respond` knows the answer: it is the elastic response.
  bool is_elastic(double reduction) const;

  /// A copy of the settled state with the strength cut by `reduction`, then held for `duration`
  /// [s].
  Simulation reduced(double reduction, double duration) const;

  /// The same, before the last step of its cut. Empty: asked to stop.
  std::optional<Simulation> before_last_cut(double reduction, double duration,
                                            const Proceed& proceed);

  /// From the settled state to the moment from which the strength is held [s].
  double cut_time(double reduction) const;
  double level_time() const;  ///< of one level of a cut [s]

  /// Displacement of the judged point since the settled state [m].
  double displacement(const Simulation& simulation) const;
  /// The largest of all soil [m].
  double largest_displacement(const Simulation& simulation, std::size_t* where = nullptr) const;

  const Simulation& settled() const { return settled_; }
  const Criterion& criterion() const { return criterion_; }

 private:
  StageStrength strength_before() const;
  StageStrength strength_after(double reduction) const;
  double reduction_reached(const Stage& stage, double wanted) const;
  std::vector<Stage> stages_to(const StageStrength& end, double duration) const;
  CutState begin(const std::vector<Stage>& stages, const RunOptions& options) const;
  BegunTrial begin(const StageStrength& end, double reduction, const RunOptions& options) const;
  std::vector<StageStrength> way_to(const Simulation& now) const;
  double speed(const Simulation& simulation) const;

  Simulation settled_;
  Criterion criterion_;
  std::vector<double> position_;  ///< of the settled state
  std::optional<Trial> elastic_;
  CutStates levels_;
};

/// The settled state's own factor, if one holds for all materials.
std::optional<double> settled_reduction(const Scene& scene);

/// A slope that stands, and the strength it took.
struct StandingSlope {
  StrengthReduction slope;
  double strengthening = 1.0;  ///< of every stage before the last, over what the scene gives it
  double settle_time = 0.0;    ///< simulated in the last attempt [s]
};

/// Where an attempt to settle a slope was left.
struct SettleStart {
  double strengthening = 1.0;
  std::optional<Snapshot> state;  ///< of that attempt; empty: its start
  std::optional<Trial> elastic;   ///< known once it had settled
};

/// Settles a scene and measures its elastic response. Where the slope gives way with the strength
/// of its settling stages (it fails then, or has moved while it settled by more than the
/// criterion's limit beyond the settlement gamma H^2/(2 M) of the soil's height, in a scene whose
/// walls stay), it is settled
/// again from the start with twice the strength: `told` hears the next strengthening before. At 16
/// times it is taken as it is. Empty: `proceed` asked to stop. Errors: SimulationInstability;
/// CheckpointError if the state to begin with cannot be used.
std::optional<StandingSlope> settle_standing(const Scene& scene, const RunOptions& options,
                                             const Criterion& criterion, const Proceed& proceed,
                                             const std::function<void(double)>& told = {},
                                             const SettleStart& start = {});

/// All trials of a search and what came out.
struct FactorOfSafety {
  Trial elastic;
  std::vector<Trial> trials;  ///< in the order of the search
  Bracket bracket;
};

/// The elastic response, unless it has been measured, then the search. `done` is called after each
/// trial; `proceed` may be empty. The search goes on from trials of the same slope and criterion
/// that are `known`, in the order in which they were found. Errors: those of `measure_elastic` and
/// `respond`; SceneError if the slope fails with the strength it settled with.
FactorOfSafety find_factor(
    StrengthReduction& slope, const SearchOptions& search, const Proceed& proceed,
    const std::function<void(const FactorOfSafety&, const Trial&)>& done = {},
    const std::vector<Trial>& known = {});

}  // namespace scarp
