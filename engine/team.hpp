// SPDX-License-Identifier: BSD-3-Clause
/// How many threads a run has, and how many of them pay at the moment.
#pragma once

#include <string>
#include <vector>

namespace scarp {

/// What is wrong with this many threads and what to try; empty if nothing is.
std::string complaint_about_threads(int wanted);

/// What to say if OMP_NUM_THREADS asks for more than is used; empty if it does not.
std::string note_on_offered_threads();

/// What OpenMP would take (OMP_NUM_THREADS, else every core), but no more than `usable_cores()`.
int default_threads();

/// Tells how many threads the next step takes, from what steps have taken before. Threads meet
/// some twenty times a step: where another program holds one of their cores all of them wait for
/// the one that has lost it, and a step on several threads can take many times as long as on one.
/// In small scenes meeting takes longer than what it saves. So now and then half as many, one
/// or twice as many are tried, and kept if steps take less time. Results do not depend on it.
class Team {
 public:
  Team() : Team(1, true) {}
  /// `fixed`: always `most`.
  Team(int most, bool fixed);

  int most() const { return levels_.front(); }
  int threads() const { return levels_[level_]; }  ///< of the next step
  /// What a step took [s]; one that built neighbour lists is compared with its like only.
  void took(double seconds, bool rebuilt);

 private:
  void decide(double mean);
  std::size_t next_to_try(double mean);

  std::vector<int> levels_;              ///< most, half of it, ..., 1
  std::vector<double> means_;            ///< of a step when last looked at [s]; 0: not yet
  std::size_t level_ = 0, settled_ = 0;  ///< in use; to go back to after a try
  int turn_ = 2;                         ///< of what is tried next
  bool rebuilt_ = false;
  int steps_ = 0;         ///< in the present look
  double seconds_ = 0.0;  ///< ... and what they took
  double clock_ = 0.0, next_try_ = 0.0, pause_;
};

}  // namespace scarp
