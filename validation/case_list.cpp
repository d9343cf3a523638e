// SPDX-License-Identifier: BSD-3-Clause
/// Names of cases and sets.

#include "validation/case_list.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/errors.hpp"
#include "engine/scene/nearest_name.hpp"

namespace scarp::validation {

std::vector<const CaseRow*> select_cases(const std::vector<std::string>& names) {
  std::vector<const CaseRow*> chosen;
  for (const std::string& name : names) {
    const bool set = name == "paper" || name == "verification" || name == "all";
    bool known = set;
    for (const CaseRow& row : case_list) {
      if (row.name != name && !(set && (name == "all" || row.set == name))) continue;
      known = true;
      if (std::find(chosen.begin(), chosen.end(), &row) == chosen.end()) chosen.push_back(&row);
    }
    if (known) continue;
    std::vector<std::string> all{"paper", "verification", "all"};
    for (const CaseRow& row : case_list) all.emplace_back(row.name);
    throw Error(
        fmt::format("case '{}': there is no such case or set. {} ('scarp-validate list' "
                    "shows all.)",
                    name, did_you_mean(name, all)));
  }
  if (chosen.empty()) throw Error("there is no case in this set yet. Try 'scarp-validate list'.");
  return chosen;
}

}  // namespace scarp::validation
