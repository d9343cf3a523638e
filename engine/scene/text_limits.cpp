// SPDX-License-Identifier: BSD-3-Clause
/// One pass over a scene's text: where quotes and comments begin and end, and what is too much
/// outside of them.
#include "engine/scene/text_limits.hpp"

#include <fmt/format.h>

#include "engine/errors.hpp"

namespace scarp::input {
namespace {

/// Counts what the parser would have to follow; sees only what is outside of quotes and comments.
class Structure {
 public:
  /// What is too much, with advice; empty: nothing is.
  std::string take(char letter) {
    switch (letter) {
      case '\n':
        end_line();
        return {};
      case '.':
        return take_dot();
      case '[':
      case '{':
        return open(letter);
      case ']':
      case '}':
        if (!open_.empty()) open_.pop_back();
        parts_ = 1;
        in_value_ = true;  // no name can follow before a comma or the end of the line
        return {};
      case '=':
        in_value_ = true;
        return take_value();
      case ',':
        in_value_ = !open_.empty() && open_.back() == '[';
        return take_value();
      default:
        return {};
    }
  }

 private:
  void end_line() {
    parts_ = 1;
    if (in_header_) open_.clear();
    in_header_ = false;
    if (open_.empty()) in_value_ = false;
  }

  std::string open(char bracket) {
    if (open_.empty() && !in_value_) in_header_ = true;
    open_ += bracket;
    if (bracket == '{') in_value_ = false;
    if (open_.size() > most_nested) {
      return fmt::format("more than {} brackets are open. Try to close them; a scene needs five.",
                         most_nested);
    }
    return take_value();
  }

  std::string take_dot() {
    if (++parts_ > most_name_parts) {
      return fmt::format("a name has more than {} parts. Try one that SCENE.md lists.",
                         most_name_parts);
    }
    if (!in_value_ && ++dots_ > most_name_dots) {
      return fmt::format("more than {} dots stand in names. Try [[body]] and tables in braces.",
                         most_name_dots);
    }
    return {};
  }

  std::string take_value() {
    parts_ = 1;
    if (++values_ > most_values) {
      return fmt::format(
          "the file has more than {} values. Try fewer points: none is needed within a spacing of "
          "another.",
          most_values);
    }
    return {};
  }

  std::string open_;  // brackets that are not closed yet
  bool in_value_ = false, in_header_ = false;
  std::size_t parts_ = 1, dots_ = 0, values_ = 0;
};

}  // namespace

void check_text(std::string_view text, const std::string& name) {
  enum class In { plain, comment, basic, literal } in = In::plain;
  bool tripled = false;  // inside """ or '''
  std::size_t line = 1;
  Structure structure;
  for (std::size_t i = text.starts_with("\xEF\xBB\xBF") ? 3 : 0; i < text.size(); ++i) {
    const char letter = text[i];
    const char quote = in == In::basic ? '"' : '\'';
    if (letter == '\n') {
      ++line;
      if (!tripled) in = In::plain;
      if (in == In::plain) structure.take(letter);
    } else if (in == In::plain) {
      // Keys are ASCII; elsewhere such a byte would reach a part of the parser's letter tables that
      // is undefined for it.
      if (static_cast<unsigned char>(letter) >= 0x80) {
        throw SceneError(
            fmt::format("{}:{}: a letter outside ASCII stands outside of quotes. Try ASCII for "
                        "keys, and quotes around text.",
                        name, line));
      }
      const std::string fault = structure.take(letter);
      if (!fault.empty()) throw SceneError(fmt::format("{}:{}: {}", name, line, fault));
      if (letter == '#') in = In::comment;
      if (letter != '"' && letter != '\'') continue;
      in = letter == '"' ? In::basic : In::literal;
      tripled = text.substr(i, 3) == std::string(3, letter);
      if (tripled) i += 2;
    } else if (in == In::basic && letter == '\\') {
      if (i + 1 < text.size() && text[i + 1] != '\n') ++i;
    } else if (in != In::comment && letter == quote) {
      if (tripled && text.substr(i, 3) != std::string(3, quote)) continue;
      if (tripled) i += 2;
      // Text may end in quotes, two at most.
      for (int k = 0; tripled && k < 2 && text.substr(i + 1, 1) == std::string(1, quote); ++k) ++i;
      tripled = false;
      in = In::plain;
    }
  }
}

}  // namespace scarp::input
