// SPDX-License-Identifier: BSD-3-Clause
/// A small scene and a folder of its own for each output test.
#pragma once

#include <gtest/gtest.h>
#include <hdf5.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "engine/scene/scene_reader.hpp"
#include "engine/simulation.hpp"

namespace scarp {

/// 8 x 4 particles of elastic soil on a wall, two short stages.
inline const std::string block_text = R"toml(title = "Block"
dimension = 2
gravity = [0.0, -9.81]
spacing = 0.5
preset = "modern"

[[material]]
name = "rock"
model = "linear_elastic"
density = 2000.0
youngs_modulus = "10 MPa"
poisson_ratio = 0.3

[[body]]
material = "rock"
polygon = [[0, 0], [4, 0], [4, 2], [0, 2]]

[[wall]]
name = "base"
kind = "no_slip"
line = [[-2, 0], [6, 0]]

[[stage]]
name = "first"
duration = 0.04

[[stage]]
name = "second"
duration = 0.04

[[probe]]
name = "corner"
at = [4, 2]

[output]
every = 0.015
)toml";

class OutputTest : public testing::Test {
 protected:
  OutputTest() {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::temp_directory_path() /
              ("scarp_" + std::string(test->name()) + "_" + std::to_string(getpid()));
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  ~OutputTest() override { std::filesystem::remove_all(folder_); }

  static Simulation block() { return Simulation(read_scene_text(block_text, "block.toml")); }

  static std::string text_of(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    EXPECT_TRUE(stream) << path;
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  std::filesystem::path folder_;
};

/// A dataset as doubles, read independently of the writer; its extent goes to `shape`.
inline std::vector<double> dataset(const std::filesystem::path& path, const std::string& name,
                                   std::vector<hsize_t>* shape = nullptr,
                                   H5T_class_t* type = nullptr, std::size_t* bytes = nullptr) {
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  const hid_t set = H5Dopen2(file, name.c_str(), H5P_DEFAULT);
  EXPECT_GE(set, 0) << path << " " << name;
  const hid_t space = H5Dget_space(set), stored = H5Dget_type(set);
  std::vector<hsize_t> extent(static_cast<std::size_t>(H5Sget_simple_extent_ndims(space)));
  H5Sget_simple_extent_dims(space, extent.data(), nullptr);
  std::vector<double> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
  H5Dread(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
  if (shape) *shape = extent;
  if (type) *type = H5Tget_class(stored);
  if (bytes) *bytes = H5Tget_size(stored);
  H5Tclose(stored);
  H5Sclose(space);
  H5Dclose(set);
  H5Fclose(file);
  return values;
}

/// An attribute, text or one number, as text.
inline std::string attribute(const std::filesystem::path& path, const std::string& object,
                             const std::string& name) {
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  const hid_t found = H5Aopen_by_name(file, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT);
  EXPECT_GE(found, 0) << object << " " << name;
  const hid_t type = H5Aget_type(found);
  std::string text;
  if (H5Tget_class(type) == H5T_STRING) {
    text.resize(H5Tget_size(type));
    H5Aread(found, type, text.data());
  } else {
    std::array<double, 8> values{};
    H5Aread(found, H5T_NATIVE_DOUBLE, values.data());
    text = std::to_string(values[0]);
  }
  H5Tclose(type);
  H5Aclose(found);
  H5Fclose(file);
  return text;
}

}  // namespace scarp
