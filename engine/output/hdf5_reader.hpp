// SPDX-License-Identifier: BSD-3-Clause
/// An HDF5 file that is already in memory. Private to `engine/output`.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/checkpoint/snapshot.hpp"
#include "engine/output/hdf5_file.hpp"

namespace scarp::hdf5 {

/// Errors: every member throws FileError with HDF5's reason. Nothing is believed that would take
/// more memory than the file has bytes, or that lies outside of it.
class StoredFile {
 public:
  /// `image` must outlive it.
  explicit StoredFile(const std::string& image);
  StoredFile(const StoredFile&) = delete;
  StoredFile& operator=(const StoredFile&) = delete;

  /// Of the root group.
  std::string text_attribute(const char* name) const;
  std::int64_t integer_attribute(const char* name) const;
  /// Every dataset of the file: floating point as doubles, bytes as text, other integers as 64
  /// bits.
  std::vector<SnapshotItem> items() const;

 private:
  /// `left`: bytes that the items to come may take, less what this one takes.
  SnapshotItem item(const std::string& name, std::size_t& left) const;
  std::string text_of(hid_t attribute) const;

  QuietErrors quiet_;
  std::size_t image_bytes_;
  Handle file_;
};

}  // namespace scarp::hdf5
