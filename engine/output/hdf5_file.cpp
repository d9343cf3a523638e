// SPDX-License-Identifier: BSD-3-Clause
/// Checked calls of the HDF5 C library.

#include "engine/output/hdf5_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <type_traits>

#include "engine/errors.hpp"
#include "engine/output/text_file.hpp"

namespace scarp::hdf5 {
namespace {

template <class T>
std::pair<hid_t, hid_t> memory_and_file_type() {
  if constexpr (std::is_same_v<T, float>) {
    return {H5T_NATIVE_FLOAT, H5T_IEEE_F32LE};
  } else if constexpr (std::is_same_v<T, double>) {
    return {H5T_NATIVE_DOUBLE, H5T_IEEE_F64LE};
  } else if constexpr (std::is_same_v<T, std::int32_t>) {
    return {H5T_NATIVE_INT32, H5T_STD_I32LE};
  } else if constexpr (std::is_same_v<T, std::int64_t>) {
    return {H5T_NATIVE_INT64, H5T_STD_I64LE};
  } else {
    static_assert(std::is_same_v<T, std::uint8_t>);
    return {H5T_NATIVE_UINT8, H5T_STD_U8LE};
  }
}

std::recursive_mutex& library_mutex() {
  static std::recursive_mutex one;
  return one;
}

}  // namespace

std::string last_reason() {
  std::string reason;
  H5Ewalk2(
      H5E_DEFAULT, H5E_WALK_UPWARD,
      [](unsigned n, const H5E_error2_t* entry, void* text) -> herr_t {
        if (n == 0 && entry->desc) *static_cast<std::string*>(text) = entry->desc;
        return 0;
      },
      &reason);
  return reason.empty() ? "no reason given" : reason;
}

QuietErrors::QuietErrors() : turn_(library_mutex()) {
  H5Eget_auto2(H5E_DEFAULT, &print_, &client_data_);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

QuietErrors::~QuietErrors() { H5Eset_auto2(H5E_DEFAULT, print_, client_data_); }

NewFile::NewFile(std::filesystem::path path, Layout layout)
    : path_(std::move(path)), layout_(layout), file_(create_in_memory()) {}

Handle NewFile::create_in_memory() const {
  Handle access = checked(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "its access list");
  constexpr std::size_t growth = 1 << 20;
  check(H5Pset_fapl_core(access.get(), growth, false), "its access list");
  if (layout_ == Layout::summed) {
    check(H5Pset_libver_bounds(access.get(), H5F_LIBVER_V18, H5F_LIBVER_V18), "its version");
  }
  const Handle creation = timeless(H5P_FILE_CREATE, "the root group");
  // HDF5 takes two files of one name for the same.
  const std::string name = fmt::format("in memory at {}", fmt::ptr(this));
  return checked(H5Fcreate(name.c_str(), H5F_ACC_TRUNC, creation.get(), access.get()), H5Fclose,
                 "creating it");
}

void NewFile::group(const std::string& name) {
  const Handle creation = timeless(H5P_GROUP_CREATE, name);
  Handle group =
      checked(H5Gcreate2(file_.get(), name.c_str(), H5P_DEFAULT, creation.get(), H5P_DEFAULT),
              H5Gclose, name);
  check(group.close(), name);
}

/// HDF5 would make them too, but with the time of making.
void NewFile::groups_above(const std::string& name) {
  for (std::size_t end = name.find('/'); end != std::string::npos; end = name.find('/', end + 1)) {
    const std::string above = name.substr(0, end);
    const htri_t there = H5Lexists(file_.get(), above.c_str(), H5P_DEFAULT);
    check(there, above);
    if (there == 0) group(above);
  }
}

template <class T>
void NewFile::dataset(const std::string& name, const std::vector<T>& values, const Shape& shape) {
  std::size_t count = 1;
  for (const hsize_t extent : shape) count *= static_cast<std::size_t>(extent);
  if (count != values.size()) {
    throw FileError(fmt::format("'{}': cannot be written; '{}' has {} values, but a shape for {}.",
                                path_.string(), name, values.size(), count));
  }
  const auto [memory_type, file_type] = memory_and_file_type<T>();
  Handle space = checked(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr),
                         H5Sclose, name);
  groups_above(name);
  const Handle storage = storage_of(shape, values.size() * sizeof(T), name);
  Handle set = checked(H5Dcreate2(file_.get(), name.c_str(), file_type, space.get(), H5P_DEFAULT,
                                  storage.get(), H5P_DEFAULT),
                       H5Dclose, name);
  if (!values.empty()) {
    check(H5Dwrite(set.get(), memory_type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), name);
  }
  check(set.close(), name);  // a full disk may show only here
  check(space.close(), name);
}

template void NewFile::dataset(const std::string&, const std::vector<float>&, const Shape&);
template void NewFile::dataset(const std::string&, const std::vector<double>&, const Shape&);
template void NewFile::dataset(const std::string&, const std::vector<std::int32_t>&, const Shape&);
template void NewFile::dataset(const std::string&, const std::vector<std::int64_t>&, const Shape&);
template void NewFile::dataset(const std::string&, const std::vector<std::uint8_t>&, const Shape&);

void NewFile::attribute(const std::string& object, const char* name, hid_t type,
                        const Handle& space, const void* data) {
  Handle made = checked(H5Acreate_by_name(file_.get(), object.c_str(), name, type, space.get(),
                                          H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                        H5Aclose, name);
  check(H5Awrite(made.get(), type, data), name);
  check(made.close(), name);
}

void NewFile::attribute(const std::string& object, const char* name, std::string_view text) {
  Handle type = checked(H5Tcopy(H5T_C_S1), H5Tclose, name);
  check(H5Tset_size(type.get(), std::max<std::size_t>(text.size(), 1)), name);
  check(H5Tset_strpad(type.get(), H5T_STR_NULLPAD), name);
  const bool ascii = std::all_of(text.begin(), text.end(),
                                 [](char c) { return static_cast<unsigned char>(c) < 128; });
  check(H5Tset_cset(type.get(), ascii ? H5T_CSET_ASCII : H5T_CSET_UTF8), name);
  const std::string data(text.empty() ? std::string_view("\0", 1) : text);
  attribute(object, name, type.get(), checked(H5Screate(H5S_SCALAR), H5Sclose, name), data.data());
}

void NewFile::attribute(const std::string& object, const char* name, double value) {
  attribute(object, name, H5T_NATIVE_DOUBLE, checked(H5Screate(H5S_SCALAR), H5Sclose, name),
            &value);
}

void NewFile::attribute(const std::string& object, const char* name,
                        const std::vector<std::int64_t>& values) {
  const hsize_t count = values.size();
  attribute(object, name, H5T_NATIVE_INT64,
            checked(H5Screate_simple(1, &count, nullptr), H5Sclose, name), values.data());
}

/// Without the time of making, so that equal runs leave equal files.
Handle NewFile::timeless(hid_t object_class, std::string_view name) const {
  Handle creation = checked(H5Pcreate(object_class), H5Pclose, name);
  check(H5Pset_obj_track_times(creation.get(), false), name);
  return creation;
}

Handle NewFile::storage_of(const Shape& shape, std::size_t bytes, std::string_view name) const {
  Handle storage = timeless(H5P_DATASET_CREATE, name);
  if (layout_ == Layout::plain) return storage;
  constexpr std::size_t small = 4096;
  if (bytes <= small) {
    check(H5Pset_layout(storage.get(), H5D_COMPACT), name);
    return storage;
  }
  constexpr hsize_t longest = 65536;
  const hsize_t pieces = (shape.back() + longest - 1) / longest;
  Shape chunk(shape.size(), 1);
  chunk.back() = (shape.back() + pieces - 1) / pieces;  // equal ones: the last is stored in full
  check(H5Pset_chunk(storage.get(), static_cast<int>(chunk.size()), chunk.data()), name);
  check(H5Pset_fletcher32(storage.get()), name);
  return storage;
}

void NewFile::commit() { replace_file(path_, bytes()); }

std::string_view NewFile::bytes() {
  check(H5Fflush(file_.get(), H5F_SCOPE_GLOBAL), "flushing it");
  // Of H5Fget_file_image only the size: it copies, and zeroes bytes where the oldest format has its
  // flags.
  const ssize_t size = H5Fget_file_image(file_.get(), nullptr, 0);
  check(size < 0 ? -1 : 0, "measuring it");
  void* memory = nullptr;
  check(H5Fget_vfd_handle(file_.get(), H5P_DEFAULT, &memory), "finding it in memory");
  return {*static_cast<const char* const*>(memory), static_cast<std::size_t>(size)};
}

Handle NewFile::checked(hid_t id, Handle::Close close, std::string_view what) const {
  if (id < 0) fail(what);
  return {id, close};
}

void NewFile::check(herr_t status, std::string_view what) const {
  if (status < 0) fail(what);
}

void NewFile::fail(std::string_view what) const {
  throw FileError(fmt::format(
      "'{}': cannot be written; {} failed (HDF5: {}). Check that the folder exists and may be "
      "written, and that the disk is not full.",
      path_.string(), what, last_reason()));
}

}  // namespace scarp::hdf5
