// SPDX-License-Identifier: BSD-3-Clause
/// How fast soil still moves, and how far that can take it.
#pragma once

#include <algorithm>
#include <deque>
#include <iterator>
#include <optional>

namespace scarp {

/// Displacement of the fastest-moving soil over a trailing span of time.
class Rate {
 public:
  explicit Rate(double span) : span_(span) {}
  void sample(double time, double displacement) {
    samples_.push_back({time, displacement});
    while (samples_.size() > 1 && samples_[1].time <= time - span_) samples_.pop_front();
  }
  /// [m/s], of the largest rise within the span; empty before a whole span has gone by.
  std::optional<double> value() const {
    if (!spans()) return {};
    return rise(samples_.begin(), samples_.end());
  }
  /// How far it still moves within `left` [m]: at the rate of the span, or, where it was slower in
  /// the second half than in the first, until it stops if it goes on to slow down so. Empty before
  /// a whole span has gone by.
  std::optional<double> still_to_go(double left) const {
    if (!spans()) return {};
    const double at_rate = rise(samples_.begin(), samples_.end()) * left;
    const double middle = samples_.back().time - 0.5 * span_;
    const auto half = std::find_if(samples_.begin(), samples_.end(),
                                   [middle](const Sample& s) { return s.time >= middle; });
    if (half == samples_.begin() || std::next(half) == samples_.end()) return at_rate;
    const double before = rise(samples_.begin(), std::next(half)), now = rise(half, samples_.end());
    if (!(now < before)) return at_rate;
    const double until_stop = now * 0.5 * span_ / (before - now);
    return std::min(at_rate, now * until_stop);
  }

 private:
  struct Sample {
    double time, displacement;
  };
  using Place = std::deque<Sample>::const_iterator;
  bool spans() const {
    return !samples_.empty() && samples_.back().time - samples_.front().time >= 0.999 * span_;
  }
  static double rise(const Place& first, const Place& end) {
    const auto [low, high] = std::minmax_element(first, end, [](const Sample& a, const Sample& b) {
      return a.displacement < b.displacement;
    });
    return (high->displacement - low->displacement) / (std::prev(end)->time - first->time);
  }
  double span_;
  std::deque<Sample> samples_;
};

}  // namespace scarp
