// SPDX-License-Identifier: BSD-3-Clause
/// As much of Markdown as SCENE.md uses: headings, tables, paragraphs.
#include "engine/cli/scene_page.hpp"

#include <algorithm>

namespace scarp::cli {
namespace {

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

std::vector<std::string> cells_of(std::string_view line) {
  std::vector<std::string> cells;
  line.remove_prefix(1);
  while (!line.empty()) {
    const std::size_t bar = line.find('|');
    if (bar == std::string_view::npos) break;
    cells.emplace_back(trimmed(line.substr(0, bar)));
    line.remove_prefix(bar + 1);
  }
  return cells;
}

bool is_rule(std::string_view line) {
  return line.find_first_not_of("|-: ") == std::string_view::npos;
}

/// "material" of "[[material]]", "top" of "Top level".
std::string name_of(std::string_view heading) {
  if (heading == "Top level") return "top";
  std::string name(heading);
  std::erase_if(name, [](char letter) { return letter == '[' || letter == ']'; });
  return name;
}

/// Calls `use` with each line, without its end.
template <class Use>
void each_line(std::string_view text, const Use& use) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    use(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

/// Takes one section together, line by line.
class SectionReader {
 public:
  explicit SectionReader(PageSection& section) : section_(section) {}

  void take(std::string_view line) {
    if (!line.starts_with('|')) titles_.clear();
    if (line.empty()) {
      new_paragraph_ = true;
    } else if (line.starts_with('|')) {
      take_row(line);
      new_paragraph_ = true;
    } else if (new_paragraph_) {
      section_.paragraphs.emplace_back(line);
      new_paragraph_ = false;
    } else {
      section_.paragraphs.back().append(" ").append(line);
    }
  }

 private:
  void take_row(std::string_view line) {
    if (is_rule(line)) return;
    std::vector<std::string> cells = cells_of(line);
    if (titles_.empty()) {
      titles_ = std::move(cells);
      return;
    }
    section_.rows.push_back({section_.heading, quoted_words(cells.front()), titles_, cells});
  }

  PageSection& section_;
  std::vector<std::string> titles_;
  bool new_paragraph_ = true;
};

}  // namespace

std::vector<PageSection> sections_of(std::string_view page) {
  std::vector<PageSection> found;
  bool inside = false;
  each_line(page, [&](std::string_view line) {
    if (line.starts_with("## ")) {
      const std::string_view heading = line.substr(3);
      inside = heading == "Top level" || heading.starts_with('[');
      if (inside) found.push_back({std::string(heading), name_of(heading), {}, {}, {}});
    } else if (inside) {
      found.back().text.append(line).append("\n");
    }
  });
  for (PageSection& section : found) {
    SectionReader reader(section);
    each_line(section.text, [&reader](std::string_view line) { reader.take(line); });
  }
  return found;
}

std::string units_of(std::string_view page, std::string_view quantity) {
  std::string found;
  each_line(page, [&](std::string_view line) {
    if (!line.starts_with('|') || !found.empty()) return;
    const std::vector<std::string> cells = cells_of(line);
    if (cells.size() == 2 && cells.front() == quantity) found = without_marks(cells.back());
  });
  return found;
}

std::vector<std::string> quoted_words(std::string_view text) {
  std::vector<std::string> words;
  for (;;) {
    const std::size_t begin = text.find('`');
    if (begin == std::string_view::npos) return words;
    const std::size_t end = text.find('`', begin + 1);
    if (end == std::string_view::npos) return words;
    words.emplace_back(text.substr(begin + 1, end - begin - 1));
    text.remove_prefix(end + 1);
  }
}

std::string without_marks(std::string_view markdown) {
  std::string text(markdown);
  std::erase(text, '`');
  return text;
}

std::string wrapped(std::string_view text, std::size_t width, std::size_t indent) {
  std::string result;
  std::size_t column = indent;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    const std::string_view word = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (word.empty()) continue;
    if (column > indent && column + 1 + word.size() > width) {
      result.append("\n").append(indent, ' ');
      column = indent;
    } else if (column > indent) {
      result += ' ';
      ++column;
    }
    result.append(word);
    column += word.size();
  }
  return result;
}

}  // namespace scarp::cli
