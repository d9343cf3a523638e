// SPDX-License-Identifier: BSD-3-Clause
/// The page of scene keys, taken apart.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace scarp::cli {

/// One key of a table: the titles of the columns and what stands in them.
struct KeyRow {
  std::string section;  ///< "[[material]]", "Top level"
  std::vector<std::string> keys;
  std::vector<std::string> titles, cells;
};

struct PageSection {
  std::string heading;                  ///< "[[material]]", "Top level"
  std::string name;                     ///< "material", "top"
  std::vector<std::string> paragraphs;  ///< without its tables
  std::vector<KeyRow> rows;
  std::string text;  ///< all of it
};

/// The sections of `engine/scene/SCENE.md` that describe keys, in their order.
std::vector<PageSection> sections_of(std::string_view page);

/// The row of the table of units for a quantity such as "pressure": "Pa kPa ..."; empty if it has
/// none.
std::string units_of(std::string_view page, std::string_view quantity);

/// Words in backticks of a text: `min` in "`box` = {`min`}".
std::vector<std::string> quoted_words(std::string_view text);

/// Without backticks, bars of escapes and links, for a terminal.
std::string without_marks(std::string_view markdown);

/// Broken at blanks into lines of at most `width` letters; all but the first begin with `indent`
/// blanks.
std::string wrapped(std::string_view text, std::size_t width, std::size_t indent);

}  // namespace scarp::cli
