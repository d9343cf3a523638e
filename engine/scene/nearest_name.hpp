// SPDX-License-Identifier: BSD-3-Clause
/// "Did you mean": the candidate nearest to a mistyped word.
#pragma once

#include <algorithm>
#include <numeric>
#include <string>
#include <string_view>
#include <vector>

namespace scarp {

/// Number of single-letter edits, swaps of neighbours included, that turn `a` into `b`.
inline std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before, above(b.size() + 1), row(b.size() + 1);
  std::iota(above.begin(), above.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + (a[i - 1] != b[j - 1])});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
    before = above;
    std::swap(above, row);
  }
  return above[b.size()];
}

/// "Did you mean 'x'?" for a word at most a third of its letters away, else "Try one of a, b, c."
template <class Names>
std::string did_you_mean(std::string_view word, const Names& candidates) {
  std::string nearest, list;
  std::size_t best = word.size() <= 64 ? std::max<std::size_t>(2, word.size() / 3) + 1 : 0;
  for (const auto& candidate : candidates) {
    const std::string_view name(candidate);
    list += list.empty() ? "" : ", ";
    list += name;
    const std::size_t distance = best == 0 ? 0 : edit_distance(word, name);
    if (distance < best && distance < name.size()) {
      best = distance;
      nearest = name;
    }
  }
  if (list.empty()) return "Try to define one first.";
  return nearest.empty() ? "Try one of " + list + "." : "Did you mean '" + nearest + "'?";
}

}  // namespace scarp
