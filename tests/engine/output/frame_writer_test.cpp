// SPDX-License-Identifier: BSD-3-Clause
/// Frames hold what the simulation holds, in the form VTK's readers expect, or are not there at
/// all.

#include "engine/output/frame_writer.hpp"

#include <sys/resource.h>

#include <csignal>
#include <nlohmann/json.hpp>
#include <numeric>

#include "engine/errors.hpp"
#include "engine/output/hdf5_file.hpp"
#include "tests/engine/output/output_fixture.hpp"

namespace scarp {
namespace {

class FrameWriterTest : public OutputTest {};

TEST_F(FrameWriterTest, HoldsEveryFieldRoundedToFloat) {
  Simulation simulation = block();
  for (int n = 0; n < 3; ++n) simulation.step();
  const auto path = folder_ / "soil.hdf";
  write_soil_frame(path, simulation, "interval");
  ASSERT_FALSE(simulation.fields().empty());
  for (const FieldInfo& field : simulation.fields()) {
    if (field.name == "position") continue;
    const std::string name = "VTKHDF/PointData/" + field.name;
    std::vector<hsize_t> shape;
    const std::vector<double> stored = dataset(path, name, &shape);
    const std::vector<double> held = simulation.field(field.name);
    ASSERT_EQ(stored.size(), held.size()) << field.name;
    EXPECT_EQ(shape[0], simulation.soil_count());
    if (field.components > 1) {
      ASSERT_EQ(shape.size(), 2u);
      EXPECT_EQ(shape[1], static_cast<hsize_t>(field.components));
    }
    for (std::size_t i = 0; i < held.size(); ++i) {
      EXPECT_EQ(stored[i], static_cast<double>(static_cast<float>(held[i])))
          << field.name << " " << i;
    }
  }
  EXPECT_EQ(attribute(path, "VTKHDF/PointData/stress", "unit"), "Pa");
}

TEST_F(FrameWriterTest, IsOnePolyVertexCellOfAllParticles) {
  const Simulation simulation = block();
  const auto path = folder_ / "soil.hdf";
  write_soil_frame(path, simulation, "start");
  const auto count = static_cast<double>(simulation.soil_count());
  EXPECT_EQ(count, 32.0);
  EXPECT_EQ(attribute(path, "VTKHDF", "Type"), "UnstructuredGrid");
  EXPECT_EQ(attribute(path, "VTKHDF", "Version").substr(0, 2), "1.");
  EXPECT_EQ(dataset(path, "VTKHDF/NumberOfPoints"), std::vector{count});
  EXPECT_EQ(dataset(path, "VTKHDF/NumberOfCells"), std::vector{1.0});
  EXPECT_EQ(dataset(path, "VTKHDF/NumberOfConnectivityIds"), std::vector{count});
  EXPECT_EQ(dataset(path, "VTKHDF/Offsets"), (std::vector{0.0, count}));
  EXPECT_EQ(dataset(path, "VTKHDF/Types"), std::vector{2.0});
  std::vector<double> all(simulation.soil_count());
  std::iota(all.begin(), all.end(), 0.0);
  EXPECT_EQ(dataset(path, "VTKHDF/Connectivity"), all);
  EXPECT_EQ(dataset(path, "VTKHDF/PointData/id"), all);
}

TEST_F(FrameWriterTest, StatesTheMoment) {
  Simulation simulation = block();
  const double time = simulation.step().time;
  const auto path = folder_ / "soil.hdf";
  write_soil_frame(path, simulation, "interval");
  EXPECT_EQ(dataset(path, "VTKHDF/FieldData/TimeValue"), std::vector{time});
  EXPECT_EQ(attribute(path, "/", "stage"), "first");
  EXPECT_EQ(attribute(path, "/", "event"), "interval");
  EXPECT_EQ(attribute(path, "/", "spacing"), std::to_string(0.5));
}

// A float has 24 bits: 100 km away from the origin it resolves 8 mm, a sixtieth of the spacing.
TEST_F(FrameWriterTest, KeepsPositionsFarFromTheOriginAsDoubles) {
  std::string text = block_text;
  const auto replace = [&text](const std::string& from, const std::string& to) {
    text.replace(text.find(from), from.size(), to);
  };
  replace("[[0, 0], [4, 0], [4, 2], [0, 2]]",
          "[[100000, 0], [100004, 0], [100004, 2], [100000, 2]]");
  replace("[[-2, 0], [6, 0]]", "[[99998, 0], [100006, 0]]");
  replace("[4, 2]", "[100004, 2]");
  const Simulation simulation(read_scene_text(text, "far.toml"));
  std::size_t bytes = 0;
  write_soil_frame(folder_ / "far.hdf", simulation, "start");
  EXPECT_EQ(dataset(folder_ / "far.hdf", "VTKHDF/Points", nullptr, nullptr, &bytes),
            simulation.field("position"));
  EXPECT_EQ(bytes, 8u);
  write_soil_frame(folder_ / "near.hdf", block(), "start");
  dataset(folder_ / "near.hdf", "VTKHDF/Points", nullptr, nullptr, &bytes);
  EXPECT_EQ(bytes, 4u);
}

TEST_F(FrameWriterTest, ListsFramesWithTheirTimes) {
  Simulation simulation = block();
  FrameWriter frames(simulation, folder_);
  frames.write(simulation, "start");
  const double time = simulation.step().time;
  frames.write(simulation, "interval");
  const auto series = nlohmann::json::parse(text_of(folder_ / "soil.hdf.series"));
  EXPECT_EQ(series.at("file-series-version"), "1.0");
  ASSERT_EQ(series.at("files").size(), 2u);
  EXPECT_EQ(series.at("files")[1].at("time"), time);
  for (const auto& entry : series.at("files")) {
    EXPECT_TRUE(std::filesystem::exists(folder_ / entry.at("name").get<std::string>()));
  }
  EXPECT_EQ(dataset(folder_ / "walls.hdf", "VTKHDF/NumberOfPoints"),
            std::vector{static_cast<double>(simulation.wall_positions().size() / 3)});
  EXPECT_FALSE(std::filesystem::exists(folder_ / "walls_00000.hdf"));
}

// A list is a new file each time. Of 300 frames the first 100 have one each, those behind share
// one with a thirtieth of what is there: log(300/100)/log(33/32) = 36 more.
TEST_F(FrameWriterTest, WritesListsOfManyFramesNowAndThen) {
  Simulation simulation = block();
  FrameWriter writer(simulation, folder_);
  const auto list = folder_ / "soil.hdf.series";
  const auto listed = [&] { return nlohmann::json::parse(text_of(list)).at("files").size(); };
  std::size_t lists = 0, before = 0;
  for (std::size_t count = 1; count <= 300; ++count) {
    writer.write(simulation, "interval");
    const std::size_t now = listed();
    lists += now != before;
    before = now;
    EXPECT_LE(now, count);
    EXPECT_GE(now + now / 32 + 1, count);
  }
  EXPECT_LE(lists, 100u + 40u);
  EXPECT_LT(listed(), 300u);
  writer.write_lists();
  EXPECT_EQ(listed(), 300u);
}

TEST_F(FrameWriterTest, WritesMovingWallsWithEachFrame) {
  std::string text = block_text;
  const std::string line = "line = [[-2, 0], [6, 0]]";
  text.insert(text.find(line) + line.size(), "\nmotion = {velocity = [0.1, 0.0]}");
  Simulation simulation(read_scene_text(text, "moving.toml"));
  FrameWriter frames(simulation, folder_);
  frames.write(simulation, "start");
  const double moved = 0.1 * simulation.step().time;
  frames.write(simulation, "interval");
  EXPECT_EQ(dataset(folder_ / "walls_00000.hdf", "faces/corners"),
            (std::vector<double>{-2, 0, 0, 6, 0, 0}));
  EXPECT_EQ(dataset(folder_ / "walls_00001.hdf", "faces/corners"),
            (std::vector<double>{-2 + moved, 0, 0, 6 + moved, 0, 0}));
  EXPECT_EQ(attribute(folder_ / "walls_00001.hdf", "faces/wall", "names"), "base\n");
  EXPECT_TRUE(std::filesystem::exists(folder_ / "walls_00001.hdf"));
  EXPECT_EQ(nlohmann::json::parse(text_of(folder_ / "walls.hdf.series")).at("files").size(), 2u);
}

TEST_F(FrameWriterTest, RemovesOnlyFramesOfAnEarlierRun) {
  const Simulation simulation = block();
  for (const char* name : {"soil_00007.hdf", "walls_00001.hdf", "soil_00008.hdf.part",
                           "soil_map.hdf", "soil_survey.csv"}) {
    std::ofstream(folder_ / name) << "old";
  }
  const FrameWriter frames(simulation, folder_);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "soil_00007.hdf"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "walls_00001.hdf"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "soil_00008.hdf.part"));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "soil_map.hdf"));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "soil_survey.csv"));
}

