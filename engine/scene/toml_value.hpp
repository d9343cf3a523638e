// SPDX-License-Identifier: BSD-3-Clause
/// TOML nodes that know their file, line and key path, so that every complaint can name them.
/// Private to the reader: no header of the library's interface includes it.
#pragma once

#ifndef TOML_HEADER_ONLY
#define TOML_HEADER_ONLY \
  0  // the compiled library: header-only assert builds abort on "[[" + newline
#endif
#include <toml++/toml.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/errors.hpp"
#include "engine/scene/nearest_name.hpp"
#include "kernels/constitutive/parameter_spec.hpp"

namespace scarp::input {

class Table;
using Keys = std::vector<std::string_view>;

/// Text for a message: control characters and line ends as blanks, cut at `longest` bytes.
std::string one_line(std::string_view raw, std::size_t longest);

/// A node as the user wrote it, short enough for a message.
std::string shown(const toml::node& node);

/// Where a node begins in the file, from 1.
int line_of(const toml::node& node);

/// "file:line: key 'a.b' = value: why"; the line is the node's.
[[noreturn]] void fail(const std::string& file, const toml::node& node, const std::string& path,
                       const std::string& why);

/// One value of the document. All readers throw SceneError when the value has another type or form.
class Value {
 public:
  Value(const toml::node& node, std::string path, const std::string& file)
      : node_(&node), path_(std::move(path)), file_(&file) {}

  bool is_table() const { return node_->is_table(); }
  bool is_number() const { return node_->is_number(); }
  bool is_text() const { return node_->is_string(); }

  double number(kernels::Unit unit) const;  ///< a number, or text with a unit [SI]
  int integer() const;
  bool boolean() const;
  std::string text() const;                            ///< not empty
  std::size_t choice(std::string_view choices) const;  ///< index into "a|b|c"
  std::vector<Value> items() const;                    ///< of an array with at least one item
  std::vector<double> numbers(kernels::Unit unit, std::size_t count) const;  ///< exactly `count`
  Table table(const Keys& known) const;  ///< unknown keys are errors
  /// An entry of a table whose known keys depend on it.
  std::optional<Value> peek(std::string_view key) const;
  Keys keys() const;  ///< of a table, else none
  int line() const;   ///< where it begins in the file, from 1

  [[noreturn]] void fail(const std::string& why) const;

 private:
  friend class Table;
  std::string letters() const;  ///< of text
  [[noreturn]] void wrong_type(std::string_view wanted, std::string_view example) const;

  const toml::node* node_;
  std::string path_;
  const std::string* file_;
};

/// A table all of whose keys are known.
class Table {
 public:
  Table(const Value& value, const Keys& known);

  std::optional<Value> find(std::string_view key) const;
  /// Errors: SceneError if the key is missing; `example` shows what to write.
  Value require(std::string_view key, std::string_view example) const;
  /// The one key present of several that exclude each other.
  std::string_view require_one_of(const Keys& keys) const;
  [[noreturn]] void fail(const std::string& why) const { value_.fail(why); }

 private:
  std::string path_of(std::string_view key) const;

  Value value_;
  const toml::table* table_;
};

}  // namespace scarp::input
