// SPDX-License-Identifier: BSD-3-Clause
/// Every way in which the walls of a basin can meet, as small scenes.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "engine/boundary/facet_geometry.hpp"
#include "tests/support/small_scenes.hpp"

namespace scarp::test {

/// A basin of soil: base, left and right side. Lengths in spacings unless said.
struct Meeting {
  WallKind base = WallKind::no_slip, left = WallKind::no_slip, right = WallKind::no_slip;
  double base_beyond = 0.0;    ///< the base goes on beyond both sides; negative: a gap
  double side_beyond = 0.0;    ///< the sides go on below the base; negative: a gap
  double angle = 90.0;         ///< between base and left side, on the soil's side [deg]
  double offset = 0.0;         ///< of sides and base against the lattice of the soil
  double split_overlap = 9.0;  ///< the base is drawn in two that overlap so much; 9: in one
  WallKind second = WallKind::no_slip;  ///< of the right half of a base in two
  bool one_wall = false;                ///< faces of one kind in one wall
  bool swapped = false;                 ///< order of the walls
  bool sand = false;                    ///< without cohesion
  bool plate = false;                   ///< a plate goes down between the sides
  WallKind plate_kind = WallKind::no_slip;
  double plate_beyond = 0.0;  ///< the plate overshoots the sides; negative: a gap
  double sides_above = 10.0;  ///< how far the sides go on above the soil
  double plate_start = 0.0;   ///< above the soil, from where it comes down
  double plate_slide = 0.0;   ///< along its face, in a run
  double left_moves = 0.0;    ///< of the left side, outwards, in a run without a rest
};

inline std::string kind_name(WallKind kind) {
  return kind == WallKind::no_slip ? "rough" : "smooth";
}

inline std::string describe(const Meeting& m) {
  std::string text = (m.sand ? "sand, base " : "clay, base ") + kind_name(m.base);
  text += " left " + kind_name(m.left) + " right " + kind_name(m.right);
  const auto number = [&text](const char* name, double value, double usual) {
    if (value != usual) text += std::string(" ") + name + " " + std::to_string(value).substr(0, 5);
  };
  number("base_beyond", m.base_beyond, 0.0);
  number("side_beyond", m.side_beyond, 0.0);
  number("angle", m.angle, 90.0);
  number("offset", m.offset, 0.0);
  if (m.split_overlap != 9.0) {
    number("split_overlap", m.split_overlap, 9.0);
    text += " second " + kind_name(m.second);
  }
  if (m.plate) {
    text += " plate " + kind_name(m.plate_kind);
    number("plate_beyond", m.plate_beyond, 0.0);
    number("sides_above", m.sides_above, 10.0);
    number("plate_start", m.plate_start, 0.0);
    number("plate_slide", m.plate_slide, 0.0);
  }
  number("left_moves", m.left_moves, 0.0);
  if (m.one_wall) text += " one_wall";
  if (m.swapped) text += " swapped";
  return text;
}

constexpr double basin_spacing = 0.1, basin_width = 0.8, basin_height = 0.8;

/// Soil at rest in the basin, or pressed by a plate by a tenth of its height.
inline Scene basin(const Meeting& m) {
  const double dx = basin_spacing, w = basin_width, h = basin_height;
  const double shift = -m.offset * dx, width = w + 2.0 * m.offset * dx;
  Scene scene;
  scene.spacing = dx;
  scene.numerics = preset("modern");
  scene.materials = {
      {"soil",
       DruckerPrager{2e6, 0.3, m.sand ? 0.0 : 1e3, m.sand ? 0.576 : 0.349, 0.0, Cone::plane_strain},
       2000.0}};
  const double slant = 1.0 / std::tan(m.angle * std::numbers::pi / 180.0);
  const double lean = std::abs(slant) < 1e-12 ? 0.0 : slant;
  scene.bodies = {{.shape = Polygon{{{0, 0}, {w, 0}, {w, h}, {lean * h, h}}}}};
  const double top = h + m.sides_above * dx, reach = m.side_beyond * dx;
  const double low = shift - reach,
               left_low = shift - reach * std::sin(m.angle * std::numbers::pi / 180.0);
  const auto left_at = [&](double y) { return shift + lean * (y - shift); };
  std::vector<Wall> walls;
  const double from = left_at(shift) - m.base_beyond * dx, to = shift + width + m.base_beyond * dx;
  if (m.split_overlap == 9.0) {
    walls.push_back(wall_of("base", m.base, {facet_2d(from, shift, to, shift)}));
  } else {
    const double middle = 0.5 * w, half = 0.5 * m.split_overlap * dx;
    walls.push_back(wall_of("base", m.base, {facet_2d(from, shift, middle + half, shift)}));
    walls.push_back(wall_of("second", m.second, {facet_2d(middle - half, shift, to, shift)}));
  }
  walls.push_back(
      wall_of("left", m.left, {facet_2d(left_at(top), top, left_at(left_low), left_low)}));
  walls.push_back(wall_of("right", m.right, {facet_2d(shift + width, low, shift + width, top)}));
  const double press = 0.1 * h + m.plate_start * dx;
  if (m.plate) {
    const double at = h + m.plate_start * dx, out = m.plate_beyond * dx;
    Wall plate =
        wall_of("plate", m.plate_kind, {facet_2d(shift + width + out, at, shift - out, at)});
    plate.velocity = {0.1 * m.plate_slide * dx / press, -0.1, 0.0};
    walls.push_back(plate);
  }
  if (m.left_moves != 0.0) walls[walls.size() - 2].velocity = {-0.5 * m.left_moves * dx, 0, 0};
  if (m.one_wall) {
    std::vector<Wall> together;
    for (Wall& wall : walls) {
      Wall* same = nullptr;
      for (Wall& other : together) {
        if (other.kind == wall.kind && other.velocity == wall.velocity) same = &other;
      }
      if (same == nullptr) {
        together.push_back(wall);
      } else {
        same->facets.insert(same->facets.end(), wall.facets.begin(), wall.facets.end());
      }
    }
    walls = together;
  }
  if (m.swapped) std::reverse(walls.begin(), walls.end());
  scene.walls = walls;
  if (m.plate) {
    scene.gravity = {};
    scene.stages = {stage_for("press", press / 0.1)};
  } else {
    scene.initial_stress = InitialStress::geostatic;
    Stage settle = stage_for("settle", 8.0);
    settle.until = StageEnd::rest;
    settle.damping = 60.0;
    scene.stages = {settle};
    if (m.left_moves != 0.0) scene.stages = {stage_for("move", 2.0)};
  }
  return scene;
}

struct Outcome {
  int lost = 0;  ///< grains deeper than half a spacing behind a plane of the basin
  bool rested = false;
  double displacement = 0.0;  ///< largest [spacings]
  std::string stopped;        ///< what a run that did not end said
};

inline Outcome run_basin(const Meeting& m) {
  const double dx = basin_spacing;
  const Scene scene = basin(m);
  RunOptions options;
  options.threads = 1;
  Outcome outcome;
  Simulation simulation(scene, options);
  try {
    while (!simulation.finished()) simulation.step();
  } catch (const std::exception& error) {
    outcome.stopped = error.what();
  }
  outcome.rested = simulation.stage_reached_rest();
  const std::vector<double> position = simulation.field("position"),
                            displacement = simulation.field("displacement");
  const double moved = std::max(0.0, m.left_moves) * dx;
  const double shift = -m.offset * dx, right = basin_width + m.offset * dx;
  const double lean = 1.0 / std::tan(m.angle * std::numbers::pi / 180.0);
  const double sine = std::sin(m.angle * std::numbers::pi / 180.0);
  const double plate = m.plate ? 0.9 * basin_height : 1e9;
  for (std::size_t k = 0; k < simulation.soil_count(); ++k) {
    const double x = position[3 * k], y = position[3 * k + 1];
    const double behind_left = (shift + lean * (y - shift) - x) * sine - moved;
    const double deepest = std::max({shift - y, x - right, behind_left, y - plate});
    outcome.lost += !(deepest <= 0.5 * dx);
    outcome.displacement = std::max(outcome.displacement,
                                    std::hypot(displacement[3 * k], displacement[3 * k + 1]) / dx);
  }
  return outcome;
}

/// The same scene with walls that meet exactly, drawn on the lattice.
inline Meeting exact(Meeting m) {
  const Meeting plain;
  m.base_beyond = m.side_beyond = m.plate_beyond = m.offset = 0.0;
  m.split_overlap = plain.split_overlap;
  m.second = plain.second;
  m.one_wall = m.swapped = false;
  return m;
}

/// Every two and three walls of any two kinds, in every way in which they meet: exactly, as a T or
/// an X, with a gap or an overlap, acute, right or obtuse, off the lattice of the soil, drawn in
/// one wall or several and in either order, and with a plate that moves past the sides.
inline std::vector<Meeting> all_meetings() {
  constexpr WallKind kinds[] = {WallKind::no_slip, WallKind::free_slip};
  std::vector<Meeting> all;
  const auto add_kinds = [&](Meeting m) {
    for (const WallKind base : kinds) {
      for (const WallKind left : kinds) {
        for (const WallKind right : kinds) {
          m.base = base;
          m.left = left;
          m.right = right;
          all.push_back(m);
        }
      }
    }
  };
  for (const bool sand : {false, true}) {
    Meeting m;
    m.sand = sand;
    const auto add = [&](auto&& change) {
      Meeting changed = m;
      change(changed);
      add_kinds(changed);
    };
    for (const double angle : {60.0, 90.0, 120.0}) {
      for (const double beyond : {-0.9, -0.5, -0.1, 0.0, 0.1, 0.5, 1.0, 2.0, 3.0, 10.0}) {
        add([&](Meeting& c) { c.angle = angle, c.base_beyond = beyond; });
        if (beyond != 0.0) add([&](Meeting& c) { c.angle = angle, c.side_beyond = beyond; });
        if (beyond > 0.0) {
          add([&](Meeting& c) { c.angle = angle, c.side_beyond = c.base_beyond = beyond; });
        }
      }
    }
    for (const double angle : {45.0, 75.0, 105.0, 135.0, 150.0}) {
      for (const double beyond : {0.0, 3.0}) {
        add([&](Meeting& c) { c.angle = angle, c.side_beyond = beyond; });
      }
    }
    for (const double offset : {0.1, 0.25, 0.5}) {
      for (const double beyond : {0.0, 3.0}) {
        add([&](Meeting& c) { c.offset = offset, c.side_beyond = beyond; });
        add([&](Meeting& c) { c.offset = offset, c.base_beyond = beyond; });
      }
    }
    for (const double overlap : {-0.9, -0.5, 0.0, 0.3, 1.0, 3.0}) {
      for (const WallKind second : kinds) {
        add([&](Meeting& c) { c.split_overlap = overlap, c.second = second; });
      }
    }
    for (const double beyond : {0.0, 3.0}) {
      add([&](Meeting& c) { c.side_beyond = beyond, c.swapped = true; });
      add([&](Meeting& c) { c.side_beyond = beyond, c.one_wall = true; });
      add([&](Meeting& c) { c.base_beyond = beyond, c.swapped = true; });
    }
    for (const double moves : {-0.4, 0.4}) {
      for (const double beyond : {0.0, 3.0}) {
        add([&](Meeting& c) { c.left_moves = moves, c.base_beyond = c.side_beyond = beyond; });
      }
    }
    for (const WallKind plate : kinds) {
      for (const double beyond : {-0.5, 0.0, 0.5, 3.0}) {
        for (const double above : {0.0, 1.0, 2.0}) {
          add([&](Meeting& c) {
            c.plate = true, c.plate_kind = plate, c.plate_beyond = beyond;
            c.plate_start = 3.0, c.sides_above = above;
          });
        }
        for (const double slide : {-0.24, 0.24}) {
          add([&](Meeting& c) {
            c.plate = true, c.plate_kind = plate, c.plate_beyond = beyond, c.plate_slide = slide;
          });
        }
      }
      for (const double beyond : {-0.9, -0.5, -0.1, 0.0, 0.1, 0.5, 1.0, 2.0, 3.0}) {
        for (const double above : {0.0, 0.5, 10.0}) {
          add([&](Meeting& c) {
            c.plate = true, c.plate_kind = plate, c.plate_beyond = beyond, c.sides_above = above;
          });
        }
      }
    }
  }
  return all;
}

}  // namespace scarp::test
