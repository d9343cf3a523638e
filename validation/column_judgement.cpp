// SPDX-License-Identifier: BSD-3-Clause
/// Columns against run-out laws.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "engine/converge/richardson.hpp"
#include "engine/output/text_file.hpp"
#include "validation/column_collapse.hpp"

namespace scarp::validation {
namespace {

constexpr double control_friction = 65.0;  // [deg]
constexpr double shown_aspect = 1.0;       // of the column that leaves frames

void write_deposits(const std::filesystem::path& path, const std::vector<ColumnDeposit>& deposits) {
  CsvFile file(path, {"preset", "dx [m]", "aspect_ratio", "friction_angle [deg]", "run_out",
                      "grain_run_out", "connected_run_out", "height", "viscous_share"});
  for (const ColumnDeposit& one : deposits) {
    file << one.preset << one.spacing << one.column.aspect_ratio << one.column.friction_angle
         << one.run_out << one.grain_run_out << one.connected_run_out << one.height
         << one.viscous_share;
    file.end_row();
  }
}

/// Runs the columns of a case one by one and keeps their deposits.
class Columns {
 public:
  explicit Columns(CaseRun& run) : run_(run) {}

  /// Runs a column; the first one asked to be shown leaves its frames.
  ColumnDeposit at(const std::string& preset, double spacing, Column column, bool show) {
    Scene scene = run_.scene_at(spacing, preset);
    set_column(scene, column);
    const std::string name = fmt::format("{}, a = {}, phi = {:.3g} deg, dx = {} m", preset,
                                         column.aspect_ratio, column.friction_angle, spacing);
    Simulation simulation(scene, run_.options().run);
    std::optional<RunWriter> writer;
    show = show && !shown_;
    if (show) writer.emplace(simulation, run_.folder());
    Profile surface;
    deposits_.push_back(collapse_column(run_, name, simulation, column, writer ? &*writer : nullptr,
                                        scene.dimension == 2 ? &surface : nullptr));
    if (show) writer->finish(simulation, 0.0);
    if (!surface.x.empty()) {
      write_profile(run_.folder() / fmt::format("surface_{}_a{}_phi{:.3g}.csv", preset,
                                                column.aspect_ratio, column.friction_angle),
                    surface);
    }
    if (show) shown_ = std::move(simulation);
    return deposits_.back();
  }

  void finish() {
    write_deposits(run_.folder() / "run_out.csv", deposits_);
    run_.finish(&*shown_);
  }

