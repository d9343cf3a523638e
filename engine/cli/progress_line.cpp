// SPDX-License-Identifier: BSD-3-Clause
/// Bars and plain lines.
#include "engine/cli/progress_line.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace scarp::cli {
namespace {

constexpr int bar_width = 24, least_columns = 60, usual_columns = 80;

}  // namespace

std::optional<int> bar_columns() {
  if (isatty(STDERR_FILENO) == 0) return {};
  const char* kind = std::getenv("TERM");
  const std::string_view terminal = kind != nullptr ? kind : "";
  if (terminal.empty() || terminal == "dumb") return {};
  winsize size{};
  const bool known = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  const int columns = known ? size.ws_col : usual_columns;
  return columns >= least_columns ? std::optional(columns) : std::nullopt;
}

std::string bar_text(double fraction, const std::vector<std::string>& words, int columns) {
  const int filled = static_cast<int>(std::lround(fraction * bar_width));
  std::string text = fmt::format("[{:#<{}}{:.<{}}]", "", filled, "", bar_width - filled);
  for (const std::string& word : words) {
    // In the last column some terminals begin a new line, which a carriage return does not leave.
    if (static_cast<int>(text.size() + 2 + word.size()) >= columns) break;
    text += "  " + word;
  }
  return text;
}

bool ProgressLine::due() const {
  if (quiet_) return false;
  const double silent = std::chrono::duration<double>(Clock::now() - last_).count();
  return silent >= 5.0 || (silent >= 0.2 && bar_columns());
}

void ProgressLine::show(double fraction, const std::vector<std::string>& words) {
  if (quiet_) return;
  last_ = Clock::now();
  if (const std::optional<int> columns = bar_columns()) {
    fmt::print(stderr, "\r\033[K{}", bar_text(fraction, words, *columns));
    drawn_ = true;
  } else {
    finish();
    fmt::print(stderr, "{}\n", fmt::join(words, "  "));
  }
  std::fflush(stderr);
}

void ProgressLine::finish() {
  if (drawn_) fmt::print(stderr, "\n");
  drawn_ = false;
}

}  // namespace scarp::cli
