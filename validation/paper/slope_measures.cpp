// SPDX-License-Identifier: BSD-3-Clause
/// Sections, slide body and stress of a slope from its particles.

#include "validation/paper/slope_measures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "validation/deposit.hpp"
#include "validation/paper/plane_zone.hpp"
#include "validation/paper/sections.hpp"
#include "validation/paper/slip_surface.hpp"

namespace scarp::validation {
namespace {

using std::numbers::sqrt2;

double mean(const std::vector<Grain>& grains, const std::function<bool(const Grain&)>& counts,
            const std::function<double(const Grain&)>& value) {
  double sum = 0.0, number = 0.0;
  for (const Grain& grain : grains) {
    if (!counts(grain)) continue;
    sum += value(grain);
    number += 1.0;
  }
  return sum / number;
}

/// Horizontal stress in the direction in which the face falls.
double downhill_stress(const Grain& g, const Slope3d& slope) {
  const bool concave = slope.shape() == SlopeShape::concave;
  const double away = concave ? slope.length() - g.start[0] : g.start[0];
  const double r = std::hypot(away, g.start[1]);
  if (slope.shape() == SlopeShape::straight || !(r > 0.0)) return g.xx;
  const double x = away / r, y = (concave ? -1.0 : 1.0) * g.start[1] / r;
  return x * x * g.xx + y * y * g.yy + 2.0 * x * y * g.xy;
}

/// Angle from the diagonal to the greater horizontal pressure in the soil above the toe within half
/// a height of section P, on the side of x > y; the other side has its negative.
double turn_beside_p(const std::vector<Grain>& grains, const Slope3d& slope) {
  double sum = 0.0, difference = 0.0;  // of the mean stress, along the diagonal and across it
  for (const Grain& g : grains) {
    const double beside = (g.start[0] - g.start[1]) / sqrt2;
    if (beside < 0.0 || beside > 0.5 * slope.size().height || !at_risk(g, slope)) continue;
    sum += 2.0 * g.xy;
    difference += g.xx - g.yy;
  }
  // Pressure along the diagonal less that across it, and its shear, on axes turned by 45 degrees.
  const double along = -sum, shear = -difference;
  return 0.5 * std::atan2(shear, along) * 180.0 / std::numbers::pi;
}

void measure_stress(const std::vector<Grain>& grains, const Slope3d& slope, double spacing,
                    const std::string& moment, Outcome& outcome) {
  for (const Section& section : sections_of(slope)) {
    const auto in = [&](const Grain& g) { return section.holds(g, spacing) && at_risk(g, slope); };
    const auto put = [&](const char* what, const std::function<double(const Grain&)>& value) {
      outcome.values[fmt::format("{}: {}, {} [Pa]", section.name, what, moment)] =
          -mean(grains, in, value);
    };
    put("across", [&](const Grain& g) { return section.stress_across(g); });
    put("along", [&](const Grain& g) { return section.stress_along(g); });
    put("vertical", [](const Grain& g) { return g.zz; });
  }
  if (slope.plane()) return;
  if (slope.corner()) {
    outcome.values[fmt::format("beside P: turn of the greater pressure, {} [deg]", moment)] =
        turn_beside_p(grains, slope);
    return;
  }
  const double width = slope.size().half_width;
  const auto side = [&](const Grain& g) { return g.start[1] > width / 1.5 && at_risk(g, slope); };
  outcome.values[fmt::format("side: downhill, {} [Pa]", moment)] =
      -mean(grains, side, [&](const Grain& g) { return downhill_stress(g, slope); });
}

/// How far the foot of the soil that lay above the toe has come in the section, by its third
/// particle: one or two may roll ahead [m].
double front_advance(const std::vector<Grain>& grains, const Section& section, double foundation,
                     double spacing) {
  std::vector<double> before, now;
  for (const Grain& grain : grains) {
    if (!section.holds(grain, spacing) || grain.start[2] < foundation) continue;
    before.push_back(section.along(grain.start));
    now.push_back(section.along(grain.now));
  }
  const auto third = [](std::vector<double>& places) {
    std::nth_element(places.begin(), places.begin() + 2, places.end(), std::greater<>());
    return places[2];
  };
  return before.size() < 3 ? std::nan("") : third(now) - third(before);
}

/// Slide and plastic zone of one section, in the undeformed slope.
void measure_section(const std::vector<Grain>& grains, const Slope3d& slope, const Section& section,
                     double spacing, Outcome& outcome) {
  const double area = spacing * (section.diagonal ? sqrt2 * spacing : spacing);
  const double run = section.diagonal ? sqrt2 * slope.face_run() : slope.face_run();
  const double length = std::hypot(run, slope.size().height);
  const double down = run / length, drop = slope.size().height / length;
  PlaneZone slide, plastic;  // coordinates: down the face, into the slope
  for (const Grain& grain : grains) {
    if (!section.holds(grain, spacing)) continue;
    const double s = section.along(grain.start), z = grain.start[2];
    const std::array<double, 2> place{down * s - drop * z, -drop * s - down * z};
    if (slides(grain, slope)) slide.add(place, area);
    if (grain.strain > plastic_strain) plastic.add(place, area);
  }
  const auto put = [&](const char* what, double value) {
    outcome.values[fmt::format("{}: {}", section.name, what)] = value;
  };
  put("front: advance [m]", front_advance(grains, section, slope.size().foundation, spacing));
  put("mean displacement of the soil above the toe [m]",
      mean(
          grains, [&](const Grain& g) { return section.holds(g, spacing) && at_risk(g, slope); },
          [](const Grain& g) { return g.moved; }));
  put("slide area [m2]", slide.area());
  put("plastic area [m2]", plastic.area());
  put("plastic thickness [m]", plastic.area() / (plastic.extent(0) + spacing));
  put("plastic zone over its rectangle [-]", plastic.hull_share());
}

double volume_of_slide(const std::vector<Grain>& grains, const Slope3d& slope, double spacing,
                       const std::function<bool(const Grain&)>& counts) {
  double number = 0.0;
  for (const Grain& grain : grains) number += slides(grain, slope) && counts(grain);
  return number * std::pow(spacing, 3);
}

/// The section a probe is named after: P1 lies in section P.
Section section_of(const Slope3d& slope, const std::string& probe) {
  const std::vector<Section> sections = sections_of(slope);
  const auto named = std::find_if(sections.begin(), sections.end(), [&](const Section& section) {
    return section.name.back() == probe.front();
  });
  return named == sections.end() ? sections.front() : *named;
}

void measure_probes(const Simulation& fallen, const Slope3d& slope, Outcome& outcome) {
  double fastest = 0.0;
  for (std::size_t k = 0; k < fallen.scene().probes.size(); ++k) {
    const ProbeSample sample = fallen.probe(k);
    const Vec3 &u = sample.displacement, &v = sample.velocity;
    fastest = std::max(fastest, std::hypot(v[0], v[1], v[2]));
    outcome.values[sample.probe + ": settlement [m]"] = slope.plane() ? -u[1] : -u[2];
    outcome.values[sample.probe + ": advance [m]"] = section_of(slope, sample.probe).along(u);
  }
  outcome.values["fastest probe at the end [m/s]"] = fastest;
}

/// Cracks would show as grains that have lost their neighbours (density also falls by dilation):
/// within 1.5 spacings, now over before; on the lower half of the face, 5 % quantile.
double fewest_neighbours(const std::vector<Grain>& grains, const Slope3d& slope,
                         const Section& section, double spacing) {
  const double scale = section.diagonal ? sqrt2 : 1.0;
  const double toe = scale * (slope.size().crest + slope.face_run());
  const double reach = 1.5 * spacing;
  const auto near = [reach](const Vec3& a, const Vec3& b) {
    const double x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
    return x * x + y * y + z * z < reach * reach;
  };
  std::vector<double> kept;
  for (const Grain& grain : grains) {
    const double s = section.along(grain.start);
    if (!section.holds(grain, spacing) || s > toe || s < toe - 0.5 * scale * slope.face_run() ||
        grain.start[2] < slope.size().foundation) {
      continue;
    }
    double before = 0.0, now = 0.0;
    for (const Grain& other : grains) {
      before += near(other.start, grain.start);
      now += near(other.now, grain.now);
    }
    kept.push_back(now / before);
  }
  return quantile(kept, 0.05);
}

/// Of the slide that now lies on the diagonal, what began more than a spacing beside it.
double share_from_beside(const std::vector<Grain>& grains, const Slope3d& slope, double spacing) {
  double on = 0.0, from_beside = 0.0;
  for (const Grain& grain : grains) {
    if (!slides(grain, slope) || std::fabs(grain.now[0] - grain.now[1]) > 0.5 * spacing) continue;
    on += 1.0;
    from_beside += std::fabs(grain.start[0] - grain.start[1]) > sqrt2 * spacing;
  }
  return from_beside / on;
}

/// Plastic zone of the horizontal section N at half height, over the width of the slope [m].
double plastic_thickness_of_n(const std::vector<Grain>& grains, const Slope3d& slope,
                              double spacing) {
  const double height = slope.size().foundation + 0.5 * slope.size().height;
  double number = 0.0;
  for (const Grain& grain : grains) {
    number += grain.strain > plastic_strain && grain.start[2] > height &&
              grain.start[2] < height + spacing;
  }
  return number * spacing * spacing / slope.width();
}

}  // namespace

void measure_settled(const Simulation& settled, const Slope3d& slope, Outcome& outcome) {
  measure_stress(grains_of(settled), slope, settled.scene().spacing, "settled", outcome);
  outcome.values["residual velocity, settled [m/s]"] = settled.last_step().max_velocity;
}

void watch_probes(const Simulation& now, const Slope3d& slope, Outcome& outcome) {
  for (std::size_t k = 0; k < now.scene().probes.size(); ++k) {
    const std::string name = now.scene().probes[k].name + ": failed after [s]";
    if (outcome.values.count(name) != 0) continue;
    const Vec3 u = now.probe(k).displacement;
    if (std::hypot(u[0], u[1], u[2]) > failure_share * slope.size().height) {
      outcome.values[name] = now.last_step().stage_time;
    }
  }
}

void measure_slide(const Simulation& fallen, const Slope3d& slope, Outcome& outcome) {
  const std::vector<Grain> grains = grains_of(fallen);
  const double spacing = fallen.scene().spacing;
  measure_probes(fallen, slope, outcome);
  measure_stress(grains, slope, spacing, "at the end", outcome);
  for (const Section& section : sections_of(slope)) {
    measure_section(grains, slope, section, spacing, outcome);
    if (slope.corner()) {
      outcome.values[section.name + ": fewest neighbours above the toe, now over before [-]"] =
          fewest_neighbours(grains, slope, section, spacing);
    }
  }
  std::vector<double> moved;
  double inside = 0.0;
  for (const Grain& grain : grains) {
    moved.push_back(grain.moved);
    inside += grain.now[0] > 0.0 && grain.now[0] < slope.length() && grain.now[2] > 0.0 &&
              (slope.plane() || (grain.now[1] > 0.0 && grain.now[1] < slope.width()));
  }
  outcome.values["largest displacement, 99.9 % [m]"] = quantile(moved, 0.999);
  outcome.values["mass inside over mass before [-]"] = inside / static_cast<double>(grains.size());
  outcome.values["end of the slide [s]"] = fallen.last_step().stage_time;
  outcome.values["residual velocity [m/s]"] = fallen.last_step().max_velocity;
  outcome.values["particles [-]"] = static_cast<double>(grains.size());
  if (slope.plane()) return;
  measure_slip_surface(grains, slope, spacing, outcome);
  const double halves = slope.corner() ? 1.0 : 2.0;  // case 1 is run on one side of section M
  outcome.values["slide volume [m3]"] =
      halves * volume_of_slide(grains, slope, spacing, [](const Grain&) { return true; });
  if (slope.corner()) {
    const auto side = [&](std::size_t far, std::size_t near) {
      return volume_of_slide(grains, slope, spacing, [far, near, spacing](const Grain& g) {
        return g.start[far] > g.start[near] + 0.5 * spacing;
      });
    };
    const double x_side = side(0, 1), y_side = side(1, 0);
    outcome.values["slide volume, difference of the sides over both [-]"] =
        std::fabs(x_side - y_side) / (x_side + y_side);
    outcome.values["section P: share of the slide from beside [-]"] =
        share_from_beside(grains, slope, spacing);
    return;
  }
  outcome.values["section N: plastic thickness [m]"] =
      plastic_thickness_of_n(grains, slope, spacing);
  outcome.values["share of the slide at the rough side [-]"] =
      halves *
      volume_of_slide(grains, slope, spacing,
                      [&](const Grain& g) { return g.start[1] > slope.width() - 2.0 * spacing; }) /
      outcome.at("slide volume [m3]");
}

}  // namespace scarp::validation
