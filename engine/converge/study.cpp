// SPDX-License-Identifier: BSD-3-Clause
/// From three runs to estimates and advice.

#include "engine/converge/study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace scarp {
namespace {

constexpr std::array axis_name{"x", "y", "z"};

void add_vector(std::vector<EndQuantity>& quantities, const std::string& name,
                const std::string& unit, int dimension, bool probe) {
  const std::size_t size = quantities.size();
  quantities.push_back({name, unit, size, probe});
  for (std::size_t a = 0; a < static_cast<std::size_t>(dimension); ++a) {
    quantities.push_back({fmt::format("{}_{}", name, axis_name[a]), unit, size, probe});
  }
}

double norm(const double* v) { return std::hypot(v[0], v[1], v[2]); }

void add_vector(std::vector<double>& values, const Vec3& vector, int dimension) {
  values.push_back(norm(vector.data()));
  values.insert(values.end(), vector.begin(), vector.begin() + dimension);
}

/// Trusted as far as it goes: a spacing is asked for by the quantity that needs the finest one.
Advice advise(const Study& study, double target) {
  Advice advice{target, study.runs.front().spacing, 0.0, {}};
  const auto probes = std::any_of(study.quantities.begin(), study.quantities.end(),
                                  [](const Convergence& c) { return c.quantity.probe; });
  for (std::size_t q = 0; q < study.quantities.size(); ++q) {
    const Convergence& c = study.quantities[q];
    const bool judged =
        c.quantity.size == q && c.quantity.unit == "m" && c.quantity.probe == probes;
    if (!judged) continue;
    const std::optional<double> spacing = spacing_for(c.estimate, c.values, target);
    if (!spacing) return {target, {}, 0.0, c.quantity.name};
    if (advice.decided_by.empty() || *spacing < *advice.spacing) {
      advice.spacing = spacing;
      advice.decided_by = c.quantity.name;
    }
  }
  // From the run nearest in spacing, on a logarithmic scale: its steps are the most alike.
  const auto distance = [&](const SpacingRun& run) {
    return std::abs(std::log(run.spacing / *advice.spacing));
  };
  const auto nearest = std::min_element(
      study.runs.begin(), study.runs.end(),
      [&](const SpacingRun& a, const SpacingRun& b) { return distance(a) < distance(b); });
  advice.wall_s =
      forecast_wall(nearest->wall_s, nearest->spacing, *advice.spacing, study.dimension);
  return advice;
}

void add_notes(Study& study) {
  bool no_order = false, up_and_down = false;
  for (std::size_t q = 0; q < study.quantities.size(); ++q) {
    const Convergence& c = study.quantities[q];
    if (c.quantity.size != q || c.quantity.unit != "m") continue;
    no_order |= c.estimate.trend == Trend::not_converging;
    up_and_down |= c.estimate.trend == Trend::not_monotone;
  }
  if (no_order || up_and_down) {
    study.notes.push_back(fmt::format(
        "A displacement {}. The soil model has no internal length: after failure the slip band is "
        "as thin as the spacing lets it be, and displacement need not converge. Quote the spacing "
        "with every number. Where nothing fails, try finer spacings that fit the bodies.",
        no_order ? "does not converge over these spacings" : "goes up and down with the spacing"));
  }
  const SpacingRun& fine = study.runs.back();
  for (const SpacingRun& run : study.runs) {
    const double more = run.mass / fine.mass - 1.0;
    if (!(std::abs(more) > 0.005)) continue;
    study.notes.push_back(fmt::format(
        "At spacing {:g} m the bodies hold {:+.2g} % mass against the finest spacing: their sizes "
        "are not multiples of it, which is an error of its own that follows no order.",
        run.spacing, 100.0 * more));
  }
}

}  // namespace

std::vector<EndQuantity> end_quantities(const Scene& scene) {
  std::vector<EndQuantity> quantities;
  for (const Probe& probe : scene.probes) {
    add_vector(quantities, probe.name + ".displacement", "m", scene.dimension, true);
  }
  quantities.push_back({"largest displacement", "m", quantities.size(), false});
  for (const Wall& wall : scene.walls) {
    add_vector(quantities, wall.name + ".force", scene.dimension == 2 ? "N/m" : "N",
               scene.dimension, false);
  }
  return quantities;
}

std::vector<double> end_values(const Simulation& simulation) {
  const Scene& scene = simulation.scene();
  std::vector<double> values;
  for (std::size_t p = 0; p < scene.probes.size(); ++p) {
    add_vector(values, simulation.probe(p).displacement, scene.dimension);
  }
  double largest = 0.0;
  const std::vector<double> displacement = simulation.field("displacement");
  for (std::size_t i = 0; i + 2 < displacement.size(); i += 3) {
    largest = std::fmax(largest, norm(&displacement[i]));
  }
  values.push_back(largest);
  const std::vector<WallReaction> reactions = simulation.wall_reactions();
  for (const Wall& wall : scene.walls) {  // a wall that has gone carries nothing
    const auto found = std::find_if(reactions.begin(), reactions.end(),
                                    [&](const WallReaction& r) { return r.wall == wall.name; });
    add_vector(values, found != reactions.end() ? found->force : Vec3{}, scene.dimension);
  }
  return values;
}

Study assess(const std::vector<EndQuantity>& quantities, const std::array<SpacingRun, 3>& runs,
             int dimension) {
  Study study{dimension, runs, {}, {}, {}};
  for (std::size_t q = 0; q < quantities.size(); ++q) {
    Convergence c{quantities[q], {}, {}};
    for (std::size_t k = 0; k < 3; ++k) c.values[k] = {runs[k].spacing, runs[k].values.at(q)};
    double scale = 0.0;
    if (const std::size_t size = quantities[q].size; size != q) {
      const Convergence& whole = study.quantities.at(size);
      scale = std::abs(whole.estimate.extrapolated.value_or(whole.values.back().value));
    }
    c.estimate = estimate_error(c.values, scale);
    study.quantities.push_back(std::move(c));
  }
  for (const double target : {0.05, 0.02}) study.advice.push_back(advise(study, target));
  add_notes(study);
  return study;
}

std::string remark(const ErrorEstimate& estimate) {
  switch (estimate.trend) {
    case Trend::equal:
      return "the same at all spacings";
    case Trend::converging:
      return {};
    case Trend::order_limited:
      return estimate.observed_order > most_order
                 ? fmt::format(
                       "order {:.2g} counted as {:g}, so that the error is not made too small",
                       estimate.observed_order, most_order)
                 : fmt::format("order {:.2g} counted as {:g}: the error is a lower bound",
                               estimate.observed_order, least_order);
    case Trend::not_converging:
      return "does not converge: the change does not shrink; error counted as 3 times the spread";
    case Trend::not_monotone:
      return "not monotone: error counted as 3 times the spread";
  }
  return {};
}

}  // namespace scarp
