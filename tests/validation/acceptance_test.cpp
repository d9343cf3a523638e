// SPDX-License-Identifier: BSD-3-Clause
/// Verdicts of measures and the published forms of a case.
#include "validation/acceptance.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "validation/case_run.hpp"

namespace scarp::validation {
namespace {

CaseResult example() {
  CaseResult result;
  result.case_name = "example";
  result.form = "short";
  result.measures = {within("inside", 1.0, "m", 1.0, 0.9, 1.1, "source"),
                     reported("told", 3.0, "s", "depends on spacing")};
  result.runs = {{"settle", 10, 1000.0, 0.1, 2.0}, {"fail", 30, 3000.0, 0.3, 2.0}};
  result.wall_s = 5.0;
  return result;
}

TEST(AcceptanceTest, EdgesOfABandPass) {
  EXPECT_TRUE(*within("m", 0.9, "", {}, 0.9, 1.1, "").pass);
  EXPECT_TRUE(*within("m", 1.1, "", {}, 0.9, 1.1, "").pass);
  EXPECT_FALSE(*within("m", std::nextafter(1.1, 2.0), "", {}, 0.9, 1.1, "").pass);
}

TEST(AcceptanceTest, ObservedOrderIsTheSlopeOfAPowerLaw) {
  const auto error = [](double dx) { return ErrorAtSpacing{dx, -3.0 * dx * dx}; };
  // Logarithms of powers of two: exact but for a few roundings.
  EXPECT_NEAR(observed_order({error(0.5), error(0.25), error(0.125)}), 2.0, 1e-14);
  EXPECT_TRUE(std::isnan(observed_order({error(0.5)})));
  EXPECT_TRUE(std::isnan(observed_order({error(0.5), {0.25, 0.0}})));
}

TEST(AcceptanceTest, NotANumberFails) {
  EXPECT_FALSE(*within("m", std::nan(""), "", {}, -1e300, 1e300, "").pass);
}

TEST(AcceptanceTest, ReportedMeasuresDoNotDecide) {
  CaseResult result = example();
  EXPECT_TRUE(passed(result));
  result.measures = {reported("told", 1.0, "")};
  EXPECT_FALSE(passed(result)) << "a case that judged nothing has shown nothing";
}

TEST(AcceptanceTest, OneFailedMeasureOrAFailureFailsTheCase) {
  CaseResult result = example();
  result.measures.push_back(holds("statement", false, ""));
  EXPECT_FALSE(passed(result));
  result = example();
  result.failure = "unstable";
  EXPECT_FALSE(passed(result));
}

TEST(AcceptanceTest, JsonSumsTheRunsAndKeepsTheBands) {
  const std::filesystem::path path =
      std::filesystem::path(testing::TempDir()) / "scarp_acceptance_test.json";
  write_case_results(path, nullptr, example());
  std::ifstream stream(path);
  const auto json = nlohmann::json::parse(stream);
  EXPECT_EQ(json["case"], "example");
  EXPECT_EQ(json["pass"], true);
  EXPECT_EQ(json["steps"], 40);
  EXPECT_EQ(json["particle_steps_per_s"], 1000.0);
  EXPECT_EQ(json["measures"][0]["band"], nlohmann::json({0.9, 1.1}));
  EXPECT_TRUE(json["measures"][1]["pass"].is_null());
  std::filesystem::remove(path);
}

TEST(AcceptanceTest, TheTitleIsThatOfTheCaseWhateverItRanLast) {
  CaseOptions options;
  options.out = std::filesystem::path(testing::TempDir()) / "scarp_acceptance_test";
  options.quiet = true;
  CaseRun run("askew", options);
  const Simulation last(run.scene_at(0.5, "modern", "layer.toml"), options.run);
  run.finish(&last);
  std::ifstream stream(options.out / "askew/results.json");
  EXPECT_EQ(nlohmann::json::parse(stream)["title"], run.scene_at(0.5, "modern").title);
  std::filesystem::remove_all(options.out);
}

TEST(AcceptanceTest, TableNamesVerdictAndMeasures) {
  CaseResult result = example();
  result.measures.push_back(within("outside", 2.0, "m", 1.0, 0.9, 1.1, "source"));
  const std::string table = console_table(result);
  EXPECT_NE(table.find("FAIL  outside"), std::string::npos) << table;
  EXPECT_NE(table.find("pass  inside"), std::string::npos) << table;
  EXPECT_NE(table.find("1 of 2 judged"), std::string::npos) << table;
}

}  // namespace
}  // namespace scarp::validation
