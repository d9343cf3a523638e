// SPDX-License-Identifier: BSD-3-Clause
/// Measures of the slopes.

#include "validation/paper/slope_judgement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

namespace scarp::validation {
namespace {

constexpr const char* end_of_slide = "end of the slide [s]";

/// Each outcome once, however many readings share it, in the order of the runs.
std::vector<Outcome> runs_of(const std::vector<ReadingOutcomes>& readings) {
  std::vector<Outcome> runs;
  for (const ReadingOutcomes& reading : readings) {
    for (const auto& entry : reading.outcomes) {
      const Outcome& outcome = entry.second;
      const bool known = std::any_of(runs.begin(), runs.end(), [&](const Outcome& other) {
        return other.name == outcome.name;
      });
      if (!known) runs.push_back(outcome);
    }
  }
  return runs;
}

/// Value farthest from what it should be, and the run it is of.
struct Worst {
  double value = std::nan("");
  std::string of = "no run";
};

Worst farthest(const std::vector<Outcome>& runs, const std::string& value, double ideal) {
  Worst found;
  for (const Outcome& outcome : runs) {
    const double here = outcome.at(value);
    if (std::fabs(here - ideal) > std::fabs(found.value - ideal) ||
        (std::isnan(found.value) && !std::isnan(here))) {
      found = {here, outcome.name};
    }
  }
  return found;
}

void report(CaseRun& run, const Outcome& outcome, const std::string& value) {
  if (outcome.values.count(value) == 0) return;
  const std::size_t unit = value.rfind(" [");
  run.add(reported(fmt::format("{}: {}", outcome.name, value.substr(0, unit)), outcome.at(value),
                   value.substr(unit + 2, value.size() - unit - 3)));
}

}  // namespace

void judge_slopes(CaseRun& run, const std::vector<ReadingOutcomes>& readings) {
  const std::vector<Outcome> runs = runs_of(readings);
  const auto ended = std::count_if(runs.begin(), runs.end(), [](const Outcome& outcome) {
    return outcome.values.count(end_of_slide) != 0;
  });
  run.add(within("runs that settled and slid to their end over all runs",
                 static_cast<double>(ended) / static_cast<double>(runs.size()), "", 1.0, 1.0, 1.0,
                 "a run that blows up leaves none"));
  const Worst lost = farthest(runs, "mass inside over mass before [-]", 1.0);
  run.add(within("mass inside the walls over mass before, worst run", lost.value, "", 1.0, 1.0, 1.0,
                 "exact: particles keep their mass, none may leave; " + lost.of));
  const Worst speed = farthest(runs, "residual velocity, settled [m/s]", 0.0);
  run.add(within("residual velocity after settling, worst run", speed.value, "m/s", 0.0, 0.0, 1e-3,
                 "the scene's own rest velocity; " + speed.of));
  const Worst moving = farthest(runs, "fastest probe at the end [m/s]", 0.0);
  run.add(within("speed of the fastest probe at the end, worst run", moving.value, "m/s", 0.0, 0.0,
                 0.02, "the slide has ended: 2 % of the 1 m/s it had; " + moving.of));
  constexpr const char* sides = "slide volume, difference of the sides over both [-]";
  if (const Worst lopsided = farthest(runs, sides, 0.0); !std::isnan(lopsided.value)) {
    run.add(within("slide on the two sides of the diagonal, difference over both, worst run",
                   lopsided.value, "", 0.0, 0.0, 0.02, "mirror symmetry; 2 %; " + lopsided.of));
  }
  for (const Outcome& outcome : runs) {
    for (const char* value :
         {"crest: settlement [m]", "toe: advance [m]", "M1: settlement [m]", "M2: advance [m]",
          "P1: settlement [m]", "P2: advance [m]", "Q1: settlement [m]", "Q2: advance [m]",
          "slide volume [m3]", end_of_slide, "residual velocity [m/s]"}) {
      report(run, outcome, value);
    }
  }
}

}  // namespace scarp::validation
