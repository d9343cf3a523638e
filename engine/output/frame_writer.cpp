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

#include "engine/boundary/facet_geometry.hpp"
#include "engine/errors.hpp"
#include "engine/output/hdf5_file.hpp"
#include "engine/output/text_file.hpp"

namespace scarp {
namespace {

constexpr std::uint8_t poly_vertex = 2;  // VTK_POLY_VERTEX

/// How many bytes of old frames are read when a run goes on.
constexpr std::uintmax_t most_summed = std::uintmax_t{2} << 30;
constexpr std::int64_t most_frames = 999'999'999;

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
  file.attribute("/", "spacing", simulation.spacing());
}

/// The faces of the walls that stand, beside the grid: readers of VTK files look past them.
void write_faces(hdf5::NewFile& file, const Simulation& simulation) {
  const int dimension = simulation.scene().dimension;
  std::vector<double> positions;
  std::vector<std::int32_t> walls;
  for (const WallFace& face : simulation.wall_faces()) {
    for (const Vec3& corner : geometry::corners(face.facet, dimension))
      positions.insert(positions.end(), corner.begin(), corner.end());
    walls.push_back(static_cast<std::int32_t>(face.wall));
  }
  file.group("faces");
  const hsize_t corners = dimension == 2 ? 2 : 4;
  file.dataset("faces/corners", positions, {walls.size(), corners, 3});
  file.attribute("faces/corners", "unit", "m");
  file.dataset("faces/wall", walls);
  std::string names;
  for (const Wall& wall : simulation.scene().walls) names += wall.name + '\n';
  file.attribute("faces/wall", "names", names);
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

void fill(hdf5::NewFile& file, const Simulation& simulation, std::string_view event) {
  write_grid(file, simulation.field("position"), simulation.spacing());
  write_moment(file, simulation, event);
  for (const FieldInfo& field : simulation.fields()) {
    const std::string name = "VTKHDF/PointData/" + field.name;
    const std::vector<double> values = simulation.field(field.name);
    const auto components = static_cast<hsize_t>(field.components);
    hdf5::NewFile::Shape shape{values.size() / components};
    if (components > 1) shape.push_back(components);
    switch (field.numbers) {
      case FieldInfo::Numbers::real:
        file.dataset(name, converted<float>(values), shape);
        break;
      case FieldInfo::Numbers::int32:
        file.dataset(name, converted<std::int32_t>(values), shape);
        break;
      case FieldInfo::Numbers::int64:
        file.dataset(name, converted<std::int64_t>(values), shape);
        break;
    }
    file.attribute(name, "unit", field.unit);
    file.attribute(name, "description", field.description);
  }
}

}  // namespace

void write_soil_frame(const std::filesystem::path& path, const Simulation& simulation,
                      std::string_view event) {
  hdf5::NewFile file(path);
  fill(file, simulation, event);
  file.commit();
}

std::size_t soil_frame_bytes(const Simulation& simulation) {
  hdf5::NewFile file("a frame");
  fill(file, simulation, "");
  return file.bytes().size();
}

void write_wall_frame(const std::filesystem::path& path, const Simulation& simulation) {
  hdf5::NewFile file(path);
  write_grid(file, simulation.wall_positions(), simulation.spacing());
  write_moment(file, simulation, "walls");
  write_faces(file, simulation);
  file.commit();
}

FrameWriter::FrameWriter(const Simulation& simulation, std::filesystem::path folder)
    : folder_(std::move(folder)) {
  const Scene& scene = simulation.scene();
  has_changing_walls_ = any_wall_changes(scene);
  has_fixed_walls_ = !scene.walls.empty() && !has_changing_walls_;
  clear_frames(folder_, 0);
}

FrameWriter::FrameWriter(const Simulation& simulation, std::filesystem::path folder,
                         const Snapshot& progress)
    : folder_(std::move(folder)), frames_(frames_from(progress)) {
  const Scene& scene = simulation.scene();
  has_changing_walls_ = any_wall_changes(scene);
  has_fixed_walls_ = !scene.walls.empty() && !has_changing_walls_;
  const std::int64_t next = progress.integers("outputs/next_frame", 1).front();
  if (next > most_frames ||
      next < (frames_.empty() ? 0 : 1 + static_cast<std::int64_t>(frames_.back().number)))
    throw CheckpointError("'outputs/next_frame' does not follow the frames before.");
  next_ = static_cast<std::size_t>(next);
  std::uintmax_t bytes = 0;
  for (std::size_t k = frames_.size(); k-- > 0;) {
    bytes += frames_[k].soil.bytes + frames_[k].walls.bytes;
    const std::string damage = damage_of(frames_[k], bytes > most_summed);
    if (damage.empty()) continue;
    warnings_.push_back(damage + "; the run goes on without this frame");
    frames_.erase(frames_.begin() + static_cast<std::ptrdiff_t>(k));
  }
  clear_frames(folder_, next_);
  flushed_ = frames_.size();
  if (has_fixed_walls_ && next_ > 0) restore_walls(simulation, progress);
  write_lists();
}

std::vector<FrameWriter::Frame> FrameWriter::frames_from(const Snapshot& progress) {
  const std::vector<double>& times = progress.numbers("outputs/frame_times");
  const std::size_t count = times.size();
  const std::vector<std::int64_t>& numbers = progress.integers("outputs/frame_numbers", count);
  const std::vector<std::int64_t>& marks = progress.integers("outputs/frame_files", 4 * count);
  std::vector<Frame> frames;
  for (std::size_t k = 0; k < count; ++k) {
    const auto mark = [&](std::size_t at) {
      return FileMark{static_cast<std::uintmax_t>(marks[4 * k + at]),
                      static_cast<std::uint32_t>(marks[4 * k + at + 1])};
    };
    const std::int64_t least = k == 0 ? 0 : numbers[k - 1] + 1;
    if (numbers[k] < least || numbers[k] > most_frames || !std::isfinite(times[k]))
      throw CheckpointError("'outputs/frame_numbers' does not count frames.");
    frames.push_back({static_cast<std::size_t>(numbers[k]), times[k], mark(0), mark(2)});
  }
  return frames;
}

std::string FrameWriter::damage_of(const Frame& frame, bool sizes_only) const {
  const auto look = [&](const char* name, const FileMark& mark) {
    const std::filesystem::path path = file_of(name, frame.number);
    const std::string difference = difference_from(path, mark, sizes_only);
    return difference.empty() ? difference : fmt::format("'{}' {}", path.string(), difference);
  };
  const std::string damage = look("soil", frame.soil);
  return damage.empty() && has_changing_walls_ ? look("walls", frame.walls) : damage;
}

/// Walls that rest look the same at any moment.
void FrameWriter::restore_walls(const Simulation& simulation, const Snapshot& progress) {
  fixed_walls_ = mark_from(progress, "outputs/walls_file");
  const std::filesystem::path path = folder_ / "walls.hdf";
  const std::string difference = difference_from(path, fixed_walls_);
  if (difference.empty()) return;
  warnings_.push_back(fmt::format("'{}' {}; it is written again", path.string(), difference));
  write_wall_frame(path, simulation);
  fixed_walls_ = mark_of(path).value_or(FileMark{});
}

std::filesystem::path FrameWriter::file_of(const char* name, std::size_t number) const {
  return folder_ / frame_name(name, number);
}

void FrameWriter::add_progress(Snapshot& snapshot) {
  const auto flushed_mark = [](const std::filesystem::path& path) {
    flush_to_disk(path);
    const std::optional<FileMark> mark = mark_of(path);
    if (!mark) throw FileError(fmt::format("'{}': cannot be read again.", path.string()));
    return *mark;
  };
  for (; flushed_ < frames_.size(); ++flushed_) {
    Frame& frame = frames_[flushed_];
    frame.soil = flushed_mark(file_of("soil", frame.number));
    if (has_changing_walls_) frame.walls = flushed_mark(file_of("walls", frame.number));
    if (has_fixed_walls_ && frame.number == 0) fixed_walls_ = flushed_mark(folder_ / "walls.hdf");
  }
  flush_to_disk(folder_);
  std::vector<double> times;
  std::vector<std::int64_t> numbers, files;
  for (const Frame& frame : frames_) {
    times.push_back(frame.time);
    numbers.push_back(static_cast<std::int64_t>(frame.number));
    for (const FileMark& mark : {frame.soil, frame.walls}) {
      files.push_back(static_cast<std::int64_t>(mark.bytes));
      files.push_back(mark.sum);
    }
  }
  snapshot.add("outputs/frame_times", "s", std::move(times));
  snapshot.add("outputs/frame_numbers", std::move(numbers));
  snapshot.add("outputs/frame_files", std::move(files));
  snapshot.add("outputs/next_frame", std::vector{static_cast<std::int64_t>(next_)});
  if (has_fixed_walls_) add_mark(snapshot, "outputs/walls_file", fixed_walls_);
}

void FrameWriter::write(const Simulation& simulation, std::string_view event) {
  write_soil_frame(file_of("soil", next_), simulation, event);
  if (has_changing_walls_) write_wall_frame(file_of("walls", next_), simulation);
  if (has_fixed_walls_ && next_ == 0) write_wall_frame(folder_ / "walls.hdf", simulation);
  frames_.push_back({next_++, simulation.last_step().time, {}, {}});
  constexpr std::size_t few = 100;
  if (count() <= few || count() >= listed_ + listed_ / 32) write_lists();
}

void FrameWriter::write_lists() {
  if (listed_ == count()) return;
  listed_ = count();
  write_series("soil");
  if (has_changing_walls_) write_series("walls");
}

void FrameWriter::write_series(std::string_view name) const {
  nlohmann::ordered_json series{{"file-series-version", "1.0"},
                                {"files", nlohmann::ordered_json::array()}};
  for (const Frame& frame : frames_) {
    series["files"].push_back({{"name", frame_name(name, frame.number)}, {"time", frame.time}});
  }
  replace_file(folder_ / (std::string(name) + ".hdf.series"), series.dump(1) + "\n");
}

}  // namespace scarp
