// SPDX-License-Identifier: BSD-3-Clause
/// VTKHDF frames and their series files.

#include "engine/output/frame_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <numeric>
#include <regex>
#include <string>
#include <system_error>

#include "engine/errors.hpp"
#include "engine/output/hdf5_file.hpp"
#include "engine/output/text_file.hpp"

namespace scarp {
namespace {

constexpr std::uint8_t poly_vertex = 2;  // VTK_POLY_VERTEX

template <class To>
std::vector<To> converted(const std::vector<double>& values) {
  std::vector<To> result(values.size());
  std::transform(values.begin(), values.end(), result.begin(),
                 [](double value) { return static_cast<To>(value); });
  return result;
}

/// Float positions resolve 1e-7 of the largest coordinate; scenes far from the origin need doubles.
bool needs_double(const std::vector<double>& positions, double spacing) {
  return std::any_of(positions.begin(), positions.end(),
                     [limit = 1e4 * spacing](double x) { return std::abs(x) > limit; });
}

void write_grid(hdf5::NewFile& file, const std::vector<double>& positions, double spacing) {
  const auto count = static_cast<std::int64_t>(positions.size() / 3);
  file.group("VTKHDF");
  file.attribute("VTKHDF", "Version", std::vector<std::int64_t>{1, 0});
  file.attribute("VTKHDF", "Type", "UnstructuredGrid");
  file.dataset<std::int64_t>("VTKHDF/NumberOfPoints", {count});
  file.dataset<std::int64_t>("VTKHDF/NumberOfCells", {1});
  file.dataset<std::int64_t>("VTKHDF/NumberOfConnectivityIds", {count});
  const hdf5::NewFile::Shape shape{positions.size() / 3, 3};
  if (needs_double(positions, spacing)) {
    file.dataset("VTKHDF/Points", positions, shape);
  } else {
    file.dataset("VTKHDF/Points", converted<float>(positions), shape);
  }
  std::vector<std::int64_t> all(positions.size() / 3);
  std::iota(all.begin(), all.end(), 0);
  file.dataset("VTKHDF/Connectivity", all);
  file.dataset<std::int64_t>("VTKHDF/Offsets", {0, count});
  file.dataset<std::uint8_t>("VTKHDF/Types", {poly_vertex});
  file.group("VTKHDF/PointData");
}

void write_moment(hdf5::NewFile& file, const Simulation& simulation, std::string_view event) {
  const Scene& scene = simulation.scene();
  const StepReport& report = simulation.last_step();
  const auto stage = static_cast<std::int64_t>(simulation.stage_index());
  file.group("VTKHDF/FieldData");
  file.dataset<double>("VTKHDF/FieldData/TimeValue", {report.time});
  file.attribute("/", "time", report.time);
  file.attribute("/", "step", std::vector<std::int64_t>{static_cast<std::int64_t>(report.step)});
  file.attribute("/", "stage_index", std::vector<std::int64_t>{stage});
  if (simulation.stage_index() < scene.stages.size()) {
    file.attribute("/", "stage", scene.stages[simulation.stage_index()].name);
  }
  file.attribute("/", "event", event);
  file.attribute("/", "title", scene.title);
  file.attribute("/", "dimension", std::vector<std::int64_t>{scene.dimension});
  file.attribute("/", "spacing", scene.spacing);
}

bool any_wall_changes(const Scene& scene) {
  return std::any_of(scene.walls.begin(), scene.walls.end(), [](const Wall& wall) {
    return wall.velocity != Vec3{} || !wall.removed_at.empty();
  });
}

std::string frame_name(std::string_view name, std::size_t number) {
  return fmt::format("{}_{:05}.hdf", name, number);
}

/// Makes the folder; removes frames from number `kept` on, half-written files, and with no frame
/// kept all that is not numbered.
void clear_frames(const std::filesystem::path& folder, std::size_t kept) {
  const std::regex ours(R"((?:soil|walls)(?:_(\d{5,9}))?\.hdf(?:\.series)?(\.part)?)");
  try {
    std::filesystem::create_directories(folder);
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      const std::string name = entry.path().filename().string();
      std::smatch parts;
      if (!std::regex_match(name, parts, ours)) continue;
      const bool goes = parts[1].matched ? std::stoul(parts[1]) >= kept : kept == 0;
      if (goes || parts[2].matched) std::filesystem::remove(entry.path());
    }
  } catch (const std::filesystem::filesystem_error& error) {
    throw FileError(fmt::format("'{}': cannot be used as output folder: {}.", folder.string(),
                                error.code().message()));
  }
}

}  // namespace

