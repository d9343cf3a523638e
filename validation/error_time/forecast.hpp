// SPDX-License-Identifier: BSD-3-Clause
/// What runs still to come will take, from those that have been.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "validation/error_time/settings.hpp"

namespace scarp::validation {

/// Scales by particles times steps: spacing^-(dimension + 1).
class Forecast {
 public:
  Forecast(std::vector<double> spacings, int dimension);

  void note(const Trial& trial, double wall_s) { known_[trial] = wall_s; }

  /// Expected run time [s]: the setting's own, else its own at the nearest spacing, else that of
  /// its preset; empty before anything of the preset has run.
  std::optional<double> of(const Trial& trial) const;

 private:
  std::optional<double> nearest(const Setting& setting, std::size_t level) const;

  std::vector<double> spacings_;
  int dimension_;
  std::map<Trial, double> known_;
};

}  // namespace scarp::validation
