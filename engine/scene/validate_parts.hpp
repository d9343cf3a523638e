// SPDX-License-Identifier: BSD-3-Clause
/// Rules about shapes, and the small checks all rules are made of. Private to `validate`.
#pragma once

#include <string>

#include "engine/scene/scene.hpp"

namespace scarp::checks {

inline constexpr double largest_length = 1e9;  ///< of a scene [m]

// Each throws SceneProblem naming `path` when it does not hold.
void rule(bool holds, const std::string& path, const std::string& value, const std::string& why);
/// Finite and minimum <= value <= maximum.
void inside(double value, double minimum, double maximum, const std::string& path);
/// Finite and 0 < value <= maximum.
void positive(double value, double maximum, const std::string& path);
/// The same for radians, with a message in degrees.
void inside_degrees(double value, double minimum, double maximum, const std::string& path);
/// Components finite, at most `largest` in size, and no z in 2D.
void vector(const Vec3& value, int dimension, double largest, const std::string& path);
/// Components finite and no longer than any length may be.
void point(const std::array<double, 2>& p, const std::string& path);
void ordered(double low, double high, const std::string& path);
/// Can be read, and is finite at `places`; values elsewhere are checked where they are used.
void formula(const std::string& text, const std::string& variables, const std::vector<Vec3>& places,
             const std::string& key);
/// One of the enumerators; `last` is that with the highest number.
void choice(double number, double last, const std::string& path);
template <class Choice>
void choice(Choice value, Choice last, const std::string& path) {
  choice(static_cast<double>(value), static_cast<double>(last), path);
}
void body(const Scene& scene, std::size_t index, const std::string& path);
void wall(const Wall& wall, int dimension, const std::string& path);

/// Every choice is one of its words: a scene made in code may hold any number.
void choices(const Scene& scene);

}  // namespace scarp::checks
