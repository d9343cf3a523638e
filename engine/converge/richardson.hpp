// SPDX-License-Identifier: BSD-3-Clause
/// Estimates the error of a value from three spacings, by Richardson extrapolation.
#pragma once

#include <array>
#include <limits>
#include <optional>

namespace scarp {

/// How a value behaves from coarse to fine.
enum class Trend {
  equal,           ///< the three agree to round-off: nothing left to refine
  converging,      ///< monotone, order within the limits below
  order_limited,   ///< monotone, but the observed order was above or below the limits
  not_converging,  ///< monotone, but the differences do not shrink as fast as any positive order
                   ///< asks
  not_monotone,    ///< up and down, or a difference of nothing
};

/// In words for tables and files: "equal", "converging", "order limited", ...
const char* word(Trend trend);

/// Orders that are extrapolated with: at most that of the method, at least one that still names an
/// error (the limits of Oberkampf and Roy 2010).
inline constexpr double least_order = 0.5, most_order = 2.0;

/// Without an order the error is counted as this many times the spread of the three values: a
/// margin by choice, because nothing then says how far the limit lies outside them.
inline constexpr double spread_margin = 3.0;

struct ValueAtSpacing {
  double spacing = 0.0;  ///< [m]
  double value = 0.0;
};

/// Errors are relative, positive fractions, NaN where none can be named.
struct ErrorEstimate {
  Trend trend = Trend::equal;
  double observed_order = std::numeric_limits<double>::quiet_NaN();  ///< NaN: not monotone
  double order = std::numeric_limits<double>::quiet_NaN();           ///< the one extrapolated with
  std::optional<double> extrapolated;                                ///< to spacing 0
  std::array<double, 3> error{};                                     ///< at each spacing
};

/// Fits f = f0 + C h^p: p from (f1 - f2)/(f2 - f3) = (h1^p - h2^p)/(h2^p - h3^p), then f0 from the
/// two finest values with p within the limits. Where there is no positive p the error is
/// `spread_margin` times the spread, at every spacing. `scale` is what errors are relative to; 0:
/// the extrapolated value, else the finest. Pre: spacings fall, all above 0. Values that are not
/// finite give NaN.
ErrorEstimate estimate_error(const std::array<ValueAtSpacing, 3>& coarse_to_fine,
                             double scale = 0.0);

/// The spacing at which the error falls to `target`, from e = e3 (h/h3)^p; never above the coarsest
/// one, of which nothing coarser is known. Empty where the estimate cannot say.
std::optional<double> spacing_for(const ErrorEstimate& estimate,
                                  const std::array<ValueAtSpacing, 3>& coarse_to_fine,
                                  double target);

/// Run time at another spacing, by particles times steps: t (from/to)^(dimension + 1) [s].
double forecast_wall(double wall_s, double from, double to, int dimension);

}  // namespace scarp
