// SPDX-License-Identifier: BSD-3-Clause
/// Datasets and attributes of a file image.
#include "engine/output/hdf5_reader.hpp"

#include <fmt/format.h>

#include "engine/errors.hpp"

namespace scarp::hdf5 {
namespace {

void check(herr_t status, std::string_view what) {
  if (status < 0) throw FileError(fmt::format("{} cannot be read (HDF5: {})", what, last_reason()));
}

Handle checked(hid_t id, Handle::Close close, std::string_view what) {
  check(id < 0 ? -1 : 0, what);
  return {id, close};
}

Handle opened(const std::string& image) {
  Handle access = checked(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "its access list");
  constexpr std::size_t growth = 1 << 20;
  check(H5Pset_fapl_core(access.get(), growth, false), "its access list");
  check(H5Pset_file_image(access.get(), const_cast<char*>(image.data()), image.size()),
        "its image");
  return checked(H5Fopen("in memory", H5F_ACC_RDONLY, access.get()), H5Fclose, "the file");
}

/// Data kept elsewhere, or packed so that few bytes become many, are none of ours.
void require_plain_storage(hid_t set, const std::string& name) {
  const Handle storage = checked(H5Dget_create_plist(set), H5Pclose, name);
  bool plain =
      H5Pget_layout(storage.get()) != H5D_VIRTUAL && H5Pget_external_count(storage.get()) == 0;
  for (int k = 0; plain && k < H5Pget_nfilters(storage.get()); ++k) {
    unsigned flags = 0;
    std::size_t count = 0;
    plain = H5Pget_filter2(storage.get(), static_cast<unsigned>(k), &flags, &count, nullptr, 0,
                           nullptr, nullptr) == H5Z_FILTER_FLETCHER32;
  }
  if (!plain) throw FileError(fmt::format("'{}' is not stored as scarp stores it.", name));
}

}  // namespace

StoredFile::StoredFile(const std::string& image)
    : image_bytes_(image.size()), file_(opened(image)) {}

std::string StoredFile::text_attribute(const char* name) const {
  const Handle found = checked(H5Aopen(file_.get(), name, H5P_DEFAULT), H5Aclose, name);
  return text_of(found.get());
}

std::string StoredFile::text_of(hid_t attribute) const {
  const Handle type = checked(H5Aget_type(attribute), H5Tclose, "an attribute");
  check(H5Tget_class(type.get()) == H5T_STRING && H5Tis_variable_str(type.get()) == 0 ? 0 : -1,
        "a text");
  const Handle space = checked(H5Aget_space(attribute), H5Sclose, "an attribute");
  check(H5Sget_simple_extent_npoints(space.get()) == 1 ? 0 : -1, "a text");
  check(H5Tget_size(type.get()) <= image_bytes_ ? 0 : -1, "a text");
  std::string text(H5Tget_size(type.get()), '\0');
  check(H5Aread(attribute, type.get(), text.data()), "a text");
  return text.substr(0, text.find('\0'));
}

std::int64_t StoredFile::integer_attribute(const char* name) const {
  const Handle found = checked(H5Aopen(file_.get(), name, H5P_DEFAULT), H5Aclose, name);
  const Handle space = checked(H5Aget_space(found.get()), H5Sclose, name);
  const Handle type = checked(H5Aget_type(found.get()), H5Tclose, name);
  const bool one =
      H5Sget_simple_extent_npoints(space.get()) == 1 && H5Tget_class(type.get()) == H5T_INTEGER;
  check(one ? 0 : -1, name);
  std::int64_t value = 0;
  check(H5Aread(found.get(), H5T_NATIVE_INT64, &value), name);
  return value;
}

std::vector<SnapshotItem> StoredFile::items() const {
  std::vector<std::string> names;
  check(H5Ovisit2(
            file_.get(), H5_INDEX_NAME, H5_ITER_INC,
            [](hid_t, const char* name, const H5O_info_t* info, void* out) -> herr_t {
              if (info->type == H5O_TYPE_DATASET)
                static_cast<std::vector<std::string>*>(out)->emplace_back(name);
              return 0;
            },
            &names, H5O_INFO_BASIC),
        "the list of datasets");
  std::vector<SnapshotItem> found;
  std::size_t left = image_bytes_;
  for (const std::string& name : names) found.push_back(item(name, left));
  return found;
}

SnapshotItem StoredFile::item(const std::string& name, std::size_t& left) const {
  const Handle set = checked(H5Dopen2(file_.get(), name.c_str(), H5P_DEFAULT), H5Dclose, name);
  const Handle space = checked(H5Dget_space(set.get()), H5Sclose, name);
  const Handle type = checked(H5Dget_type(set.get()), H5Tclose, name);
  const int rank = H5Sget_simple_extent_ndims(space.get());
  check(rank, name);
  require_plain_storage(set.get(), name);
  std::vector<hsize_t> extent(static_cast<std::size_t>(rank));
  check(H5Sget_simple_extent_dims(space.get(), extent.data(), nullptr), name);
  SnapshotItem item{name, "", {extent.begin(), extent.end()}, {}};
  const H5T_class_t kind = H5Tget_class(type.get());
  const bool byte = kind == H5T_INTEGER && H5Tget_size(type.get()) == 1;
  const std::size_t most = left / (byte ? 1 : sizeof(double));
  std::size_t count = 1;
  for (const std::size_t n : item.shape) {
    if (n > 0 && count > most / n) {
      throw FileError(
          fmt::format("'{}' claims to hold more values than the file has room for", name));
    }
    count *= n;
  }
  left -= count * (byte ? 1 : sizeof(double));
  const auto read = [&](hid_t memory_type, auto values) {
    values.resize(count);
    if (count > 0)
      check(H5Dread(set.get(), memory_type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), name);
    item.values = std::move(values);
  };
  if (kind == H5T_FLOAT) {
    read(H5T_NATIVE_DOUBLE, std::vector<double>{});
  } else if (byte) {
    read(H5T_NATIVE_UINT8, std::string{});
  } else {
    check(kind == H5T_INTEGER ? 0 : -1, name);
    read(H5T_NATIVE_INT64, std::vector<std::int64_t>{});
  }
  if (H5Aexists(set.get(), "unit") > 0) {
    const Handle unit = checked(H5Aopen(set.get(), "unit", H5P_DEFAULT), H5Aclose, name);
    item.unit = text_of(unit.get());
  }
  return item;
}

}  // namespace scarp::hdf5
