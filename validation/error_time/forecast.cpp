// SPDX-License-Identifier: BSD-3-Clause
/// Run times by the nearest run that is known.

#include "validation/error_time/forecast.hpp"

#include <cstdlib>

#include "engine/converge/richardson.hpp"

namespace scarp::validation {

Forecast::Forecast(std::vector<double> spacings, int dimension)
    : spacings_(std::move(spacings)), dimension_(dimension) {}

std::optional<double> Forecast::nearest(const Setting& setting, std::size_t level) const {
  std::optional<double> wall;
  std::size_t least = spacings_.size();
  for (std::size_t k = 0; k < spacings_.size(); ++k) {
    const auto found = known_.find({setting, k});
    const std::size_t apart = k > level ? k - level : level - k;
    if (found == known_.end() || apart >= least) continue;
    least = apart;
    wall = forecast_wall(found->second, spacings_[k], spacings_[level], dimension_);
  }
  return wall;
}

std::optional<double> Forecast::of(const Trial& trial) const {
  const std::optional<double> own = nearest(trial.setting, trial.level);
  return own ? own : nearest({trial.setting.preset, {}}, trial.level);
}

}  // namespace scarp::validation
