// SPDX-License-Identifier: BSD-3-Clause
/// Lines "section.key = value" of a scene's values.
#pragma once

#include <iterator>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace scarp {

/// Numbers are written exactly, choices as the numbers of their enumerators.
class TextLines {
 public:
  template <class T>
  void add(std::string_view key, const T& value) {
    if constexpr (std::is_enum_v<T>) {
      add(key, static_cast<int>(value));
    } else {
      fmt::format_to(std::back_inserter(text_), "{}{} = {}\n", section_, key, value);
    }
  }
  void section(std::string name) { section_ = std::move(name); }
  std::string take() { return std::move(text_); }

 private:
  std::string section_, text_;
};

}  // namespace scarp
