// SPDX-License-Identifier: BSD-3-Clause
/// `scarp explain`: what SCENE.md says of one key or section.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "engine/cli/commands.hpp"
#include "engine/cli/scene_page.hpp"
#include "engine/cli/texts.hpp"
#include "engine/plain_text.hpp"
#include "engine/scene/nearest_name.hpp"

namespace scarp::cli {
namespace {

constexpr std::size_t width = 100;

/// "material[0].cohesion" as "material", "cohesion".
std::vector<std::string> parts_of(const std::string& key) {
  std::vector<std::string> parts(1);
  bool index = false;
  for (const char letter : key) {
    if (letter == '.') {
      parts.emplace_back();
    } else if (letter == '[' || letter == ']') {
      index = letter == '[';
    } else if (!index || letter < '0' || letter > '9') {
      parts.back() += letter;
    }
  }
  return parts;
}

bool holds(const std::vector<std::string>& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

void print_row(const KeyRow& row, std::string_view page) {
  fmt::print("{}{}\n", row.section.starts_with('[') ? row.section + " " : "",
             without_marks(row.cells.front()));
  std::size_t widest = 5;  // "units"
  for (std::size_t c = 1; c < row.titles.size(); ++c)
    widest = std::max(widest, without_marks(row.titles[c]).size());
  const std::size_t column = widest + 4;
  const auto line = [column](std::string_view title, std::string_view text) {
    fmt::print("  {:<{}}{}\n", title, column - 2, wrapped(text, width, column));
  };
  for (std::size_t c = 1; c < row.cells.size() && c < row.titles.size(); ++c) {
    if (row.cells[c].empty()) continue;
    line(without_marks(row.titles[c]), without_marks(row.cells[c]));
    if (row.titles[c] != "type") continue;
    if (const std::string units = units_of(page, row.cells[c]); !units.empty())
      line("units", units);
  }
}

/// What a section says of a key; false if nothing.
bool print_key(const PageSection& section, const std::string& key, std::string_view page) {
  bool said = false;
  for (const KeyRow& row : section.rows) {
    if (!holds(row.keys, key)) continue;
    print_row(row, page);
    said = true;
  }
  for (const std::string& paragraph : section.paragraphs) {
    const std::vector<std::string> words = quoted_words(paragraph);
    const auto about = [&](const std::string& word) {
      return word == key || word.starts_with(key + " =");
    };
    if (std::none_of(words.begin(), words.end(), about)) continue;
    if (!said) fmt::print("{} {}\n", section.heading, key);
    fmt::print("  {}\n", wrapped(without_marks(paragraph), width, 2));
    said = true;
  }
  if (said) fmt::print("\n");
  return said;
}

void print_section(const PageSection& section, std::string_view page) {
  fmt::print("{}\n\n", section.heading);
  for (const std::string& paragraph : section.paragraphs)
    fmt::print("  {}\n\n", wrapped(without_marks(paragraph), width, 2));
  for (const KeyRow& row : section.rows) print_row(row, page);
}

void list_keys(const std::vector<PageSection>& sections) {
  for (const PageSection& section : sections) {
    std::vector<std::string> keys;
    for (const KeyRow& row : section.rows)
      keys.insert(keys.end(), row.keys.begin(), row.keys.end());
    const std::string heading = fmt::format("{:<14}", section.heading);
    fmt::print("{}{}\n", heading, wrapped(fmt::format("{}", fmt::join(keys, " ")), width, 14));
  }
  fmt::print("scarp explain KEY says what a key means, scarp explain stage all of a section.\n");
}

[[noreturn]] void refuse(const std::string& key, const std::vector<PageSection>& sections) {
  std::vector<std::string> names;
  for (const PageSection& section : sections) {
    names.push_back(section.name);
    for (const KeyRow& row : section.rows)
      names.insert(names.end(), row.keys.begin(), row.keys.end());
  }
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  throw UsageError(fmt::format("key: a scene has no '{}'. {}", plain_text(key),
                               did_you_mean(parts_of(key).back(), names)));
}

}  // namespace

int explain_command(const std::string& key) {
  const std::string_view page = scene_pages.front().text;
  const std::vector<PageSection> sections = sections_of(page);
  if (key.empty()) {
    list_keys(sections);
    return ok;
  }
  const std::vector<std::string> parts = parts_of(key);
  const auto named =
      std::find_if(sections.begin(), sections.end(),
                   [&](const PageSection& section) { return section.name == parts.front(); });
  if (named != sections.end() && parts.size() == 1) {
    print_section(*named, page);
    return ok;
  }
  bool said = false;
  if (named != sections.end()) {
    said = print_key(*named, parts[1], page);
  } else {
    for (const PageSection& section : sections) said |= print_key(section, parts.front(), page);
  }
  if (!said) refuse(key, sections);
  return ok;
}

}  // namespace scarp::cli