TEST_F(FrameWriterTest, SaysWhichFileCannotBeWritten) {
  const auto path = folder_ / "missing" / "soil.hdf";
  try {
    write_soil_frame(path, block(), "start");
    FAIL() << "no error";
  } catch (const FileError& error) {
    EXPECT_NE(std::string(error.what()).find(path.string()), std::string::npos) << error.what();
  }
}

// A limit on the file size stands for a full disk: the write fails in the middle.
TEST_F(FrameWriterTest, LeavesTheEarlierFileWhenTheDiskIsFull) {
  const Simulation simulation = block();
  const auto path = folder_ / "soil.hdf";
  write_soil_frame(path, simulation, "start");
  const std::string before = text_of(path);
  rlimit old{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &old), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{2048, old.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  EXPECT_THROW(write_soil_frame(path, simulation, "last"), FileError);
  setrlimit(RLIMIT_FSIZE, &old);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(text_of(path), before);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "soil.hdf.part"));
  EXPECT_NO_THROW(write_soil_frame(path, simulation, "last"));
}

TEST_F(FrameWriterTest, AnUncommittedFileLeavesNothing) {
  {
    hdf5::NewFile file(folder_ / "half.hdf");
    file.dataset<double>("values", {1.0, 2.0});
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder_));
}

}  // namespace
}  // namespace scarp
