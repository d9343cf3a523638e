// SPDX-License-Identifier: BSD-3-Clause
/// UTF-8 letter by letter.
#include "engine/plain_text.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <iterator>

namespace scarp {
namespace {

struct Letter {
  std::uint32_t code = 0;
  std::size_t bytes = 0;  // 0: no UTF-8
};

/// The first letter of a text that is not empty.
Letter first_letter(std::string_view text) {
  const auto byte = [&text](std::size_t at) { return static_cast<std::uint32_t>(text[at]) & 0xFF; };
  const std::uint32_t lead = byte(0);
  if (lead < 0x80) return {lead, 1};
  const std::size_t bytes = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || text.size() < bytes) return {};
  std::uint32_t code = lead & (0x7FU >> bytes);
  for (std::size_t k = 1; k < bytes; ++k) {
    if ((byte(k) & 0xC0) != 0x80) return {};
    code = code << 6 | (byte(k) & 0x3F);
  }
  constexpr std::uint32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
  if (code < least[bytes] || surrogate || code > 0x10FFFF) return {};
  return {code, bytes};
}

bool acts(std::uint32_t code) {
  const auto in = [code](std::uint32_t low, std::uint32_t high) {
    return code >= low && code <= high;
  };
  return code < 0x20 || in(0x7F, 0x9F) || code == 0x200B || in(0x200E, 0x200F) ||
         in(0x2028, 0x202E) || in(0x2060, 0x2069) || code == 0xFEFF || code == 0x061C;
}

}  // namespace

std::string plain_text(std::string_view raw) {
  std::string text;
  while (!raw.empty()) {
    const Letter letter = first_letter(raw);
    const std::size_t bytes = letter.bytes == 0 ? 1 : letter.bytes;
    if (letter.bytes == 0 || (acts(letter.code) && letter.code < 0x80 && raw[0] != '\n')) {
      fmt::format_to(std::back_inserter(text), "\\x{:02x}", static_cast<unsigned char>(raw[0]));
    } else if (acts(letter.code) && letter.code >= 0x80) {
      fmt::format_to(std::back_inserter(text), "\\u{:04x}", letter.code);
    } else {
      text += raw.substr(0, bytes);
    }
    raw.remove_prefix(bytes);
  }
  return text;
}

bool has_control(std::string_view raw) {
  while (!raw.empty()) {
    const Letter letter = first_letter(raw);
    if (letter.bytes == 0 || acts(letter.code)) return true;
    raw.remove_prefix(letter.bytes);
  }
  return false;
}

std::string readable_duration(double seconds) {
  if (!std::isfinite(seconds) || seconds > 3.6e8) return "unknown";
  const auto s = static_cast<long>(std::lround(std::fmax(seconds, 0.0)));
  if (s >= 86400) return fmt::format("{} d {:02} h", s / 86400, s % 86400 / 3600);
  if (s >= 3600) return fmt::format("{} h {:02} min", s / 3600, s % 3600 / 60);
  if (s >= 60) return fmt::format("{} min {:02} s", s / 60, s % 60);
  return seconds < 10.0 ? fmt::format("{:.1f} s", std::fmax(seconds, 0.0)) : fmt::format("{} s", s);
}

std::string readable_bytes(double bytes) {
  const double mebibytes = bytes / (1024.0 * 1024.0);
  return mebibytes < 1024.0 ? fmt::format("{:.3g} MiB", mebibytes)
                            : fmt::format("{:.3g} GiB", mebibytes / 1024.0);
}

}  // namespace scarp
