// SPDX-License-Identifier: BSD-3-Clause
/// Measures of a deposit: its surface by columns, its front, and its distance from a published one.
#pragma once

#include <filesystem>
#include <vector>

namespace scarp::validation {

/// Height over a horizontal distance, linear between the points; constant before the first, 0
/// beyond the last.
struct Profile {
  std::vector<double> x;       ///< increasing [m]
  std::vector<double> height;  ///< [m]
};

/// Soil in columns of `width` from x = 0 on, each particle holding spacing^2 spread evenly over one
/// spacing; the area under the profile is that of the particles. Height without pores: loose grains
/// count by their volume. x of the particles, all in [m].
Profile column_profile(const std::vector<double>& x, double spacing, double width);

/// Height of a profile [m]; 0 for one without points.
double height_at(const Profile& profile, double x);

/// Integral of |a - b| over x >= 0 [m2].
double area_between(const Profile& a, const Profile& b);

/// Mean distance of the points of one profile from the line of another [m]; NaN if either is empty.
double mean_distance(const Profile& points, const Profile& line);

/// A table with a header line and two columns, x and height [m]. Errors: FileError.
Profile read_profile(const std::filesystem::path& path);

/// The same table, as `read_profile` reads it. Errors: FileError.
void write_profile(const std::filesystem::path& path, const Profile& profile);

/// Where a deposit stops to be one grain high: the first distance from its middle at which the soil
/// no longer has the depth of a closed layer of `grain`, in columns of four spacings, linear
/// between them; all in [m]. In 3D `distances` are from the axis of a quarter of a round deposit,
/// and columns are rings of it. 0 without such soil.
double closed_front(const std::vector<double>& distances, int dimension, double spacing,
                    double grain);

/// The value that `share` of the values does not exceed; NaN for none.
double quantile(std::vector<double> values, double share);

/// Indices of the particles of the deposit itself: the largest set held together by gaps shorter
/// than `reach` [m]. Loose grains ahead of it are left out, as experimenters do. `position`: x, y,
/// z of each [m].
std::vector<std::size_t> main_body(const std::vector<double>& position, double reach);

/// Share of the particles more than a spacing below the base or behind the symmetry planes at 0
/// (2D: x and y; 3D: x, y and z). A lone grain may sit up to half a spacing deep in a wall, where
/// the wall's first layer of particles stops it.
double share_through_walls(const std::vector<double>& position, int dimension, double spacing);

}  // namespace scarp::validation
