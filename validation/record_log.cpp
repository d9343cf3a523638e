// SPDX-License-Identifier: BSD-3-Clause
/// JSON-lines files.
#include "validation/record_log.hpp"

#include <fmt/format.h>

#include <cmath>
#include <fstream>

#include "engine/errors.hpp"

namespace scarp::validation {

using Json = nlohmann::ordered_json;

double number_or_nan(const Json& json) {
  return json.is_null() ? std::nan("") : json.get<double>();
}

std::vector<Json> open_lines(const std::filesystem::path& path) {
  std::vector<Json> objects;
  bool whole_lines = true;
  {
    std::ifstream stream(path);
    for (std::string line; std::getline(stream, line);) {
      whole_lines = !stream.eof();
      Json json = Json::parse(line, nullptr, false);
      if (json.is_object()) objects.push_back(std::move(json));
    }
  }
  std::ofstream stream(path, std::ios::app);
  if (!whole_lines) stream << '\n';  // what was cut short must not swallow the next line
  if (!stream.flush()) {
    throw FileError(
        fmt::format("'{}': cannot be written. Try another folder with -o.", path.string()));
  }
  return objects;
}

void append_line(const std::filesystem::path& path, const Json& object) {
  std::ofstream stream(path, std::ios::app);
  stream << object.dump(-1, ' ', false, Json::error_handler_t::replace) << '\n';
  if (!stream.flush()) throw FileError(fmt::format("'{}': cannot be written.", path.string()));
}

}  // namespace scarp::validation
