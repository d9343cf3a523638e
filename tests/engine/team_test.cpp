// SPDX-License-Identifier: BSD-3-Clause
/// How many threads a run takes: bounds, and what steps tell it, on machines made of formulas.
#include "engine/team.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>

#include "engine/errors.hpp"
#include "engine/machine.hpp"
#include "tests/support/small_scenes.hpp"

namespace scarp {
namespace {

/// Time of a step [s] on so many threads.
using Machine = std::function<double(int threads, int step)>;

/// A step of `work` seconds, of which a twentieth cannot be shared, and meetings.
double quiet(double work, int threads) {
  return threads == 1 ? work : work * (0.05 + 0.95 / threads) + 20 * 5e-6;
}

/// Time of all steps, and of it the share taken with `threads`.
struct Course {
  double seconds = 0.0;
  int last_threads = 0;
};

Course drive(Team& team, int steps, const Machine& machine) {
  Course course;
  for (int step = 0; step < steps; ++step) {
    const double took = machine(team.threads(), step);
    course.seconds += took;
    course.last_threads = team.threads();
    const bool rebuilt = step % 20 == 19;
    team.took(rebuilt ? 2.0 * took : took, rebuilt);
  }
  return course;
}

TEST(TeamTest, LosesNothingWorthNamingOnAQuietMachine) {
  for (const double work : {1e-3, 2e-2, 0.3}) {
    Team team(2, false);
    const int steps = static_cast<int>(60.0 / work);
    const Course course =
        drive(team, steps, [work](int threads, int) { return quiet(work, threads); });
    EXPECT_EQ(course.last_threads, 2) << work;
    // Tries of one thread take 1 in 50 at most, for about twice as long: 2 %.
    EXPECT_LT(course.seconds, 1.02 * steps * quiet(work, 2)) << work;
  }
}

TEST(TeamTest, TakesOneThreadWhereMeetingCostsMoreThanItSaves) {
  Team team(8, false);
  constexpr double work = 5e-5;
  const Course course = drive(team, 100000, [](int threads, int) { return quiet(work, threads); });
  EXPECT_EQ(course.last_threads, 1);
  EXPECT_LT(course.seconds, 1.1 * 100000 * work);
}

// One of two cores is held by another program: in each meeting of two threads one waits for the
// scheduler's turn of 3 ms. One thread has the other core to itself.
TEST(TeamTest, TakesOneThreadBesideABusyCoreAndBothWhenItIsFreeAgain) {
  constexpr double work = 1.4e-3;
  const Machine machine = [](int threads, int step) {
    const bool busy = step >= 20000 && step < 60000;
    if (threads == 1) return work;
    return busy ? 20 * 3e-3 : quiet(work, threads);
  };
  Team team(2, false);
  EXPECT_EQ(drive(team, 20000, machine).last_threads, 2);
  const auto later = [&](int from) {
    return [&machine, from](int threads, int step) { return machine(threads, from + step); };
  };
  const Course busy = drive(team, 40000, later(20000));
  EXPECT_EQ(busy.last_threads, 1);
  // A try that is broken off costs a few steps of 60 ms each 4 s: within a tenth.
  EXPECT_LT(busy.seconds, 1.1 * 40000 * work);
  // 4 s are some 3000 steps; then two threads are found to pay again.
  drive(team, 8000, later(60000));
  EXPECT_EQ(drive(team, 100, later(60000)).last_threads, 2);
}

TEST(TeamTest, FindsTheBestOfMany) {
  Team team(16, false);
  // Meeting costs more the more meet: 20 meetings of 30 us a thread.
  const Machine machine = [](int threads, int) {
    return 1e-2 * (0.05 + 0.95 / threads) + (threads > 1 ? 20 * 30e-6 * threads : 0.0);
  };
  double least = machine(1, 0);
  int best = 1;
  for (int threads = 2; threads <= 16; threads *= 2) {
    if (machine(threads, 0) >= least) continue;
    least = machine(threads, 0);
    best = threads;
  }
  ASSERT_EQ(best, 4);
  drive(team, 20000, machine);
  int in_best = 0;
  for (int look = 0; look < 100; ++look) in_best += drive(team, 10, machine).last_threads == best;
  EXPECT_GT(in_best, 90);
}

TEST(TeamTest, KeepsANumberThatWasAskedFor) {
  Team team(2, true);
  const Course course =
      drive(team, 1000, [](int threads, int) { return threads == 1 ? 1e-3 : 1.0; });
  EXPECT_EQ(course.last_threads, 2);
}

TEST(ThreadsOfARunTest, AreBoundedByTheCores) {
  const int cores = usable_cores();
  const auto start = [](std::optional<int> threads, bool oversubscribe) {
    return Simulation(test::elastic_column("modern", 1.0, 0.25), {threads, {}, oversubscribe});
  };
  EXPECT_EQ(start({}, false).threads(), default_threads());
  EXPECT_EQ(start(cores, false).threads(), cores);
  for (const int threads : {-1, 0, cores + 1, 1000, 100000, 2147483647}) {
    EXPECT_THROW(start(threads, false), SceneError) << threads;
    EXPECT_FALSE(complaint_about_threads(threads).empty());
  }
  EXPECT_EQ(start(3, true).threads(), 3);
  for (const int threads : {-1, 0, 100000})
    EXPECT_THROW(start(threads, true), SceneError) << threads;
}

}  // namespace
}  // namespace scarp
