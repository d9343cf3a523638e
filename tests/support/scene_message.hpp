// SPDX-License-Identifier: BSD-3-Clause
/// The form that every complaint about a scene keeps, whatever the scene.
#pragma once

#include <cctype>
#include <string>
#include <string_view>

namespace scarp {

/// What breaks the form "name:line: reason. Try ...", in one readable line; empty if nothing does.
inline std::string fault_of_message(std::string_view message, std::string_view name) {
  if (message.size() > 2000) return "longer than anybody reads";
  for (const char letter : message) {
    if (static_cast<unsigned char>(letter) < 0x20) return "holds a control character";
  }
  if (!message.starts_with(name)) return "does not begin with the file";
  std::size_t at = name.size();
  if (message.substr(at, 1) != ":") return "no line after the file";
  const std::size_t digits = ++at;
  while (at < message.size() && std::isdigit(static_cast<unsigned char>(message[at])) != 0) ++at;
  if (at == digits || message[digits] == '0') return "no line after the file";
  if (message.substr(at, 2) != ": ") return "no reason after the line";
  if (message.find("Try ") == std::string_view::npos &&
      message.find("Did you mean '") == std::string_view::npos) {
    return "no advice";
  }
  return "";
}

}  // namespace scarp
