// SPDX-License-Identifier: BSD-3-Clause
/// The JSON form of what a run was asked for.
#include "engine/cli/run_record.hpp"

#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>

#include "engine/checkpoint/scene_text.hpp"
#include "engine/cli/commands.hpp"
#include "engine/errors.hpp"
#include "engine/output/result_files.hpp"
#include "engine/output/text_file.hpp"
#include "engine/run/checkpoint_writer.hpp"

namespace scarp::cli {
namespace {

using Json = nlohmann::ordered_json;
constexpr int format_version = 1;

/// An empty object if there are none that can be read.
Json results_of(const std::filesystem::path& folder) {
  Json json = Json::parse(read_text(folder / "results.json"), nullptr, false);
  return json.is_object() ? json : Json::object();
}

}  // namespace

void begin_run(const std::filesystem::path& folder, const RunRecord& record) {
  remove_file(folder / "results.json");
  remove_checkpoints(folder);
  write_record(folder, record);
}

void write_record(const std::filesystem::path& folder, const RunRecord& record) {
  const std::string text = Json{{"format", "scarp run"},
                                {"version", format_version},
                                {"program", record.program},
                                {"scene", record.scene_name},
                                {"preset", record.overrides.preset},
                                {"spacing", record.overrides.spacing.value_or(0.0)},
                                {"isa", record.isa},
                                {"threads", record.threads ? Json(*record.threads) : Json()},
                                {"text", record.scene_text}}
                               .dump(2, ' ', false, Json::error_handler_t::replace) +
                           "\n";
  replace_file_durably(folder / "run.json", std::array<std::string_view, 1>{text});
}

RunRecord read_record(const std::filesystem::path& folder) {
  const std::filesystem::path path = folder / "run.json";
  try {
    const Json json = Json::parse(read_text(path));
    if (json.at("format") != "scarp run" || json.at("version") != format_version)
      throw FileError(fmt::format("'{}': is of another version. Try the program that wrote it.",
                                  path.string()));
    SceneOverrides overrides{json.at("preset"), {}};
    if (const double spacing = json.at("spacing"); spacing != 0.0) overrides.spacing = spacing;
    RunRecord record{json.at("program"), json.at("scene"), json.at("text"),
                     overrides,          json.at("isa"),   {}};
    if (const Json& threads = json.at("threads"); !threads.is_null())
      record.threads = threads.get<int>();
    return record;
  } catch (const nlohmann::json::exception&) {
    throw FileError(fmt::format(
        "'{}': there is no run to go on with: run.json {}. Try the output folder of 'scarp run'.",
        folder.string(), std::filesystem::exists(path) ? "is damaged" : "is missing"));
  }
}

std::string difference_of(const Scene& recorded, const Scene& here) {
  const std::string difference = first_difference(scene_text(recorded), scene_text(here));
  return difference.empty() ? first_difference(output_text(recorded), output_text(here))
                            : difference;
}

std::string change_of_scene(const RunRecord& record, const Scene& recorded) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(record.scene_name, ignored)) return {};
  if (read_text(record.scene_name) == record.scene_text) return {};
  try {
    const Scene here = read_scene(record.scene_name, record.overrides);
    const std::string difference = difference_of(recorded, here);
    if (difference.empty()) return {};
    return fmt::format("'{}' has changed since the run began (there {}).", record.scene_name,
                       difference);
  } catch (const Error&) {
    return fmt::format("'{}' has changed since the run began and is no scene now.",
                       record.scene_name);
  }
}

bool run_is_finished(const std::filesystem::path& folder) {
  return results_of(folder).value("finished", Json()) == true;
}

bool run_lost_soil(const std::filesystem::path& folder) {
  return results_of(folder).value(Json::json_pointer("/lost_soil/particles"), 0) > 0;
}

bool run_has_ended(const std::filesystem::path& folder) {
  return run_is_finished(folder) || results_of(folder).value("instability", Json()).is_object();
}

}  // namespace scarp::cli
