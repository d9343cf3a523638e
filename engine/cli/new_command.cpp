// SPDX-License-Identifier: BSD-3-Clause
/// `scarp new`: a scene to begin with.

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "engine/cli/commands.hpp"
#include "engine/cli/texts.hpp"
#include "engine/errors.hpp"
#include "engine/output/text_file.hpp"
#include "engine/plain_text.hpp"
#include "engine/scene/nearest_name.hpp"

namespace scarp::cli {
namespace {

/// The comment at the head of a template, without its "# ".
std::string head_of(std::string_view text) {
  std::string head;
  while (text.starts_with("# ")) {
    const std::size_t end = text.find('\n');
    head += head.empty() ? "" : " ";
    head += text.substr(2, end - 2);
    text.remove_prefix(end + 1);
  }
  return head;
}

}  // namespace

const Text& template_named(const std::string& name) {
  const auto found = std::find_if(templates.begin(), templates.end(),
                                  [&](const Text& one) { return one.name == name; });
  if (found != templates.end()) return *found;
  std::vector<std::string_view> names;
  for (const Text& one : templates) names.push_back(one.name);
  throw UsageError(fmt::format("template: there is no '{}'. {}", name, did_you_mean(name, names)));
}

int new_command(const NewArguments& arguments) {
  if (arguments.name.empty()) {
    for (const Text& one : templates) {
      const std::string head = head_of(one.text);
      fmt::print("{:<15}{}\n", one.name, head.substr(0, head.find('.') + 1));
    }
    fmt::print("scarp new TEMPLATE [FILE] writes one.\n");
    return ok;
  }
  const Text& chosen = template_named(arguments.name);
  if (arguments.file == "-") {
    fmt::print("{}", chosen.text);
    return ok;
  }
  const std::filesystem::path file = arguments.file.empty()
                                         ? std::filesystem::path(arguments.name + ".toml")
                                         : std::filesystem::path(arguments.file);
  std::error_code ignored;
  if (std::filesystem::exists(std::filesystem::symlink_status(file, ignored))) {
    throw FileError(
        fmt::format("'{}': is there already, and nothing was written. Try another name: "
                    "scarp new {} FILE.",
                    file.string(), arguments.name));
  }
  write_to_target(file.string(), std::string(chosen.text));
  const std::string shown = plain_text(file.string());
  fmt::print("{}: written. {}\nNext: scarp check {}, then scarp run {}\n", shown,
             head_of(chosen.text), shown, shown);
  return ok;
}

}  // namespace scarp::cli
