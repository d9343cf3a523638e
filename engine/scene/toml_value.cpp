// SPDX-License-Identifier: BSD-3-Clause
/// Reading of typed values with complaints that name file, line, key, value, reason and remedy.
#include "engine/scene/toml_value.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <sstream>

#include "engine/plain_text.hpp"
#include "engine/scene/not_supported.hpp"
#include "engine/scene/units.hpp"

namespace scarp::input {
namespace {

std::string_view kind_of(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::table:
      return "a table";
    case toml::node_type::array:
      return "an array";
    case toml::node_type::string:
      return "text";
    case toml::node_type::integer:
      return "an integer";
    case toml::node_type::floating_point:
      return "a number";
    case toml::node_type::boolean:
      return "true or false";
    case toml::node_type::none:
      return "nothing";
    default:
      return "a date or time";
  }
}

/// "wall[0].motion" lies in the section "wall".
std::string_view section_of(std::string_view path) {
  return path.empty() ? "top" : path.substr(0, path.find_first_of("[."));
}

/// What to do about a word that is none of `known`.
template <class Names>
std::string advice(std::string_view path, std::string_view word, const Names& known) {
  const std::string_view missing = not_supported(section_of(path), word);
  return missing.empty() ? did_you_mean(word, known) : std::string(missing);
}

void append(std::string& text, const toml::node& node, std::size_t enough);

void append(std::string& text, const toml::array& array, std::size_t enough) {
  text += '[';
  for (const toml::node& element : array) {
    if (text.size() > enough) return;
    if (&element != &array.front()) text += ", ";
    append(text, element, enough);
  }
  text += ']';
}

void append(std::string& text, const toml::table& table, std::size_t enough) {
  text += '{';
  bool first = true;
  for (const auto& [key, value] : table) {
    if (text.size() > enough) return;
    if (!first) text += ", ";
    first = false;
    text += std::string(key.str()) + " = ";
    append(text, value, enough);
  }
  text += '}';
}

/// As it would be written in one line, with the fewest digits that tell a number; what lies beyond
/// `enough` letters is left out, as a node may be the whole file.
void append(std::string& text, const toml::node& node, std::size_t enough) {
  if (const toml::array* array = node.as_array()) return append(text, *array, enough);
  if (const toml::table* table = node.as_table()) return append(text, *table, enough);
  if (const auto* real = node.as_floating_point()) {
    const std::string digits = fmt::format("{}", real->get());
    const bool whole = digits.find_first_not_of("-0123456789") == std::string::npos;
    text += digits + (whole ? ".0" : "");
    return;
  }
  if (const auto* letters = node.as_string()) {
    text += '\'' + letters->get().substr(0, enough) + '\'';
    return;
  }
  std::ostringstream stream;
  node.visit([&stream](const auto& typed) {
    if constexpr (!toml::is_container<decltype(typed)>) stream << typed;
  });
  text += stream.str();
}

std::vector<std::string> split(std::string_view choices) {
  std::vector<std::string> names;
  std::size_t begin = 0;
  while (begin <= choices.size()) {
    const std::size_t end = std::min(choices.find('|', begin), choices.size());
    names.emplace_back(choices.substr(begin, end - begin));
    begin = end + 1;
  }
  return names;
}

}  // namespace

std::string one_line(std::string_view raw, std::size_t longest) {
  std::string text;
  for (const char letter : raw) {  // no control characters, no run of blanks
    const bool blank = static_cast<unsigned char>(letter) <= ' ' || letter == '\x7f';
    if (!blank) text += letter;
    if (blank && !text.empty() && text.back() != ' ') text += ' ';
  }
  text = plain_text(text);
  if (text.size() <= longest) return text;
  std::size_t end = longest;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;  // whole letters
  return text.substr(0, end) + "...";
}

std::string shown(const toml::node& node) {
  constexpr std::size_t longest = 60;
  std::string text;
  append(text, node, 2 * longest);
  return one_line(text, longest);
}

int line_of(const toml::node& node) {
  return static_cast<int>(std::max<toml::source_index>(1, node.source().begin.line));
}

void fail(const std::string& file, const toml::node& node, const std::string& path,
          const std::string& why) {
  const int line = line_of(node);
  const std::string reason = one_line(why, 1000);
  if (path.empty()) throw SceneError(fmt::format("{}:{}: {}", file, line, reason));
  throw SceneError(fmt::format("{}:{}: key '{}' = {}: {}", file, line, one_line(path, 100),
                               shown(node), reason));
}

void Value::fail(const std::string& why) const { input::fail(*file_, *node_, path_, why); }

void Value::wrong_type(std::string_view wanted, std::string_view example) const {
  fail(fmt::format("this is {}, but {} is needed. Try {}.", kind_of(*node_), wanted, example));
}

double Value::number(kernels::Unit unit) const {
  try {
    if (const auto real = node_->value_exact<double>()) return check_bare_number(*real, unit);
    if (const auto whole = node_->value_exact<std::int64_t>()) {
      return check_bare_number(static_cast<double>(*whole), unit);
    }
    if (is_text()) return parse_quantity(letters(), unit);
  } catch (const UnitError& error) {
    fail(error.what());
  }
  const std::string units = accepted_units(unit);
  wrong_type(quantity_name(unit),
             units.empty() ? "1.5" : fmt::format("a number, or text with one of {}", units));
}

