// SPDX-License-Identifier: BSD-3-Clause
/// One factor changed at a time, in both presets.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "validation/stability/cells.hpp"

namespace scarp::validation {

using CellChange = std::function<void(Cell&)>;
using CellBase = std::function<Scene(const std::string&)>;

/// One value of an axis.
struct CellPoint {
  std::string value;
  CellChange change;
  bool in_short = false;
};

class CellAxes {
 public:
  explicit CellAxes(bool short_form) : short_(short_form) {}

  struct Axis {
    std::string group, name;
    CellBase base;
    bool bisect = false;
    double settle = 300.0;  ///< passages; 0: the scene's own stages
    bool mixed = false;     ///< with mixed precision too
    bool stands = false;    ///< nothing should move without damping
  };

  /// Adds the cells of both presets at every point.
  void axis(const Axis& axis, const std::vector<CellPoint>& points);

  std::vector<Cell> take() { return std::move(cells_); }

 private:
  void add(const Axis& axis, const CellPoint& point, const std::string& preset_name,
           Precision precision);

  bool short_;
  std::vector<Cell> cells_;
};

/// Another material for all soil.
CellChange material(const Material& m);
/// A spacing so many times finer, run to the end of its stages.
CellChange finer(double factor);

/// A slope, refined `factor` times, settles and slides for 5 s at a strength reduction of 1.5.
void let_slide(Cell& cell, double factor);

void add_shape(CellAxes& axes);
void add_scale(CellAxes& axes);
/// After failure, under refinement.
void add_noise(CellAxes& axes);
void add_3d(CellAxes& axes);

}  // namespace scarp::validation
