// SPDX-License-Identifier: BSD-3-Clause
/// Points of an axis become cells.
#include "validation/stability/cell_axes.hpp"

#include <algorithm>

#include "validation/stability/scenes.hpp"

namespace scarp::validation {

void CellAxes::axis(const Axis& axis, const std::vector<CellPoint>& points) {
  for (const CellPoint& point : points) {
    if (short_ && !point.in_short) continue;
    for (const char* name : {"modern", "paper"}) add(axis, point, name, Precision::real64);
    if (axis.mixed) add(axis, point, "modern", Precision::mixed);
  }
}

void CellAxes::add(const Axis& axis, const CellPoint& point, const std::string& preset_name,
                   Precision precision) {
  Cell cell{axis.group, axis.name, point.value, axis.base(preset_name)};
  cell.bisect = axis.bisect;
  cell.scene.numerics.precision = precision;
  point.change(cell);
  if (axis.settle > 0.0) set_stages(cell.scene, axis.settle);
  cell.stands = axis.stands && can_stand(cell.scene);
  if (cell.stands) settle_fully(cell.scene);
  const std::uint64_t most_steps = cell.scene.dimension == 3 ? 1000 : 5000;
  if (short_) cell.steps = std::min<std::uint64_t>(cell.steps / 4, most_steps);
  cells_.push_back(std::move(cell));
}

CellChange material(const Material& m) {
  return [m](Cell& cell) { cell.scene.materials[0] = m; };
}

CellChange finer(double factor) {
  return [factor](Cell& cell) {
    cell.scene.spacing /= factor;
    cell.steps = 200000;
  };
}

}  // namespace scarp::validation
