// SPDX-License-Identifier: BSD-3-Clause
/// No byte of a checkpoint can change unnoticed, and what is no checkpoint is told from one.
#include "engine/output/checkpoint_file.hpp"

#include <sys/stat.h>
#include <zlib.h>

#include <chrono>
#include <cstdlib>
#include <functional>
#include <random>
#include <thread>

#include <fmt/format.h>

#include "engine/errors.hpp"
#include "engine/machine.hpp"
#include "tests/engine/output/output_fixture.hpp"

namespace scarp {
namespace {

class CheckpointFileTest : public OutputTest {
 protected:
  CheckpointFileTest() {
    simulation_.step();
    write_checkpoint(path_, simulation_.snapshot());
    bytes_ = text_of(path_);
  }

  /// Why the bytes are refused; empty if they are not.
  std::string refusal(const std::string& bytes) const {
    const std::filesystem::path other = folder_ / "other.h5";
    std::ofstream(other, std::ios::binary) << bytes;
    try {
      read_checkpoint(other);
    } catch (const CheckpointError& error) {
      return error.what();
    }
    return {};
  }
  void expect_refused(const std::string& bytes, const std::string& word) const {
    const std::string why = refusal(bytes);
    EXPECT_NE(why.find(word), std::string::npos) << word << " not in: " << why;
    EXPECT_NE(why.find("other.h5"), std::string::npos) << why;
  }
  /// As if written that way: the right sum behind the bytes.
  static std::string summed(const std::string& image) {
    return image +
           fmt::format("\nscarp checkpoint ends, crc32 {:08x}\n",
                       crc32_z(0, reinterpret_cast<const Bytef*>(image.data()), image.size()));
  }
  std::string image() const { return bytes_.substr(0, bytes_.rfind("\nscarp checkpoint ends")); }