 private:
  CaseRun& run_;
  std::vector<ColumnDeposit> deposits_;
  std::optional<Simulation> shown_;
};

void judge_end(CaseRun& run, const std::string& who, const std::vector<ColumnDeposit>& series) {
  double lost = 0.0;
  for (const ColumnDeposit& one : series) lost = std::max(lost, one.lost);
  run.add(within(who + "share of the soil lost through walls", lost, "", 0.0, 0.0, 0.0,
                 "mass is conserved; at all spacings, more than a spacing behind a wall"));
  const ColumnDeposit& finest = series.back();
  run.add(within(who + "advance of the front in the last sqrt(H0/g), over L0", finest.advance, "",
                 0.0, -0.01 * (1.0 + finest.run_out), 0.01 * (1.0 + finest.run_out),
                 "at rest: 1 % of the length of the deposit"));
}

/// Coarse to fine: what the soil itself does not dissipate is an error, which has to go.
void report_viscous_share(CaseRun& run, const std::string& who,
                          const std::vector<ColumnDeposit>& deposits) {
  std::string all;
  for (const ColumnDeposit& one : deposits)
    all += fmt::format("{}{:.3g}", all.empty() ? "coarse to fine: " : ", ", one.viscous_share);
  run.add(reported(who + "share of the artificial viscosity in what the collapse dissipates",
                   deposits.back().viscous_share, "", all));
}

void report_change(CaseRun& run, const std::string& who,
                   const std::vector<ColumnDeposit>& deposits) {
  if (deposits.size() < 2) return;
  const auto report = [&](const std::string& what, double ColumnDeposit::*value) {
    const ColumnDeposit &finest = deposits.back(), &coarser = deposits[deposits.size() - 2];
    std::string over;
    for (const ColumnDeposit& one : deposits) {
      over += fmt::format("{}{:.4g}", over.empty() ? "" : ", ", one.*value);
    }
    run.add(reported(fmt::format("{}{}, change from dx = {:.4g} to {:.4g} m", who, what,
                                 coarser.spacing, finest.spacing),
                     finest.*value / coarser.*value - 1.0, "", "coarse to fine: " + over));
    if (deposits.size() != 3) return;
    const ErrorEstimate estimate = estimate_error({{{deposits[0].spacing, deposits[0].*value},
                                                    {deposits[1].spacing, deposits[1].*value},
                                                    {deposits[2].spacing, deposits[2].*value}}});
    run.add(reported(who + what + ", estimated error at the finest spacing", estimate.error[2], "",
                     estimate.trend == Trend::converging ? "converging" : "order outside limits"));
  };
  report("run-out to 99.5 % of the volume", &ColumnDeposit::run_out);
  report("height", &ColumnDeposit::height);
}

/// The two laws at an aspect ratio, lower one first.
std::pair<double, double> band(const LawBand& laws, double aspect_ratio) {
  return std::minmax({laws.lube.at(aspect_ratio), laws.lajeunesse.at(aspect_ratio)});
}

void judge(CaseRun& run, const std::string& who, const std::vector<ColumnDeposit>& series,
           const ColumnPlan& plan, const LawBand& laws) {
  const ColumnDeposit& finest = series.back();
  const double a = finest.column.aspect_ratio;
  const auto [low, high] = band(laws, a);
  judge_end(run, who, series);
  // A layer one grain deep is known where a particle of columns as high as wide is no larger.
  const double particle = finest.spacing / std::min(1.0, a);
  const bool by_grain = particle <= (1.0 + 1e-9) * grain_size * finest.width;
  const double judged = by_grain ? finest.grain_run_out : finest.run_out;
  const std::string to =
      by_grain ? "to where the deposit is one grain high" : "to 99.5 % of the volume";
  if (a <= laws.largest_judged) {
    run.add(within(who + "run-out (L - L0)/L0", judged, "", {}, low, high,
                   "between " + laws.source + ", " + to));
  } else {
    run.add(reported(who + "run-out (L - L0)/L0", judged, "",
                     fmt::format("{}; laws {:.3g} and {:.3g}", to, low, high)));
  }
  run.add(reported(who + "run-out over Lube's law - 1", judged / laws.lube.at(a) - 1.0, "",
                   laws.over_run));
  if (by_grain) {
    run.add(reported(who + "run-out to 99.5 % of the volume", finest.run_out, "",
                     "with the loose grains ahead of the deposit"));
  } else {
    run.add(
        reported(who + "run-out to where the deposit is one grain high", finest.grain_run_out, ""));
  }
  run.add(reported(who + "run-out of the connected deposit", finest.connected_run_out, ""));
  if (a <= plan.height_kept_to) {
    const double layer = finest.spacing / finest.width;
    run.add(within(who + "height at the middle over L0", finest.height, "", a, a - layer, a + layer,
                   "unchanged on planar columns up to a = 0.65; one spacing"));
  } else {
    run.add(reported(who + "height at the middle over L0", finest.height, ""));
  }
  report_viscous_share(run, who, series);
  report_change(run, who, series);
}

/// Soil far too strong must not pass for sand.
void judge_control(CaseRun& run, const std::string& who, const ColumnDeposit& control,
                   const LawBand& laws) {
  const auto [low, high] = band(laws, control.column.aspect_ratio);
  run.add(reported(who + "run-out", control.run_out, "",
                   fmt::format("band of the laws {:.3g} to {:.3g}", low, high)));
  run.add(holds(who + "run-out is outside the band of the laws",
                control.run_out < low || control.run_out > high, "else the band judges nothing"));
}

}  // namespace

void judge_columns(CaseRun& run, const ColumnPlan& plan, const LawBand& laws) {
  const std::vector<double> spacings = run.spacings(plan.spacings);
  Columns columns(run);
  std::vector<std::string> presets = run.presets();
  if (run.short_form()) presets.resize(1);
  for (const std::string& preset : presets) {
    for (const double aspect : plan.aspect_ratios) {
      std::vector<ColumnDeposit> series;
      for (std::size_t n = 0; n < spacings.size(); ++n) {
        const bool finest = n + 1 == spacings.size();
        // What is not judged is left out where it takes longest.
        if (aspect > laws.largest_judged && finest && n > 0) continue;
        // A column lower than wide has as many layers as others have columns.
        const double spacing = spacings[n] * std::min(1.0, aspect);
        series.push_back(
            columns.at(preset, spacing, {aspect, 0.0}, finest && aspect == shown_aspect));
      }
      judge(run, fmt::format("{}, a = {}: ", preset, aspect), series, plan, laws);
    }
    const double aspect = plan.control_aspect_ratio;
    judge_control(
        run, fmt::format("{}, control of phi = {} deg, a = {}: ", preset, control_friction, aspect),
        columns.at(preset, spacings.front(), {aspect, control_friction}, false), laws);
  }
  columns.finish();
}

}  // namespace scarp::validation
