// SPDX-License-Identifier: GPL-2.0-only
/// Stands in for the copy of fmt that the headers of LAMMPS name and Debian does not ship. They
/// only need it to be declared: none of what it would format is called from here.
#pragma once

#include <string>

namespace fmt {

class string_view {
 public:
  string_view(const char* text);
  string_view(const std::string& text);
};
class format_args {};
template <class... Args>
format_args make_args_checked(const string_view& format, const Args&... args);

}  // namespace fmt
