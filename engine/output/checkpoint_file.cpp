// SPDX-License-Identifier: BSD-3-Clause
/// Checkpoints: HDF5 in memory, its sum behind it.
#include "engine/output/checkpoint_file.hpp"

#include <zlib.h>

#include <array>
#include <fstream>
#include <new>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "engine/errors.hpp"
#include "engine/machine.hpp"
#include "engine/output/hdf5_file.hpp"
#include "engine/output/hdf5_reader.hpp"
#include "engine/output/results.hpp"
#include "engine/output/text_file.hpp"

namespace scarp {
namespace {

constexpr const char* format_name = "scarp checkpoint";
constexpr std::int64_t format_version = 2;

/// The last line of a file. HDF5 readers take no notice of what follows the end of their data.
std::string ending(std::string_view image) {
  return fmt::format("\nscarp checkpoint ends, crc32 {:08x}\n",
                     crc32_z(0, reinterpret_cast<const Bytef*>(image.data()), image.size()));
}

[[noreturn]] void refuse(const std::filesystem::path& path, std::string_view why) {
  throw CheckpointError(fmt::format("'{}': {}", path.string(), why));
}

std::string checked_image(const std::filesystem::path& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
    refuse(path, "is no file but a folder, pipe or device. Try the checkpoint before it.");
  }
  std::ifstream stream(path, std::ios::binary);
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (!stream || error) refuse(path, "cannot be read. Try to check its name and rights.");
  if (size == 0) refuse(path, "is empty. Try the checkpoint before it.");
  if (static_cast<double>(size) > usable_memory())
    refuse(path, "is larger than the memory this process may use. Try the checkpoint before it.");
  std::string image(size, '\0');
  stream.read(image.data(), static_cast<std::streamsize>(size));
  if (!stream) refuse(path, "cannot be read to its end. Try the checkpoint before it.");
  const std::size_t length = ending("").size();
  const std::size_t kept = image.size() < length ? 0 : image.size() - length;
  const std::string stated = image.substr(kept);
  image.resize(kept);
  const std::string sum = ending(image);
  if (stated == sum) return image;
  constexpr std::size_t digits = 9;  // and the end of the line
  const bool marked = stated.size() == length &&
                      stated.substr(0, length - digits) == sum.substr(0, length - digits);
  refuse(path, marked ? "is damaged: its bytes do not have the sum written with them. Try the "
                        "checkpoint before it."
                      : "is no complete checkpoint: cut short, damaged, or a file of another "
                        "program. Try the checkpoint before it.");
}

void write_item(hdf5::NewFile& file, const SnapshotItem& item) {
  const hdf5::NewFile::Shape shape(item.shape.begin(), item.shape.end());
  if (const auto* numbers = std::get_if<std::vector<double>>(&item.values)) {
    file.dataset(item.name, *numbers, shape);
  } else if (const auto* integers = std::get_if<std::vector<std::int64_t>>(&item.values)) {
    file.dataset(item.name, *integers, shape);
  } else {
    const auto& text = std::get<std::string>(item.values);
    file.dataset(item.name, std::vector<std::uint8_t>(text.begin(), text.end()), shape);
  }
  if (!item.unit.empty()) file.attribute(item.name, "unit", item.unit);
}

/// Lets go of each item that is in the file.
void fill(hdf5::NewFile& file, Snapshot snapshot) {
  file.attribute("/", "format", format_name);
  file.attribute("/", "version", std::vector<std::int64_t>{format_version});
  file.attribute("/", "program", "scarp " + program_version());
  for (SnapshotItem& item : snapshot.release()) {
    const SnapshotItem last = std::move(item);
    write_item(file, last);
  }
}

}  // namespace

void write_checkpoint(const std::filesystem::path& path, Snapshot snapshot) {
  hdf5::NewFile file(path, hdf5::Layout::summed);
  fill(file, std::move(snapshot));
  const std::string_view image = file.bytes();
  replace_file_durably(path, std::array<std::string_view, 2>{image, ending(image)});
}

std::size_t checkpoint_bytes(Snapshot snapshot) {
  hdf5::NewFile file("a checkpoint", hdf5::Layout::summed);
  fill(file, std::move(snapshot));
  const std::string_view image = file.bytes();
  return image.size() + ending(image).size();
}

Snapshot read_checkpoint(const std::filesystem::path& path) {
  try {
    const std::string image = checked_image(path);
    const hdf5::StoredFile file(image);
    if (file.text_attribute("format") != format_name)
      refuse(path, "is a file of another program. Try a checkpoint of scarp.");
    const std::int64_t version = file.integer_attribute("version");
    if (version != format_version) {
      refuse(path, fmt::format("has version {} of the format, written by {}; this program reads "
                               "version {}. Try the program that wrote it.",
                               version, file.text_attribute("program"), format_version));
    }
    Snapshot snapshot;
    for (SnapshotItem& item : file.items()) snapshot.add(std::move(item));
    return snapshot;
  } catch (const FileError& error) {
    refuse(path, error.what());
  } catch (const std::bad_alloc&) {
    refuse(path, "does not fit into memory. Try to free some, or the checkpoint before it.");
  }
}

}  // namespace scarp
