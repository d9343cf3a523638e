// SPDX-License-Identifier: BSD-3-Clause
/// What no text of a scene may hold, found before the parser sees it.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace scarp::input {

inline constexpr std::size_t largest_file = std::size_t{16} << 20;  ///< [bytes]

// The parser follows names and brackets by calling itself, and searches a list of all dotted names
// at each of them: without these limits bytes can be found that end the program, or take hours.
inline constexpr std::size_t most_name_parts = 16;     ///< a.b.c has three
inline constexpr std::size_t most_nested = 16;         ///< brackets and braces in each other
inline constexpr std::size_t most_name_dots = 10'000;  ///< in all names of a file
inline constexpr std::size_t most_values = 1'000'000;  ///< in a file

/// Errors: SceneError for a letter outside ASCII that stands outside of quotes and comments, and
/// for what is above a limit; `name` stands for the file. One pass over the text, no recursion.
void check_text(std::string_view text, const std::string& name);

}  // namespace scarp::input
