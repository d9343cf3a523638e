// SPDX-License-Identifier: BSD-3-Clause
/// The JSON form of what a run was asked for.
#include "engine/cli/run_record.hpp"

#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>
#include <system_error>

#include "engine/cli/commands.hpp"
#include "engine/errors.hpp"
#include "engine/output/checkpoint_writer.hpp"
#include "engine/output/text_file.hpp"

namespace scarp::cli {
namespace {

using Json = nlohmann::ordered_json;
constexpr int format_version = 1;

}  // namespace

void begin_run(const std::filesystem::path& folder, const RunRecord& record) {
  std::error_code error;
  std::filesystem::remove(folder / "results.json", error);
  if (error) {
    throw FileError(fmt::format("'{}': cannot be removed: {}.", (folder / "results.json").string(),
                                error.message()));
  }
  remove_checkpoints(folder);
  const std::string text = Json{{"format", "scarp run"},
                                {"version", format_version},
                                {"program", record.program},
                                {"scene", record.scene_name},
                                {"preset", record.overrides.preset},
                                {"spacing", record.overrides.spacing},
                                {"isa", record.isa},
                                {"threads", record.threads},
                                {"text", record.scene_text}}
                               .dump(2) +
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
    return {json.at("program"), json.at("scene"),
            json.at("text"),    {json.at("preset"), json.at("spacing")},
            json.at("isa"),     json.at("threads")};
  } catch (const nlohmann::json::exception&) {
    throw FileError(fmt::format(
        "'{}': there is no run to go on with: run.json {}. Try the output folder of 'scarp run'.",
        folder.string(), std::filesystem::exists(path) ? "is damaged" : "is missing"));
  }
}

bool run_is_complete(const std::filesystem::path& folder) {
  const Json json = Json::parse(read_text(folder / "results.json"), nullptr, false);
  return json.is_object() && json.value("complete", false);
}

}  // namespace scarp::cli