  Simulation simulation_ = block();
  std::filesystem::path path_ = folder_ / "checkpoint.h5";
  std::string bytes_;
};

TEST_F(CheckpointFileTest, GivesBackEveryItemBitForBit) {
  const Snapshot before = simulation_.snapshot(), after = read_checkpoint(path_);
  ASSERT_EQ(before.items().size(), after.items().size());
  for (const SnapshotItem& item : before.items()) {
    const auto same = std::find_if(after.items().begin(), after.items().end(),
                                   [&](const SnapshotItem& one) { return one.name == item.name; });
    ASSERT_NE(same, after.items().end()) << item.name;
    EXPECT_EQ(same->shape, item.shape) << item.name;
    EXPECT_EQ(same->unit, item.unit) << item.name;
    EXPECT_EQ(same->values, item.values) << item.name;
  }
  Simulation resumed(simulation_.scene(), after);
  simulation_.step();
  resumed.step();
  EXPECT_EQ(simulation_.field("position"), resumed.field("position"));
}

#ifndef SCARP_ADDRESS_SANITIZER  // which keeps what is freed
// Each array goes once it is in the file: what is written takes no second copy.
TEST_F(CheckpointFileTest, TakesNoMoreMemoryThanTheState) {
  constexpr std::size_t arrays = 20, values = 1 << 19;  // of 4 MiB
  constexpr double all = arrays * values * sizeof(double);
  Snapshot state;
  for (std::size_t k = 0; k < arrays; ++k)
    state.add(fmt::format("fields/f{}", k), "m",
              std::vector<double>(values, static_cast<double>(k)));
  const double before = resident_memory().peak;
  write_checkpoint(folder_ / "large.h5", std::move(state));
  EXPECT_LT(resident_memory().peak - before, 0.25 * all);
  EXPECT_GT(std::filesystem::file_size(folder_ / "large.h5"), all);
}
#endif

TEST_F(CheckpointFileTest, OpensInAnyReaderOfHdf5) {
  EXPECT_EQ(dataset(path_, "clock/step"), std::vector<double>{1.0});
  EXPECT_EQ(attribute(path_, "/", "format"), "scarp checkpoint");
  EXPECT_EQ(attribute(path_, "fields/velocity", "unit"), "m/s");
}

TEST_F(CheckpointFileTest, EqualStatesLeaveEqualFiles) {
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // HDF5 counts time in seconds
  write_checkpoint(folder_ / "again.h5", simulation_.snapshot());
  EXPECT_EQ(text_of(folder_ / "again.h5"), bytes_);
}

TEST_F(CheckpointFileTest, NoFlippedBitIsAccepted) {
  std::mt19937 random(11);
  std::uniform_int_distribution<std::size_t> any(0, 8 * bytes_.size() - 1);
  const auto flipped = [&](std::size_t bit) {
    std::string bytes = bytes_;
    bytes[bit / 8] = static_cast<char>(bytes[bit / 8] ^ (1 << bit % 8));
    return refusal(bytes).empty();
  };
  int accepted = 0;
  for (int k = 0; k < 400; ++k) accepted += flipped(any(random));
  for (std::size_t bit = 8 * (bytes_.size() - 48); bit < 8 * bytes_.size(); ++bit)
    accepted += flipped(bit);  // the sum itself
  EXPECT_EQ(accepted, 0);
}

TEST_F(CheckpointFileTest, NoTruncatedFileIsAccepted) {
  for (std::size_t size = 1; size < bytes_.size(); size += 1 + size / 7)
    expect_refused(bytes_.substr(0, size), "no complete checkpoint");
  expect_refused(bytes_.substr(0, bytes_.size() - 1), "no complete checkpoint");
  expect_refused(bytes_ + "\n", "no complete checkpoint");
  expect_refused("", "is empty");
}

TEST_F(CheckpointFileTest, AnotherVersionOrFormatIsNamed) {
  const auto changed = [&](const char* name, const auto& write) {
    std::ofstream(folder_ / "edit.h5", std::ios::binary) << image();
    const hid_t file = H5Fopen((folder_ / "edit.h5").c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    const hid_t found = H5Aopen(file, name, H5P_DEFAULT);
    write(found);
    H5Aclose(found);
    H5Fclose(file);
    return summed(text_of(folder_ / "edit.h5"));
  };
  const auto version = [](std::int64_t number) {
    return [number](hid_t found) { H5Awrite(found, H5T_NATIVE_INT64, &number); };
  };
  EXPECT_EQ(refusal(changed("version", version(2))), "");
  expect_refused(changed("version", version(3)), "version 3");
  expect_refused(changed("format",
                         [](hid_t found) {
                           const hid_t type = H5Aget_type(found);
                           std::string other(H5Tget_size(type), 'x');
                           H5Awrite(found, type, other.data());
                           H5Tclose(type);
                         }),
                 "another program");
}

TEST_F(CheckpointFileTest, ForeignFilesAreRefused) {
  const hid_t file =
      H5Fcreate((folder_ / "foreign.h5").c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  H5Fclose(file);
  const std::string foreign = text_of(folder_ / "foreign.h5");
  expect_refused(foreign, "no complete checkpoint");
  expect_refused(summed(foreign), "cannot be read");
  expect_refused(summed("not HDF5 at all"), "cannot be read");
  EXPECT_THROW(read_checkpoint(folder_ / "missing.h5"), CheckpointError);
  EXPECT_THROW(read_checkpoint(folder_), CheckpointError);
}

/// With something more in it than scarp would write.
class TamperedCheckpointTest : public CheckpointFileTest {
 protected:
  std::string edited(const std::function<void(hid_t)>& edit) const {
    std::ofstream(folder_ / "edit.h5", std::ios::binary) << image();
    const hid_t file = H5Fopen((folder_ / "edit.h5").c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    edit(file);
    H5Fclose(file);
    return summed(text_of(folder_ / "edit.h5"));
  }
  /// With one more dataset.
  std::string with_set(hid_t type, const std::vector<hsize_t>& extent,
                       const std::function<void(hid_t)>& storage = {}) const {
    return edited([&](hid_t file) {
      const hid_t space = H5Screate_simple(static_cast<int>(extent.size()), extent.data(), nullptr);
      const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
      const std::vector<hsize_t> chunk(extent.size(), 16);
      if (storage) {
        storage(creation);
      } else {
        H5Pset_chunk(creation, static_cast<int>(chunk.size()), chunk.data());
      }
      const hid_t set = H5Dcreate2(file, "zz", type, space, H5P_DEFAULT, creation, H5P_DEFAULT);
      EXPECT_GE(set, 0);
      H5Dclose(set);
      H5Pclose(creation);
      H5Sclose(space);
    });
  }
};

TEST_F(TamperedCheckpointTest, NoMoreIsReadThanTheFileHasBytes) {
  const hsize_t large = hsize_t{1} << 40, larger = hsize_t{1} << 33;
  EXPECT_EQ(refusal(with_set(H5T_NATIVE_DOUBLE, {16})), "");
  expect_refused(with_set(H5T_NATIVE_DOUBLE, {large}), "room for");
  expect_refused(with_set(H5T_NATIVE_INT64, {large}), "room for");
  expect_refused(with_set(H5T_NATIVE_UINT8, {large}), "room for");
  expect_refused(with_set(H5T_NATIVE_DOUBLE, {larger, larger}), "room for");  // over 64 bits
  expect_refused(with_set(H5T_NATIVE_DOUBLE, {bytes_.size() / 8}),
                 "room for");  // beside the others
  EXPECT_EQ(refusal(with_set(H5T_NATIVE_DOUBLE, {0})), "");
}

TEST_F(TamperedCheckpointTest, NothingIsReadFromElsewhereOrUnpacked) {
  const std::string pipe = folder_ / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const std::vector<hsize_t> extent{100}, chunk{16};
  expect_refused(with_set(H5T_NATIVE_DOUBLE, extent,
                          [&](hid_t set) { H5Pset_external(set, pipe.c_str(), 0, 800); }),
                 "not stored as scarp");
  expect_refused(with_set(H5T_NATIVE_DOUBLE, extent,
                          [&](hid_t set) {
                            H5Pset_chunk(set, 1, chunk.data());
                            H5Pset_deflate(set, 9);
                          }),
                 "not stored as scarp");
  expect_refused(with_set(H5T_NATIVE_DOUBLE, extent,
                          [&](hid_t set) {
                            const hid_t all = H5Screate_simple(1, extent.data(), nullptr);
                            H5Pset_virtual(set, all, pipe.c_str(), "zz", all);
                            H5Sclose(all);
                          }),
                 "not stored as scarp");
}

TEST_F(TamperedCheckpointTest, OtherTypesAreRefused) {
  expect_refused(with_set(H5T_C_S1, {16}), "zz");
  const hid_t pair = H5Tcreate(H5T_COMPOUND, 16);
  H5Tinsert(pair, "a", 0, H5T_NATIVE_DOUBLE);
  H5Tinsert(pair, "b", 8, H5T_NATIVE_DOUBLE);
  expect_refused(with_set(pair, {16}), "zz");
  H5Tclose(pair);
  const auto with_attribute = [this](const char* name, hid_t type, hsize_t count) {
    return edited([&](hid_t file) {
      H5Adelete(file, name);
      const hid_t space = H5Screate_simple(1, &count, nullptr);
      const hid_t made = H5Acreate2(file, name, type, space, H5P_DEFAULT, H5P_DEFAULT);
      EXPECT_GE(made, 0);
      H5Aclose(made);
      H5Sclose(space);
    });
  };
  const hid_t word = H5Tcopy(H5T_C_S1), any_length = H5Tcopy(H5T_C_S1);
  H5Tset_size(word, 16);
  H5Tset_size(any_length, H5T_VARIABLE);
  expect_refused(with_attribute("version", H5T_NATIVE_INT64, 2), "version");
  expect_refused(with_attribute("version", H5T_NATIVE_DOUBLE, 1), "version");
  expect_refused(with_attribute("format", word, 3), "text");
  expect_refused(with_attribute("format", any_length, 1), "text");
  expect_refused(with_attribute("format", H5T_NATIVE_INT64, 1), "text");
  H5Tclose(word);
  H5Tclose(any_length);
}

TEST_F(TamperedCheckpointTest, WhatIsNoFileIsNotOpened) {
  const std::filesystem::path pipe = folder_ / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  std::filesystem::create_symlink(pipe, folder_ / "link");
  std::filesystem::create_symlink("/dev/zero", folder_ / "zeros");
  std::filesystem::create_directory(folder_ / "folder");
  for (const char* name : {"pipe", "link", "zeros", "folder"}) {
    try {
      read_checkpoint(folder_ / name);
      ADD_FAILURE() << name;
    } catch (const CheckpointError& error) {
      EXPECT_NE(std::string(error.what()).find("pipe or device"), std::string::npos) << name;
    }
  }
}

TEST_F(CheckpointFileTest, AFailedWriteLeavesTheFileBefore) {
  EXPECT_THROW(write_checkpoint(folder_ / "nowhere" / "a.h5", simulation_.snapshot()), FileError);
  std::filesystem::create_directory(folder_ / "checkpoint.h5.part");  // in the way
  EXPECT_THROW(write_checkpoint(path_, simulation_.snapshot()), FileError);
  EXPECT_EQ(text_of(path_), bytes_);
}

}  // namespace
}  // namespace scarp
