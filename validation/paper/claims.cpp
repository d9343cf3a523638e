// SPDX-License-Identifier: BSD-3-Clause
/// Verdicts over several readings.

#include "validation/paper/claims.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace scarp::validation {
namespace {

std::string word(const std::optional<bool>& holds) {
  return !holds ? "not measured" : *holds ? "holds" : "does not hold";
}

}  // namespace

ClaimLine judge_claim(const std::string& section, const std::string& quote,
                      const std::string& measure, const std::vector<NamedFinding>& findings) {
  const Finding& first = findings.front().finding;
  ClaimLine line{section, quote, measure, first.numbers, "not measured", {}};
  bool agree = true;
  for (auto other = findings.begin() + 1; other != findings.end(); ++other) {
    const Finding& finding = other->finding;
    agree &= !finding.holds || finding.holds == first.holds;
    const bool same = finding.holds == first.holds && finding.numbers == first.numbers;
    line.sensitivity += fmt::format(
        "{}{}: {}", line.sensitivity.empty() ? "" : " | ", other->reading,
        same ? "the same numbers" : fmt::format("{} ({})", word(finding.holds), finding.numbers));
  }
  if (first.holds) {
    line.verdict = !agree ? "sensitive" : *first.holds ? "confirmed" : "not confirmed";
  }
  return line;
}

std::optional<bool> if_measured(const std::vector<double>& numbers, bool holds) {
  const auto nan = [](double number) { return std::isnan(number); };
  if (std::any_of(numbers.begin(), numbers.end(), nan)) return {};
  return holds;
}

std::string claims_text(const std::vector<ClaimLine>& claims) {
  std::string text;
  for (const ClaimLine& line : claims) {
    text +=
        fmt::format("  {:<14}{} ({}): {}\n", line.verdict, line.quote, line.section, line.numbers);
  }
  return text;
}

}  // namespace scarp::validation