void write_soil_frame(const std::filesystem::path& path, const Simulation& simulation,
                      std::string_view event) {
  hdf5::NewFile file(path);
  write_grid(file, simulation.field("position"), simulation.scene().spacing);
  write_moment(file, simulation, event);
  for (const FieldInfo& field : simulation.fields()) {
    if (field.name == "position" || field.name == "id" || field.name == "material") continue;
    const std::string name = "VTKHDF/PointData/" + field.name;
    const auto values = converted<float>(simulation.field(field.name));
    const auto components = static_cast<hsize_t>(field.components);
    hdf5::NewFile::Shape shape{values.size() / components};
    if (components > 1) shape.push_back(components);
    file.dataset(name, values, shape);
    file.attribute(name, "unit", field.unit);
    file.attribute(name, "description", field.description);
  }
  file.dataset("VTKHDF/PointData/id", converted<std::int64_t>(simulation.field("id")));
  file.dataset("VTKHDF/PointData/material", converted<std::int32_t>(simulation.field("material")));
  file.commit();
}

void write_wall_frame(const std::filesystem::path& path, const Simulation& simulation) {
  hdf5::NewFile file(path);
  write_grid(file, simulation.wall_positions(), simulation.scene().spacing);
  write_moment(file, simulation, "walls");
  file.commit();
}

FrameWriter::FrameWriter(const Simulation& simulation, std::filesystem::path folder)
    : folder_(std::move(folder)),
      has_walls_(!simulation.scene().walls.empty()),
      walls_change_(any_wall_changes(simulation.scene())) {
  clear_frames(folder_, 0);
}

FrameWriter::FrameWriter(const Simulation& simulation, std::filesystem::path folder,
                         const Snapshot& progress)
    : folder_(std::move(folder)),
      times_(progress.numbers("outputs/frame_times")),
      flushed_(times_.size()),
      has_walls_(!simulation.scene().walls.empty()),
      walls_change_(any_wall_changes(simulation.scene())) {
  for (std::size_t number = 0; number < count(); ++number) {
    for (const std::filesystem::path& path : files_of_frame(number)) {
      std::error_code error;
      if (std::filesystem::exists(path, error)) continue;
      throw CheckpointError(
          fmt::format("'{}': is gone, but the run had written it. Try the checkpoint before it, or "
                      "put it back.",
                      path.string()));
    }
  }
  clear_frames(folder_, count());
  write_lists();
}

std::vector<std::filesystem::path> FrameWriter::files_of_frame(std::size_t number) const {
  std::vector<std::filesystem::path> files{folder_ / frame_name("soil", number)};
  if (has_walls_ && walls_change_) files.push_back(folder_ / frame_name("walls", number));
  if (has_walls_ && !walls_change_ && number == 0) files.push_back(folder_ / "walls.hdf");
  return files;
}

void FrameWriter::add_progress(Snapshot& snapshot) {
  for (; flushed_ < count(); ++flushed_) {
    for (const std::filesystem::path& path : files_of_frame(flushed_)) flush_to_disk(path);
  }
  flush_to_disk(folder_);
  snapshot.add("outputs/frame_times", "s", times_);
}

void FrameWriter::write(const Simulation& simulation, std::string_view event) {
  const std::vector<std::filesystem::path> files = files_of_frame(count());
  write_soil_frame(files.front(), simulation, event);
  if (files.size() > 1) write_wall_frame(files.back(), simulation);
  times_.push_back(simulation.last_step().time);
  write_lists();
}

void FrameWriter::write_lists() const {
  write_series("soil");
  if (has_walls_ && walls_change_) write_series("walls");
}

void FrameWriter::write_series(std::string_view name) const {
  nlohmann::ordered_json series{{"file-series-version", "1.0"},
                                {"files", nlohmann::ordered_json::array()}};
  for (std::size_t n = 0; n < times_.size(); ++n) {
    series["files"].push_back({{"name", frame_name(name, n)}, {"time", times_[n]}});
  }
  replace_file(folder_ / (std::string(name) + ".hdf.series"), series.dump(1) + "\n");
}

}  // namespace scarp
