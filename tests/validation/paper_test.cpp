// SPDX-License-Identifier: BSD-3-Clause
/// Shapes, verdicts and interrupted runs of the paper's 3D cases.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "engine/cli/interrupt.hpp"
#include "engine/errors.hpp"
#include "engine/run/checkpoint_writer.hpp"
#include "validation/paper/claims.hpp"
#include "validation/paper/nearly_at_rest.hpp"
#include "validation/paper/plane_zone.hpp"
#include "validation/paper/slopes.hpp"
#include "validation/paper/study_run.hpp"

namespace scarp::validation {
namespace {

TEST(PlaneZoneTest, HullTellsATriangleFromARectangle) {
  PlaneZone triangle, rectangle, arc;
  for (int i = 0; i <= 20; ++i) {
    for (int j = 0; j <= 20; ++j) {
      rectangle.add({0.1 * i, 0.2 * j}, 0.02);
      if (j <= i) triangle.add({0.1 * i, 0.2 * j}, 0.02);
    }
  }
  for (double s = -1.0; s < 1.0001; s += 0.01) arc.add({s, s * s}, 0.01);
  EXPECT_NEAR(triangle.hull_share(), 0.5, 1e-12);
  EXPECT_NEAR(rectangle.hull_share(), 1.0, 1e-12);
  EXPECT_NEAR(arc.hull_share(), 2.0 / 3.0, 1e-4);  // inscribed polygon: h^2/6 of each chord
  EXPECT_NEAR(rectangle.extent(1), 4.0, 1e-12);
  EXPECT_NEAR(rectangle.area(), 441 * 0.02, 1e-9);
  EXPECT_TRUE(std::isnan(PlaneZone{}.hull_share()));
  EXPECT_EQ(PlaneZone{}.extent(0), 0.0);
}

TEST(ClaimsTest, ReadingsThatDisagreeMakeItSensitive) {
  const Finding yes{true, "1"}, no{false, "2"}, unknown{{}, "3"};
  const auto verdict = [](std::vector<NamedFinding> findings) {
    return judge_claim("s", "q", "m", findings).verdict;
  };
  EXPECT_EQ(verdict({{"a", yes}}), "confirmed");
  EXPECT_EQ(verdict({{"a", no}, {"b", no}}), "not confirmed");
  EXPECT_EQ(verdict({{"a", yes}, {"b", yes}, {"c", no}}), "sensitive");
  EXPECT_EQ(verdict({{"a", no}, {"b", yes}}), "sensitive");
  EXPECT_EQ(verdict({{"a", yes}, {"b", unknown}}), "confirmed");
  EXPECT_EQ(verdict({{"a", unknown}, {"b", yes}}), "not measured");
  const ClaimLine line = judge_claim("s", "q", "m", {{"a", yes}, {"b", no}});
  EXPECT_EQ(line.numbers, "1");
  EXPECT_EQ(line.sensitivity, "b: does not hold (2)");
}

TEST(ClaimsTest, AMissingNumberIsNoVerdict) {
  EXPECT_EQ(if_measured({1.0, 2.0}, false), std::optional<bool>(false));
  EXPECT_FALSE(if_measured({1.0, std::nan("")}, true).has_value());
}

TEST(SlopesTest, FacesFallFortyFiveDegreesAcrossTheirContours) {
  for (const SlopeShape shape : {SlopeShape::concave, SlopeShape::straight, SlopeShape::convex,
                                 SlopeShape::concave_corner, SlopeShape::convex_corner}) {
    const Slope3d slope(shape, {});
    const double y = slope.corner() ? slope.lateral_section() : 3.0, e = 1e-4;
    const auto z = [&](double at_x, double at_y) {
      return slope.surface(slope.distance(at_x, at_y));
    };
    double x = slope.size().crest;  // to the middle of the face, wherever this contour passes y
    while (slope.distance(x, y) < 18.0) x += 0.01;
    const double steep = std::hypot(z(x + e, y) - z(x - e, y), z(x, y + e) - z(x, y - e)) / (2 * e);
    EXPECT_NEAR(steep, 1.0, 1e-6) << words(shape);
    EXPECT_EQ(slope.length(), 40.0);
  }
}

TEST(SlopesTest, TheCornersFaceIsFlatterAlongTheDiagonal) {
  const Slope3d corner(SlopeShape::convex_corner, {}), plane(SlopeShape::plane_35, {});
  const auto z = [&](double x) { return corner.surface(corner.distance(x, x)); };
  const double along_diagonal = (z(14.0) - z(20.0)) / (6.0 * std::sqrt(2.0));
  EXPECT_NEAR(along_diagonal, plane.size().height / plane.face_run(), 1e-12);
  EXPECT_NEAR(std::atan(along_diagonal) * 180.0 / M_PI, 35.264, 1e-3);
}

Scene block() {
  Scene scene;
  scene.dimension = 2;
  scene.spacing = 0.1;
  scene.numerics = preset("modern");
  Material soil;
  soil.name = "soil";
  soil.density = 1800.0;
  soil.model = DruckerPrager{1e6, 0.3, 1e3, 0.35};
  scene.materials = {soil};
  Body body;
  body.shape = Box{{0, 0, 0}, {1, 1, 0}};
  scene.bodies = {body};
  Facet floor;
  floor.origin = {0, 0, 0};
  floor.tangent_u = {1, 0, 0};
  floor.length_u = 1.0;
  floor.normal = {0, 1, 0};
  scene.walls = {{"floor", WallKind::no_slip, {floor}, {}, {}, {}}};
  Stage settle, slide;
  settle.name = "settle";
  settle.duration = 0.05;
  slide = settle;
  slide.name = "slide";
  slide.strength_reduction = 2.0;
  slide.duration = 0.1;
  scene.stages = {settle, slide};
  scene.checkpoints.wall_interval = 0.0;
  scene.checkpoints.interval = 0.02;
  return scene;
}

TEST(NearlyAtRestTest, AsksForSpeedAndTime) {
  for (const double rest_velocity : {10.0, 1e-9}) {  // all of the soil is slower, or none
    Scene scene = block();
    scene.stages.back().duration = 2.0;
    scene.stages.back().rest_velocity = rest_velocity;
    Simulation simulation(scene, {1, {}});
    double first = INFINITY, longest_step = 0.0;
    while (!simulation.finished()) {
      simulation.step();
      const StepReport& step = simulation.last_step();
      longest_step = std::max(longest_step, step.time_step);
      if (nearly_at_rest(simulation, 1.0)) first = std::min(first, step.stage_time);
    }
    if (rest_velocity < 1.0) {
      EXPECT_EQ(first, INFINITY);
      continue;
    }
    const double wait = 3.0 * std::sqrt(1.0 / 9.81);
    EXPECT_GE(first, wait);
    EXPECT_LE(first, wait + 50.0 * longest_step);  // it looks at every 50th step
  }
}

TEST(StudyRunDeathTest, AnInterruptLeavesACheckpointAndTheCosts) {
  // In a process of its own: the request to stop stays.
  const auto interrupted = [] {
    CaseOptions options;
    options.quiet = true;
    options.run.stop = cli::stop_requested;
    options.out = std::filesystem::path(testing::TempDir()) / "study_interrupt_test";
    std::filesystem::remove_all(options.out);
    CaseRun run("case", options);
    cli::catch_interrupts();
    std::uint64_t last_step = 0;
    const Observer observer{[&](const Simulation& now, Outcome&) {
                              last_step = now.last_step().step;
                              if (last_step == 20) std::raise(SIGTERM);
                            },
                            {},
                            [](const Simulation&, Outcome&) {}};
    bool stopped = false;
    try {
      outcome_of(run, {"block", "block", block()}, observer);
    } catch (const Stopped&) {
      stopped = true;
    }
    const auto folder = run.folder() / "block";
    const auto left = read_outcome(folder);
    const auto checkpoints = checkpoints_in(folder);
    std::uint64_t paid = 0;
    for (const RunCost& cost : left->costs) paid += cost.steps;
    const bool good = stopped && last_step == 20 && !left->complete && left->costs.size() == 2 &&
                      paid == 20 && !checkpoints.empty() &&
                      checkpoints[0].filename() == "step_000000000020.h5";
    std::exit(good ? 0 : 1);
  };
  EXPECT_EXIT(interrupted(), testing::ExitedWithCode(0), "");
}

struct Killed {};

TEST(StudyRunTest, AnInterruptedRunEndsWithTheSameOutcome) {
  CaseOptions options;
  options.quiet = true;
  options.out = std::filesystem::path(testing::TempDir()) / "study_run_test";
  std::filesystem::remove_all(options.out);
  double last_time = INFINITY;
  int steps = 0, settled = 0;
  const Observer observer{[&](const Simulation& now, Outcome& outcome) {
                            ++steps;
                            if (now.stage_index() == 1)
                              outcome.values.emplace("slides [s]", now.last_step().time);
                            if (now.last_step().time > last_time) throw Killed{};
                          },
                          [](const Simulation& now) { return now.last_step().time > 0.13; },
                          [&](const Simulation& now, Outcome& outcome) {
                            settled += now.stage_index() == 0;
                            outcome.values[now.finished() ? "end [m/s]" : "settled [m/s]"] =
                                now.last_step().max_velocity;
                          }};
  std::filesystem::create_directories(options.out / "taken");
  std::ofstream(options.out / "taken" / "run.json") << "{}";
  EXPECT_THROW(CaseRun("taken", options), FileError);  // what `scarp run` has left
  CaseRun whole("whole", options);
  const Outcome expected = outcome_of(whole, {"block", "block", block()}, observer);
  EXPECT_TRUE(expected.complete);
  const int all_steps = steps;

  last_time = 0.11;
  CaseRun begun("cut", options);
  EXPECT_THROW(outcome_of(begun, {"block", "block", block()}, observer), Killed);
  EXPECT_FALSE(is_finished(begun, {"block", "block", block()}));

  last_time = INFINITY;
  steps = settled = 0;
  options.resume = true;
  CaseRun resumed("cut", options);
  const Outcome found = outcome_of(resumed, {"block", "block", block()}, observer);
  EXPECT_EQ(found.values, expected.values);
  EXPECT_EQ(found.values.size(), 3u);
  EXPECT_LT(steps, all_steps / 2) << "it goes on at the checkpoint";
  EXPECT_EQ(settled, 0) << "what the first stage left is kept";

  steps = 0;
  const Outcome kept = outcome_of(resumed, {"block", "block", block()}, observer);
  EXPECT_EQ(kept.values, expected.values);
  EXPECT_EQ(steps, 0) << "a finished run is not repeated";

  Scene other = block();
  other.stages[1].strength_reduction = 3.0;
  EXPECT_FALSE(is_finished(resumed, {"block", "block", other}));
}

}  // namespace
}  // namespace scarp::validation
