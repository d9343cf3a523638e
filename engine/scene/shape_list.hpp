// SPDX-License-Identifier: BSD-3-Clause
/// The one list of the shapes of bodies: reader, checks, lattice fill, warnings and scene text
/// follow from its rows.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/scene/scene.hpp"

namespace scarp {

namespace input {
class Table;
class Value;
}  // namespace input
class TextLines;

struct Range {
  double low = 0.0;
  double high = 0.0;
};

/// Lowest and highest corner of the box around a shape [m].
struct ShapeExtent {
  Vec3 minimum{}, maximum{};
};

/// Appends the ranges inside the shape along a line parallel to an axis, through a point that is in
/// the shape's extent across it; in any order, overlaps allowed. Points within a tolerance of the
/// surface are inside. Errors: SceneError where a height cannot be found.
using ShapeCut = std::function<void(std::size_t axis, const Vec3& at, std::vector<Range>& out)>;

/// A key beside that of a shape, and why it may not stand elsewhere.
struct CompanionKey {
  std::string_view key;
  std::string_view misplaced;
};

/// Another key of [[body]] that makes a shape of the same kind, in other words.
struct OtherForm {
  std::string_view key{};
  Body::Shape (*read)(const input::Table& body, const input::Value& value, int dimension) = nullptr;
};

/// What the engine asks of one kind of shape, an alternative of `Body::shape`; each row is in the
/// file of its shape, `engine/scene/shapes/`. Functions take a shape of their own kind.
struct ShapeRow {
  std::string_view key;  ///< in [[body]]
  CompanionKey companion;
  /// Errors: SceneError with the line of what is wrong.
  Body::Shape (*read)(const input::Table& body, const input::Value& value, int dimension);
  /// The rules it keeps, made in code or read. Errors: SceneProblem.
  void (*check)(const Body::Shape& shape, int dimension, const std::string& path);
  /// Every value on a line of its own.
  void (*write)(const Body::Shape& shape, TextLines& lines);
  /// "disc from (0, 0) to (1, 1)".
  std::string (*describe)(const Body::Shape& shape, int dimension);
  /// A height that an expression gives is not known here and counts as 0.
  ShapeExtent (*extent)(const Body::Shape& shape, int dimension);
  /// `label` begins messages; the shape must outlive the cut.
  ShapeCut (*cut)(const Body::Shape& shape, int dimension, double tolerance,
                  const std::string& label);
  bool only_vertical;  ///< cuts are known along the vertical axis alone, and so is its top
  bool round;          ///< in plan, and in 2D altogether: both ends of its sites belong to it
  /// Appends the places along an axis where its outline turns.
  void (*corners)(const Body::Shape& shape, int dimension, std::size_t axis,
                  std::vector<double>& out);
  /// What a cut takes, in edges looked at.
  double (*cost)(const Body::Shape& shape);
  OtherForm other{};
  /// Heights of its sites along the vertical axis; null: as its cut has them. `ColumnShape` says
  /// whose sites on faces are.
  ShapeCut (*sites)(const Body::Shape& shape, double tolerance) = nullptr;
};

extern const ShapeRow polygon_row, box_row, cylinder_row, height_field_row;

/// In the order of the alternatives of `Body::shape`.
std::span<const ShapeRow* const> shape_list();
/// Pre: the shape has a value.
const ShapeRow& row_of(const Body::Shape& shape);

/// "box from (0, 0) to (1, 1)".
std::string from_to(std::string_view noun, const ShapeExtent& extent, int dimension);

inline bool within(double value, double low, double high) { return value >= low && value <= high; }

}  // namespace scarp
