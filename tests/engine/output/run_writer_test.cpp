// SPDX-License-Identifier: BSD-3-Clause
/// When a run writes what, and what results.json claims.

#include "engine/output/run_writer.hpp"
#include "engine/run/run.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "engine/errors.hpp"
#include "engine/output/text_file.hpp"
#include "tests/engine/output/output_fixture.hpp"

namespace scarp {
namespace {

using nlohmann::json;

class RunWriterTest : public OutputTest {
 protected:
  json results() const { return json::parse(text_of(folder_ / "results.json")); }

  std::vector<std::string> events() const {
    std::vector<std::string> found;
    const auto series = json::parse(text_of(folder_ / "frames" / "soil.hdf.series"));
    for (const auto& entry : series.at("files")) {
      found.push_back(
          attribute(folder_ / "frames" / entry.at("name").get<std::string>(), "/", "event"));
    }
    return found;
  }
  std::vector<std::string> lines(const char* name) const {
    std::vector<std::string> found;
    std::istringstream stream(text_of(folder_ / name));
    for (std::string line; std::getline(stream, line);) found.push_back(line);
    return found;
  }
};

// Stages of 0.04 s and frames every 0.015 s: two between start and end of each stage.
TEST_F(RunWriterTest, WritesFramesAtIntervalsAndStageEnds) {
  Simulation simulation = block();
  RunWriter writer(simulation, folder_);
  run(simulation, {.writer = &writer});
  EXPECT_EQ(events(),
            (std::vector<std::string>{"start", "interval", "interval", "stage_end", "stage_start",
                                      "interval", "interval", "stage_end"}));
  const json found = results();
  EXPECT_EQ(found.at("complete"), true);
  EXPECT_TRUE(found.at("pass").is_null());
  EXPECT_EQ(found.at("steps"), simulation.last_step().step);
  EXPECT_EQ(found.at("particles"), 32);
  EXPECT_EQ(found.at("version"), 1);
  ASSERT_EQ(found.at("stages").size(), 2u);
  EXPECT_EQ(found.at("stages")[0].at("name"), "first");
  EXPECT_NEAR(found.at("stages")[0].at("end_time_s").get<double>(), 0.04, 1e-9);
}

// A row takes a force sweep more than there are walls. Stages of some ten steps would have one on
// each, as dear as the step itself, so there are few: 8 steps apart at least.
TEST_F(RunWriterTest, RowsOfShortStagesCostATenthOfTheSteps) {
  std::string stiff = block_text;
  stiff.replace(stiff.find("10 MPa"), 6, "500 MPa");
  Simulation simulation(read_scene_text(stiff, "block.toml"));
  RunWriter writer(simulation, folder_);
  run(simulation, {.writer = &writer});
  std::vector<std::uint64_t> steps;
  for (const std::string& line : lines("history.csv")) {
    std::istringstream cells(line);
    std::string cell;
    for (int k = 0; k < 3; ++k) std::getline(cells, cell, ',');
    if (cell != "step") steps.push_back(std::stoull(cell));
  }
  const std::uint64_t taken = simulation.last_step().step;
  ASSERT_GT(taken, 50u);
  ASSERT_LT(taken, 180u);  // a hundredth of a stage is less than a step
  const json stages = results().at("stages");
  std::vector<std::uint64_t> fixed{0};  // start, ends of stages and the steps behind them
  for (const json& stage : stages) fixed.push_back(stage.at("end_step").get<std::uint64_t>());
  fixed.push_back(fixed[1] + 1);
  std::size_t between = 0;
  for (const std::uint64_t step : steps)
    between += std::find(fixed.begin(), fixed.end(), step) == fixed.end();
  EXPECT_EQ(steps.size() - between, fixed.size());
  EXPECT_LE(between, taken / 8);
  EXPECT_GT(between, 0u);
}

TEST_F(RunWriterTest, RowsFallOnEveryStepWhereTheSceneAsksForThem) {
  const std::string each = block_text + "probes_every = 1e-9\n";
  Simulation simulation(read_scene_text(each, "block.toml"));
  RunWriter writer(simulation, folder_);
  run(simulation, {.writer = &writer});
  EXPECT_EQ(lines("history.csv").size(), simulation.last_step().step + 2);  // titles and start
}

TEST_F(RunWriterTest, OutputsHaveTheirLinesInTheProfile) {
  Simulation simulation = block();
  RunWriter writer(simulation, folder_);
  writer.add_checkpoint_time(0.25);
  run(simulation, {.writer = &writer});
  const json found = results();
  std::map<std::string, double> seconds;
  for (const json& phase : found.at("profile"))
    seconds[phase.at("phase")] = phase.at("wall_s").get<double>();
  EXPECT_GT(seconds.at("write_frames"), 0.0);
  EXPECT_GT(seconds.at("write_rows"), 0.0);
  EXPECT_EQ(seconds.at("write_checkpoints"), 0.25);
  EXPECT_GT(found.at("resident_peak_bytes"), found.at("memory_bytes"));
}

TEST_F(RunWriterTest, ReportsTheMass) {
  Simulation simulation = block();
  RunWriter writer(simulation, folder_);
  writer.finish(simulation, 1.0);
  const json found = results();
  for (const json& measure : found.at("measures")) {
    if (measure.at("name") != "mass") continue;
    EXPECT_DOUBLE_EQ(measure.at("value").get<double>(), 2000.0 * 4.0 * 2.0);
    EXPECT_EQ(measure.at("unit"), "kg/m");
    return;
  }
  FAIL() << "no mass among the measures";
}

TEST_F(RunWriterTest, ReportsTheSmoothingThatARunTook) {
  Simulation simulation = block();
  ASSERT_EQ(simulation.scene().numerics.smoothing, SmoothingFunction::by_dimension);
  RunWriter writer(simulation, folder_);
  writer.finish(simulation, 1.0);
  const json numerics = results().at("numerics");
  EXPECT_EQ(numerics.at("smoothing"), "cubic_spline");
  EXPECT_DOUBLE_EQ(numerics.at("smoothing_ratio").get<double>(), 1.2);
}

TEST_F(RunWriterTest, WritesAsManyCellsPerRowAsTitles) {
  Simulation simulation = block();
  RunWriter writer(simulation, folder_);
  run(simulation, {.writer = &writer});
  for (const char* name : {"history.csv", "probes.csv", "walls.csv"}) {
    const auto rows = lines(name);
    ASSERT_GT(rows.size(), 3u) << name;
    EXPECT_EQ(rows[0].substr(0, 14), "time [s],stage") << name;
    double before = -1.0;
    for (std::size_t r = 1; r < rows.size(); ++r) {
      EXPECT_EQ(std::count(rows[r].begin(), rows[r].end(), ','),
                std::count(rows[0].begin(), rows[0].end(), ','))
          << name << " " << r;
      const double time = std::stod(rows[r]);
      EXPECT_GT(time, before) << name << " " << r;
      before = time;
    }
    EXPECT_NEAR(before, simulation.last_step().time, 1e-9) << name;
  }
  EXPECT_NE(lines("probes.csv")[0].find("corner.stress_xy [Pa]"), std::string::npos);
  EXPECT_EQ(lines("probes.csv")[0].find("corner.velocity_z"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "energy.csv"));  // the scene did not ask for it
}

TEST_F(RunWriterTest, StopsOnRequestWithItsOutputsFinished) {
  Simulation simulation = block();
  RunWriter writer(simulation, folder_);
  run(simulation, {.writer = &writer,
                   .after_step = [](const Simulation& now) { return now.last_step().step < 2; }});
  EXPECT_EQ(simulation.last_step().step, 2u);
  EXPECT_EQ(results().at("complete"), false);
  EXPECT_EQ(results().at("pass"), false);
  EXPECT_EQ(events().back(), "stopped");
}

TEST_F(RunWriterTest, PassesOnlyIfEveryJudgedMeasurePasses) {
  const Simulation simulation = block();
  RunWriter writer(simulation, folder_);
  const Measure good{"good", 1.0, "m", 1.0, std::array{0.9, 1.1}, "a book", true};
  const Measure bad{"bad", 2.0, "m", 1.0, std::array{0.9, 1.1}, "a book", false};
  const Measure fact{"fact", std::numeric_limits<double>::quiet_NaN(), "m", {}, {}, "", {}};
  const auto verdict = [&](std::vector<Measure> measures, const std::string& failure = {}) {
    writer.set_measures(std::move(measures));
    writer.finish(simulation, 1.0, failure);
    return results().at("pass");
  };
  EXPECT_EQ(verdict({fact, good}), json(true));
  EXPECT_EQ(verdict({bad, good}), json(false));
  EXPECT_EQ(verdict({good, bad, fact}), json(false));
  EXPECT_EQ(verdict({fact}), json());
  EXPECT_EQ(verdict({good}, "ran away"), json(false));
  EXPECT_EQ(results().at("measures")[0].at("band"), json({0.9, 1.1}));
}

TEST_F(RunWriterTest, KeepsACopyOfTheScene) {
  std::ofstream(folder_ / "block.toml") << block_text;
  const Simulation simulation(read_scene(folder_ / "block.toml"));
  const RunWriter writer(simulation, folder_ / "out");
  EXPECT_EQ(text_of(folder_ / "out" / "scene.toml"), block_text);
}

TEST_F(RunWriterTest, SaysThatTheFolderCannotBeMade) {
  std::ofstream(folder_ / "file") << "";
  EXPECT_THROW(RunWriter(block(), folder_ / "file" / "out"), FileError);
}

TEST_F(RunWriterTest, QuotesCellsWithCommasAndQuotes) {
  CsvFile table(folder_ / "table.csv", {"a, \"b\"", "c"});
  table << 0.5 << "plain";
  table.end_row();
  EXPECT_EQ(text_of(folder_ / "table.csv"), "\"a, \"\"b\"\"\",c\n0.5,plain\n");
}

}  // namespace
}  // namespace scarp