int Value::integer() const {
  const auto whole = node_->value_exact<std::int64_t>();
  if (!whole) wrong_type("an integer", "2");
  if (std::abs(static_cast<double>(*whole)) > 1e9) fail("it is too large. Try less than 1e9.");
  return static_cast<int>(*whole);
}

bool Value::boolean() const {
  const auto truth = node_->value_exact<bool>();
  if (!truth) wrong_type("true or false", "true");
  return *truth;
}

std::string Value::letters() const {
  std::string words = node_->value_exact<std::string>().value_or("");
  // It would end the text of every exception in which the words stand.
  if (words.find('\0') != std::string::npos) fail("it holds \\u0000. Try text without it.");
  constexpr std::size_t longest = 1000;
  if (words.size() > longest) {
    fail(fmt::format("it has {} letters. Try at most {}.", words.size(), longest));
  }
  return words;
}

std::string Value::text() const {
  if (!is_text()) wrong_type("text", "\"text in quotes\"");
  std::string words = letters();
  if (words.empty()) fail("the text is empty. Try some letters.");
  return words;
}

std::size_t Value::choice(std::string_view choices) const {
  const std::vector<std::string> names = split(choices);
  if (!is_text()) wrong_type("one of a few words", fmt::format("\"{}\"", names.front()));
  const std::string word = text();
  const auto found = std::find(names.begin(), names.end(), word);
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  fail(fmt::format("it is none of {}. {}", fmt::join(names, ", "), advice(path_, word, names)));
}

std::vector<Value> Value::items() const {
  const toml::array* array = node_->as_array();
  if (array == nullptr) wrong_type("an array", "[ ... ]");
  if (array->empty()) fail("the array is empty. Try at least one item.");
  std::vector<Value> items;
  for (std::size_t i = 0; i < array->size(); ++i) {
    items.emplace_back(*array->get(i), fmt::format("{}[{}]", path_, i), *file_);
  }
  return items;
}

std::vector<double> Value::numbers(kernels::Unit unit, std::size_t count) const {
  const toml::array* array = node_->as_array();
  if (array == nullptr) wrong_type(fmt::format("an array of {} numbers", count), "[0.0, 1.0]");
  if (array->size() != count) {
    const bool integers = std::all_of(array->begin(), array->end(),
                                      [](const toml::node& item) { return item.is_integer(); });
    fail(fmt::format("the array has {} item(s), but {} are needed here. Try {}{}.", array->size(),
                     count, count == 2 ? "[first, second]" : "[x, y, z]",
                     array->size() > count && integers ? ", and 1.5 if a comma meant that" : ""));
  }
  std::vector<double> result;
  for (const Value& item : items()) result.push_back(item.number(unit));
  return result;
}

Table Value::table(const Keys& known) const {
  if (!is_table()) {
    const std::string example = known.empty() ? "{ }" : fmt::format("{{{} = ...}}", known.front());
    wrong_type("a table", example);
  }
  return Table(*this, known);
}

std::optional<Value> Value::peek(std::string_view key) const {
  const toml::table* table = node_->as_table();
  const toml::node* node = table == nullptr ? nullptr : table->get(key);
  if (node == nullptr) return std::nullopt;
  const std::string separator = path_.empty() ? "" : ".";
  return Value(*node, path_ + separator + std::string(key), *file_);
}

Keys Value::keys() const {
  Keys names;
  if (const toml::table* table = node_->as_table()) {
    for (const auto& entry : *table) names.push_back(entry.first.str());
  }
  return names;
}

int Value::line() const { return line_of(*node_); }

Table::Table(const Value& value, const Keys& known)
    : value_(value), table_(value.node_->as_table()) {
  for (const auto& [key, node] : *table_) {
    const std::string_view name = key.str();
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    input::fail(*value_.file_, node, path_of(name),
                fmt::format("unknown key. {}", advice(value_.path_, name, known)));
  }
}

std::string Table::path_of(std::string_view key) const {
  return value_.path_.empty() ? std::string(key) : fmt::format("{}.{}", value_.path_, key);
}

std::optional<Value> Table::find(std::string_view key) const { return value_.peek(key); }

Value Table::require(std::string_view key, std::string_view example) const {
  if (const auto value = find(key)) return *value;
  throw SceneError(fmt::format("{}:{}: key '{}' is missing. Try {} = {}.", *value_.file_,
                               value_.line(), path_of(key), key, example));
}

std::string_view Table::require_one_of(const Keys& keys) const {
  std::string_view found;
  for (const std::string_view key : keys) {
    if (!table_->contains(key)) continue;
    if (!found.empty()) find(key)->fail(fmt::format("'{}' is given as well. Try only one.", found));
    found = key;
  }
  if (!found.empty()) return found;
  fail(fmt::format("none of {} is given. Try one of them.", fmt::join(keys, ", ")));
}

}  // namespace scarp::input
