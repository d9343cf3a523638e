// SPDX-License-Identifier: BSD-3-Clause
/// Richardson extrapolation over unequal ratios of spacing.

#include "engine/converge/richardson.hpp"

#include <algorithm>
#include <cmath>

namespace scarp {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Two runs of one scene on other threads differ by round-off that a few thousand steps amplify:
/// values closer than this share of their size count as the same.
constexpr double same = 1e-9;

/// (h1^p - h2^p)/(h2^p - h3^p), which rises with p from 0 to infinity; ln over ln at p = 0.
double difference_ratio(double coarse, double fine, double p) {
  // With a = ln(h1/h2), b = ln(h2/h3): e^(p b) (e^(p a) - 1)/(e^(p b) - 1).
  const double a = std::log(coarse), b = std::log(fine);
  if (std::abs(p) < 1e-9) return a / b;
  return std::exp(p * b) * std::expm1(p * a) / std::expm1(p * b);
}

/// The order by bisection; orders beyond +-20 stand for "at once" and "never".
double solve_order(double ratio, double coarse, double fine) {
  double low = -20.0, high = 20.0;
  for (int k = 0; k < 100; ++k) {
    const double middle = 0.5 * (low + high);
    (difference_ratio(coarse, fine, middle) < ratio ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace

ErrorEstimate estimate_error(const std::array<ValueAtSpacing, 3>& samples, double scale) {
  const ValueAtSpacing &coarse = samples[0], &middle = samples[1], &fine = samples[2];
  ErrorEstimate estimate;
  const double first = coarse.value - middle.value, second = middle.value - fine.value;
  const double largest =
      std::max({std::abs(coarse.value), std::abs(middle.value), std::abs(fine.value), scale});
  if (!std::isfinite(coarse.value + middle.value + fine.value)) {
    estimate.trend = Trend::not_monotone;
    estimate.error = {nan, nan, nan};
    return estimate;
  }
  const bool no_first = std::abs(first) <= same * largest,
             no_second = std::abs(second) <= same * largest;
  if (no_first && no_second) {
    estimate.extrapolated = fine.value;
    return estimate;
  }
  const auto without_order = [&](Trend trend) {
    const auto [low, high] = std::minmax({coarse.value, middle.value, fine.value});
    const double size = scale > 0.0 ? scale : std::abs(fine.value);
    estimate.trend = trend;
    estimate.error.fill(size > 0.0 ? spread_margin * (high - low) / size : nan);
    return estimate;
  };
  if (no_first || no_second || (first > 0.0) != (second > 0.0)) {
    return without_order(Trend::not_monotone);
  }
  const double coarse_ratio = coarse.spacing / middle.spacing,
               fine_ratio = middle.spacing / fine.spacing;
  estimate.observed_order = solve_order(first / second, coarse_ratio, fine_ratio);
  if (estimate.observed_order < 1e-6) {  // 0 up to round-off of the bisection
    return without_order(Trend::not_converging);
  }
  estimate.order = std::clamp(estimate.observed_order, least_order, most_order);
  estimate.trend =
      estimate.order == estimate.observed_order ? Trend::converging : Trend::order_limited;
  const double limit = fine.value - second / std::expm1(estimate.order * std::log(fine_ratio));
  estimate.extrapolated = limit;
  const double size = scale > 0.0 ? scale : std::abs(limit);
  for (std::size_t k = 0; k < samples.size(); ++k) {
    estimate.error[k] = size > 0.0 ? std::abs(samples[k].value - limit) / size : nan;
  }
  return estimate;
}

std::optional<double> spacing_for(const ErrorEstimate& estimate,
                                  const std::array<ValueAtSpacing, 3>& samples, double target) {
  const double coarsest = samples.front().spacing, finest = samples.back().spacing;
  const double error = estimate.error.back();
  switch (estimate.trend) {
    case Trend::equal:
      return coarsest;
    case Trend::not_converging:
      return {};
    case Trend::not_monotone:
      return error <= target ? std::optional(coarsest) : std::nullopt;
    case Trend::converging:
    case Trend::order_limited:
      break;
  }
  if (!std::isfinite(error)) return {};
  if (error == 0.0) return coarsest;
  return std::min(coarsest, finest * std::pow(target / error, 1.0 / estimate.order));
}

double forecast_wall(double wall_s, double from, double to, int dimension) {
  return wall_s * std::pow(from / to, dimension + 1);
}

const char* word(Trend trend) {
  switch (trend) {
    case Trend::equal:
      return "equal";
    case Trend::converging:
      return "converging";
    case Trend::order_limited:
      return "order limited";
    case Trend::not_converging:
      return "not converging";
    case Trend::not_monotone:
      return "not monotone";
  }
  return "";
}

}  // namespace scarp
