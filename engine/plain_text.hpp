// SPDX-License-Identifier: BSD-3-Clause
/// Text that terminals, pages and tables only show.
#pragma once

#include <string>
#include <string_view>

namespace scarp {

/// UTF-8 without what acts on a terminal or hides text: control characters but the line end, marks
/// of direction, line separators and bytes that are no UTF-8 become "\x1b", "\u202e".
std::string plain_text(std::string_view raw);

/// Whether `plain_text` would change something, or it has a line end.
bool has_control(std::string_view raw);

/// "1 h 05 min", "3 min 20 s", "12 s".
std::string readable_duration(double seconds);

/// "1.25 GiB", "310 MiB".
std::string readable_bytes(double bytes);

}  // namespace scarp
