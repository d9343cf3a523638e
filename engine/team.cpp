// SPDX-License-Identifier: BSD-3-Clause
/// Bounds on threads, and when more or fewer are tried.
#include "engine/team.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/machine.hpp"
#include "engine/parallel.hpp"

namespace scarp {
namespace {

// A look at how long steps take covers several turns of the scheduler (some 3 ms each).
constexpr int least_steps = 3;
constexpr double least_seconds = 0.02;
// A try may be 2 times as slow as what it is compared with: at most 2 % of the time, less later.
constexpr double tries_apart = 50.0;
constexpr double shortest_pause = 0.5, longest_pause = 4.0;  // [s]
// A try is broken off when it has taken this many times what its steps should.
constexpr double hopeless = 2.0;
// What is about as fast is not changed for.
constexpr double margin = 0.97;

}  // namespace

std::string complaint_about_threads(int wanted) {
  const int cores = usable_cores();
  if (wanted >= 1 && wanted <= cores) return {};
  if (wanted < 1)
    return fmt::format(
        "{} threads: there cannot be fewer than 1. Try 1, or leave it out for as many as make the "
        "run "
        "faster.",
        wanted);
  return fmt::format(
      "{} threads are more than the {} {} this process may use (affinity and control group "
      "counted), and would wait for each other. Try {} or fewer, or leave it out for as many as "
      "make it "
      "faster; results do not depend on it.",
      wanted, cores, cores == 1 ? "core" : "cores", cores);
}

std::string note_on_offered_threads() {
  if (offered_threads() <= default_threads()) return {};
  return fmt::format(
      "OMP_NUM_THREADS asks for {} threads, but this process may use {} {} (affinity and control "
      "group counted): so many threads are used",
      offered_threads(), usable_cores(), usable_cores() == 1 ? "core" : "cores");
}

int default_threads() { return std::min(offered_threads(), usable_cores()); }

Team::Team(int most, bool fixed) : pause_(shortest_pause) {
  levels_.push_back(most);
  while (!fixed && levels_.back() > 1) levels_.push_back(levels_.back() / 2);
  means_.assign(levels_.size(), 0.0);
}

void Team::took(double seconds, bool rebuilt) {
  clock_ += seconds;
  const bool alike = rebuilt == rebuilt_;
  rebuilt_ = rebuilt;
  if (levels_.size() == 1 || !alike) return;
  ++steps_;
  seconds_ += seconds;
  const bool tries = level_ != settled_;
  const bool lost = tries && seconds_ > hopeless * steps_ * means_[settled_] + least_seconds;
  if (!lost && (steps_ < least_steps || seconds_ < least_seconds)) return;
  decide(seconds_ / steps_);
  steps_ = 0;
  seconds_ = 0.0;
}

void Team::decide(double mean) {
  means_[level_] = mean;
  if (level_ == settled_) {
    level_ = next_to_try(mean);
    return;
  }
  const bool better = mean < margin * means_[settled_];
  pause_ = better ? shortest_pause : std::min(2.0 * pause_, longest_pause);
  next_try_ = clock_ + std::max(pause_, tries_apart * seconds_);
  if (better) settled_ = level_;
  level_ = settled_;
}

/// What was faster when last tried, or what has never been tried; else, when its time has come,
/// half as many, one, or twice as many in turn; else what is in use.
std::size_t Team::next_to_try(double mean) {
  std::size_t best = settled_;
  for (std::size_t k = 0; k < levels_.size(); ++k) {
    if (means_[k] > 0.0 && means_[k] < margin * std::min(mean, means_[best])) best = k;
  }
  if (best != settled_) return best;
  for (const std::size_t unknown : {std::min(settled_ + 1, levels_.size() - 1), levels_.size() - 1})
    if (means_[unknown] == 0.0) return unknown;
  if (clock_ < next_try_) return settled_;
  for (;;) {
    turn_ = (turn_ + 1) % 3;
    const std::size_t wanted = turn_ == 0     ? settled_ + 1
                               : turn_ == 1   ? levels_.size() - 1
                               : settled_ > 0 ? settled_ - 1
                                              : settled_;
    if (wanted < levels_.size() && wanted != settled_) return wanted;
  }
}

}  // namespace scarp
