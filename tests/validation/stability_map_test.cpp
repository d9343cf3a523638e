// SPDX-License-Identifier: BSD-3-Clause
/// Cells, log and noise measure of the stability map.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <string>

#include "engine/checkpoint/scene_text.hpp"
#include "validation/stability/map_output.hpp"
#include "validation/stability/scenes.hpp"
#include "validation/stress_noise.hpp"

namespace scarp::validation {
namespace {

TEST(StabilityMap, CellsAreSmallGoodScenesAndNoTwoAreEqual) {
  std::set<std::string> seen;
  for (const Cell& cell : stability_cells(false)) {
    const std::string name = cell.group + " " + cell.axis + " " + cell.value;
    const Simulation simulation(cell.scene, {1, {}});
    if (cell.group != "noise") {
      EXPECT_LE(simulation.soil_count(), cell.scene.dimension == 2 ? 560u : 1100u) << name;
    }
    EXPECT_TRUE(seen.insert(name + scene_text(cell.scene)).second) << name;
  }
  EXPECT_GT(seen.size(), 100u);
}

TEST(StabilityMap, TheShortFormHasBothPresetsOfEveryAxis) {
  std::set<std::string> full, brief;
  for (const Cell& cell : stability_cells(false))
    full.insert(cell.axis + "/" + cell.scene.numerics.preset);
  for (const Cell& cell : stability_cells(true))
    brief.insert(cell.axis + "/" + cell.scene.numerics.preset);
  EXPECT_EQ(full, brief);
}

TEST(StabilityMap, TheLogGivesBackWhatWasPutInAndPassesOverBrokenLines) {
  const std::filesystem::path path =
      std::filesystem::path(::testing::TempDir()) / "scarp_cells.jsonl";
  std::filesystem::remove(path);
  CellRecord record;
  record.key = "abc";
  record.verdict = Verdict::stopped;
  record.reason = "step 3: too fast";
  record.stable_cfl = 1.25;
  record.lost = 2.0;
  CellLog(path).append(record);
  std::ofstream(path, std::ios::app) << R"({"key": "half)";
  CellLog log(path);
  record.key = "next";
  log.append(record);
  const CellLog again(path);
  ASSERT_NE(again.find("abc"), nullptr);
  EXPECT_EQ(again.find("half"), nullptr);
  ASSERT_NE(again.find("next"), nullptr);
  EXPECT_EQ(again.find("abc")->verdict, Verdict::stopped);
  EXPECT_EQ(again.find("abc")->reason, record.reason);
  EXPECT_EQ(again.find("abc")->stable_cfl, record.stable_cfl);
  EXPECT_FALSE(again.find("abc")->unstable_cfl);
  std::filesystem::remove(path);
}

/// A level bed at its geostatic start, every pressure changed by `change`(place), and every shear
/// stress by `shear` of that.
template <class Change>
StressNoise noise_of_bed(Change&& change, double shear = 0.0) {
  const Scene scene = bed_scene("modern", 10, 5, 0.5);
  const Simulation plain(scene, {1, {}});
  const Snapshot before = plain.snapshot();
  Snapshot changed;
  const std::vector<double> x = before.numbers("fields/position");
  for (SnapshotItem item : before.items()) {
    if (item.name == "fields/stress") {
      auto& s = std::get<std::vector<double>>(item.values);
      const std::size_t slots = item.shape[1];
      for (std::size_t k = 0; k < plain.soil_count(); ++k) {
        const double stress = change(x[k], x[slots + k]);
        for (std::size_t c = 0; c < 3; ++c) s[c * slots + k] += stress;
        s[3 * slots + k] += shear * stress;
      }
    }
    changed.add(std::move(item));
  }
  return stress_noise(Simulation(scene, changed, {1, {}}));
}

TEST(StressNoise, IsNothingForALinearFieldAndTheAmplitudeOfStripes) {
  EXPECT_LT(noise_of_bed([](double, double) { return 0.0; }).pressure, 1e-12);
  const StressNoise smooth =
      noise_of_bed([](double x, double y) { return 3e3 * x - 2e3 * y; }, 0.5);
  EXPECT_LT(smooth.pressure, 1e-12);
  EXPECT_LT(smooth.shear, 1e-12);
  // Stripes of +-1 kPa on 1 MPa, one layer wide. The fit keeps the mean of the layers in reach,
  // which stripes of +1 and -1 leave below a fifth of the amplitude.
  const StressNoise striped = noise_of_bed(
      [](double, double y) { return -1e6 + (static_cast<int>(y / 0.5) % 2 == 0 ? 1e3 : -1e3); },
      0.5);
  EXPECT_NEAR(striped.pressure, 1e-3, 0.2e-3);
  EXPECT_NEAR(striped.shear, 0.5e-3, 0.1e-3);
}

}  // namespace
}  // namespace scarp::validation
