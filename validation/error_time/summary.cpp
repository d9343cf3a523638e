// SPDX-License-Identifier: BSD-3-Clause
/// From runs to points and their front.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/converge/richardson.hpp"
#include "engine/errors.hpp"
#include "validation/error_time/study.hpp"

namespace scarp::validation {
namespace {

/// Linear between the sorted values: share 0.5 is the median.
double interpolated_quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  const double place = share * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return values[below] + (place - static_cast<double>(below)) * (values[above] - values[below]);
}

void take_costs(Point& point, const std::vector<RunRecord>& records) {
  std::vector<double> wall, cpu;
  for (const RunRecord& record : records) {
    wall.push_back(record.wall_s);
    cpu.push_back(record.cpu_s);
  }
  const RunRecord& first = records.front();
  point.status = first.status;
  point.reason = first.reason;
  point.wall_s = interpolated_quantile(wall, 0.5);
  point.cpu_s = interpolated_quantile(cpu, 0.5);
  point.spread =
      wall.size() > 1
          ? (interpolated_quantile(wall, 0.75) - interpolated_quantile(wall, 0.25)) / point.wall_s
          : std::nan("");
  point.particles = first.particles;
  point.steps = first.steps;
  point.particle_steps = first.particle_steps;
  point.memory_bytes = first.memory_bytes;
  point.repeats = static_cast<int>(records.size());
}

using Runs = std::vector<std::pair<Point, std::vector<RunRecord>>>;

/// What the setting of the reference tends to, from its three finest spacings; the finest value
/// itself where they do not converge or are not there. Empty without the finest run.
std::optional<Reference> reference_of(const Runs& runs, const Trial& reference) {
  std::array<ValueAtSpacing, 3> values{};
  std::array<bool, 3> found{};
  for (const auto& [point, records] : runs) {
    const std::size_t finer = reference.level - point.trial.level;
    if (point.trial.setting != reference.setting || finer > 2) continue;
    if (records.front().status != RunStatus::ok) continue;
    values[2 - finer] = {point.spacing, records.front().outcome};
    found[2 - finer] = true;
  }
  if (!found[2]) return {};
  Reference value{values[2].value, {}};
  if (found[0] && found[1]) {
    const ErrorEstimate estimate = estimate_error(values);
    if (estimate.extrapolated && estimate.trend != Trend::equal) {
      value = {*estimate.extrapolated, estimate.order};
    }
  }
  return value;
}

}  // namespace

void require_problem(const CaseRow& row) {
  if (row.problem != nullptr) return;
  std::vector<std::string_view> names;
  for (const CaseRow& other : case_list) {
    if (other.problem != nullptr) names.push_back(other.name);
  }
  throw Error(fmt::format(
      "case '{}': it has no scalar error to hold against run time. Those that have: {}.", row.name,
      fmt::join(names, ", ")));
}

void sum_up(ErrorStudy& study, const std::vector<std::pair<Point, std::vector<RunRecord>>>& runs) {
  bool has_reference = false;
  for (const auto& [point, records] : runs) {
    if (!point.reference) continue;
    has_reference = true;
    study.reference = reference_of(runs, point.trial);
  }
  std::vector<ErrorTime> at;
  for (const auto& [planned, records] : runs) {
    Point point = planned;
    take_costs(point, records);
    const double outcome = records.front().outcome;
    point.error = !has_reference    ? std::fabs(outcome)
                  : study.reference ? std::fabs(outcome / study.reference->value - 1.0)
                                    : std::nan("");
    // A run that is held against itself has no error.
    const bool itself = point.reference && study.reference && !study.reference->order;
    if (point.status != RunStatus::ok || itself) point.error = std::nan("");
    // An error of the size of the answer is no place on the front.
    at.push_back({point.error < 1.0 ? point.error : std::nan(""), point.wall_s});
    study.points.push_back(std::move(point));
  }
  study.front = pareto_front(at);
  for (const std::size_t f : study.front) study.points[f].on_front = true;
}

}  // namespace scarp::validation
