// SPDX-License-Identifier: BSD-3-Clause
/// The parts of a scene, each read by a file of its own. Private to the reader.
#pragma once

#include "engine/scene/scene.hpp"
#include "engine/scene/toml_value.hpp"

namespace scarp::input {

/// Where a scene may write 0 for what is chosen by itself.
inline std::optional<double> unless_zero(double value) {
  return value != 0.0 ? std::optional(value) : std::nullopt;
}

/// Rows of [numerics] on top of the preset.
void read_numerics(const Value& section, Numerics& numerics);
/// `scene` has its dimension and gravity.
Material read_material(const Value& item, const Scene& scene);
/// `materials`: their names, in order.
Body read_body(const Value& item, int dimension, const std::vector<std::string>& materials);
inline constexpr std::string_view wall_shapes[] = {"line", "rectangle", "plane", "box"};
Wall read_wall(const Value& item, int dimension);
void read_initial(const Value& section, Scene& scene);
std::vector<Stage> read_stages(const std::vector<Value>& items);
Probe read_probe(const Value& item, int dimension);
Output read_output(const Value& section);
Checkpoints read_checkpoints(const Value& section);
/// Of [run].
int read_retries(const Value& section);

/// Two components in 2D, three in 3D; the third is 0 in 2D.
Vec3 read_vector(const Value& value, kernels::Unit unit, int dimension);
Box read_box(const Table& table, int dimension);
/// [[a, b], [a, b], ...] with at least `least` pairs [m].
std::vector<std::array<double, 2>> read_pairs(const Value& value, std::size_t least);
/// Outline of `slope = {toe, height, ratio, ...}`.
std::vector<std::array<double, 2>> slope_outline(const Value& value);

}  // namespace scarp::input
