// SPDX-License-Identifier: BSD-3-Clause
/// outcome.json.

#include "validation/paper/outcome.hpp"

#include <fstream>
#include <nlohmann/json.hpp>

#include "engine/output/text_file.hpp"

namespace scarp::validation {
namespace {

using Json = nlohmann::ordered_json;

std::filesystem::path file_in(const std::filesystem::path& folder) {
  return folder / "outcome.json";
}

}  // namespace

std::optional<Outcome> read_outcome(const std::filesystem::path& folder) {
  std::ifstream stream(file_in(folder));
  try {
    const Json json = Json::parse(stream);
    Outcome outcome{
        json.at("name"), json.at("folder"), json.at("key"), json.at("complete"), {}, {}};
    for (const auto& [name, value] : json.at("values").items()) {
      outcome.values[name] = value.is_null() ? std::nan("") : value.get<double>();
    }
    if (const auto costs = json.find("costs"); costs != json.end()) costs->get_to(outcome.costs);
    return outcome;
  } catch (const Json::exception&) {
    return {};
  }
}

void write_outcome(const std::filesystem::path& folder, const Outcome& outcome) {
  Json json{{"format", "scarp outcome"}, {"version", 1},       {"name", outcome.name},
            {"folder", outcome.folder},  {"key", outcome.key}, {"complete", outcome.complete}};
  json["values"] = outcome.values;
  json["costs"] = outcome.costs;
  replace_file(file_in(folder), json.dump(2) + "\n");
}

}  // namespace scarp::validation
