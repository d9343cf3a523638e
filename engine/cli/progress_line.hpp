// SPDX-License-Identifier: BSD-3-Clause
/// How a program says on standard error where it stands.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace scarp::cli {

/// A bar that is drawn over on a terminal that can do so; else a plain line every few seconds: into
/// a file or a pipe, on a dumb terminal, and on one too narrow for a bar.
class ProgressLine {
 public:
  explicit ProgressLine(bool quiet) : quiet_(quiet) {}
  /// Whether it is time to say something again.
  bool due() const;
  /// `fraction` of the bar; `words` in the order of what matters most: a terminal shows as many as
  /// it has room for.
  void show(double fraction, const std::vector<std::string>& words);
  /// Ends the bar's line.
  void finish();

 private:
  using Clock = std::chrono::steady_clock;
  bool quiet_, drawn_ = false;
  Clock::time_point last_ = Clock::now();
};

/// The bar and as many of the words as fit into so many columns.
std::string bar_text(double fraction, const std::vector<std::string>& words, int columns);

/// Columns of the terminal on standard error if a bar can be drawn on it; else nothing.
std::optional<int> bar_columns();

}  // namespace scarp::cli
