// SPDX-License-Identifier: BSD-3-Clause
/// The paper's statements as lines: what is measured for each, the numbers, the verdict.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace scarp::validation {

/// What the runs say to one statement.
struct Finding {
  std::optional<bool> holds;  ///< empty: could not be measured
  std::string numbers;
};

/// One line of the table.
struct ClaimLine {
  std::string section;      ///< of the paper
  std::string quote;        ///< in a few of its words
  std::string measure;      ///< chosen for it
  std::string numbers;      ///< of the first reading
  std::string verdict;      ///< "confirmed", "not confirmed", "sensitive" or "not measured"
  std::string sensitivity;  ///< what the other readings say, " | " between them
};

/// A finding under the name of its reading.
struct NamedFinding {
  std::string reading;
  Finding finding;
};

/// The verdict is that of all readings that could be measured if they agree, else "sensitive"; "not
/// measured" if the first could not be.
ClaimLine judge_claim(const std::string& section, const std::string& quote,
                      const std::string& measure, const std::vector<NamedFinding>& findings);

/// Empty if one of the numbers is NaN.
std::optional<bool> if_measured(const std::vector<double>& numbers, bool holds);

/// The lines for a terminal; empty without any.
std::string claims_text(const std::vector<ClaimLine>& claims);

}  // namespace scarp::validation
