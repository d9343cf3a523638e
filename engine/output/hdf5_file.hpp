// SPDX-License-Identifier: BSD-3-Clause
/// A new HDF5 file, written beside its final name and renamed once complete. Private to
/// `engine/output`.
#pragma once

#include <hdf5.h>

#include <cstdint>
#include <filesystem>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace scarp::hdf5 {

/// Owns one HDF5 identifier; `close()` reports what the destructor could not.
class Handle {
 public:
  using Close = herr_t (*)(hid_t);
  Handle(hid_t id, Close close_function) : id_(id), close_(close_function) {}
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Handle& operator=(Handle&&) = delete;
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  hid_t get() const { return id_; }
  herr_t close() { return id_ >= 0 ? close_(std::exchange(id_, -1)) : 0; }

 private:
  hid_t id_;
  Close close_;
};

/// The turn to use HDF5, whose library is one for the whole process and, as built by default, not
/// safe in two threads at once; and keeps it from printing: errors are thrown instead. First member
/// of whatever calls HDF5. A program that uses HDF5 itself sees to its own calls.
class QuietErrors {
 public:
  QuietErrors();
  QuietErrors(const QuietErrors&) = delete;
  QuietErrors& operator=(const QuietErrors&) = delete;
  ~QuietErrors();

 private:
  std::lock_guard<std::recursive_mutex> turn_;
  H5E_auto2_t print_ = nullptr;
  void* client_data_ = nullptr;
};

/// HDF5's own words for the last failure: the innermost entry of its error stack.
std::string last_reason();

/// `plain`: contiguous data in the oldest format, which every reader takes. `summed`: checksums
/// over metadata (format of HDF5 1.8; later ones mark a file in memory as open) and data
/// (fletcher32, small sets as part of the metadata).
enum class Layout { plain, summed };

/// Built in memory; PATH appears, complete, with `commit()`. Without it nothing stays behind. In
/// memory, because HDF5 keeps a file it could not write open, and crashes on it when the program
/// ends. Errors: every member throws FileError, naming the file and HDF5's reason.
class NewFile {
 public:
  using Shape = std::vector<hsize_t>;

  explicit NewFile(std::filesystem::path path, Layout layout = Layout::plain);
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;

  void group(const std::string& name);
  /// T: float, double, std::int32_t, std::int64_t, std::uint8_t; `values` fill `shape` row by row.
  template <class T>
  void dataset(const std::string& name, const std::vector<T>& values, const Shape& shape);
  template <class T>
  void dataset(const std::string& name, const std::vector<T>& values) {
    dataset(name, values, {values.size()});
  }
  void attribute(const std::string& object, const char* name, std::string_view text);
  void attribute(const std::string& object, const char* name, double value);
  void attribute(const std::string& object, const char* name,
                 const std::vector<std::int64_t>& values);
  void commit();
  /// The whole file as it is now, until something is added or the object goes.
  std::string_view bytes();

 private:
  void attribute(const std::string& object, const char* name, hid_t type, const Handle& space,
                 const void* data);
  Handle create_in_memory() const;
  void groups_above(const std::string& name);
  Handle timeless(hid_t object_class, std::string_view name) const;
  Handle storage_of(const Shape& shape, std::size_t bytes, std::string_view name) const;
  Handle checked(hid_t id, Handle::Close close, std::string_view what) const;
  void check(herr_t status, std::string_view what) const;
  [[noreturn]] void fail(std::string_view what) const;

  QuietErrors quiet_;
  std::filesystem::path path_;
  Layout layout_;
  Handle file_;
};

}  // namespace scarp::hdf5
