// SPDX-License-Identifier: BSD-3-Clause
/// The record of a search as JSON, its settled state as a checkpoint.
#include "engine/cli/fos_record.hpp"

#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>

#include "engine/checkpoint/scene_text.hpp"
#include "engine/cli/commands.hpp"
#include "engine/cli/fos_output.hpp"
#include "engine/errors.hpp"
#include "engine/output/checkpoint_file.hpp"
#include "engine/output/result_files.hpp"
#include "engine/output/results.hpp"
#include "engine/output/text_file.hpp"
#include "engine/run/checkpoint_writer.hpp"

namespace scarp::cli {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
constexpr const char* format_name = "scarp fos search";
constexpr int format_version = 1;

Trial trial_from(const Json& json) {
  Trial trial;
  json.at("reduction").get_to(trial.reduction);
  json.at("fails").get_to(trial.fails);
  for (const TrialEnd end :
       {TrialEnd::limit_crossed, TrialEnd::came_to_rest, TrialEnd::window_over}) {
    if (json.at("end") == word(end)) trial.end = end;
  }
  json.at("displacement").get_to(trial.displacement);
  json.at("speed").get_to(trial.speed);
  json.at("time").get_to(trial.time);
  json.at("steps").get_to(trial.steps);
  json.at("wall_s").get_to(trial.wall_s);
  return trial;
}

/// Nothing if there is none, or none that can be read: then all is done again.
std::optional<SearchRecord> read_search(const fs::path& folder) {
  try {
    const Json json = Json::parse(read_text(folder / "search.json"));
    if (json.at("format") != format_name || json.at("version") != format_version) return {};
    SearchRecord record;
    json.at("key").get_to(record.key);
    json.at("ended").get_to(record.ended);
    json.at("settle_wall_s").get_to(record.settle_wall_s);
    json.at("strengthening").get_to(record.strengthening);
    if (!json.at("elastic").is_null()) record.elastic = trial_from(json.at("elastic"));
    for (const Json& trial : json.at("trials")) record.trials.push_back(trial_from(trial));
    if (!json.at("failure_run").is_null()) record.failure_run = json.at("failure_run");
    return record;
  } catch (const nlohmann::json::exception&) {
    return {};
  }
}

}  // namespace

std::string search_key(const Simulation& simulation, const Criterion& c) {
  const Scene& scene = simulation.scene();
  return fmt::format(
      "program = {}\nisa = {}\n{}{}criterion.height = {}\ncriterion.limit = {}\ncriterion.ramp = {}"
      "\ncriterion.window = {}\ncriterion.span = {}\ncriterion.probe = {}\n",
      program_version(), simulation.isa(), scene_text(scene), output_text(scene), c.height, c.limit,
      c.ramp, c.window, c.span, c.probe);
}

SearchRecord begin_search(const fs::path& folder, const Scene& scene, const std::string& key) {
  std::optional<SearchRecord> left = read_search(folder);
  if (left && left->key == key) {
    remove_page(folder);
    for (const char* name : {"fos.json", "fos.csv"}) remove_file(folder / name);
    left->ended = false;
    return *left;
  }
  if (left && !left->ended) {
    throw FileError(fmt::format(
        "'{}': holds a search that has not reached its end, of another scene or with other options "
        "(there {}). To go on with it: the same command as then. To replace it: --overwrite. To "
        "keep both: another folder with -o.",
        folder.string(), first_difference(left->key, key)));
  }
  remove_results(folder, scene.file);
  SearchRecord record;
  record.key = key;
  return record;
}

void write_search(const fs::path& folder, const SearchRecord& record) {
  Json json{{"format", format_name},
            {"version", format_version},
            {"ended", record.ended},
            {"settle_wall_s", record.settle_wall_s},
            {"strengthening", record.strengthening},
            {"elastic", record.elastic ? json_of(*record.elastic) : Json()},
            {"trials", Json::array()},
            {"failure_run", record.failure_run ? Json(*record.failure_run) : Json()},
            {"key", record.key}};
  for (const Trial& trial : record.trials) json["trials"].push_back(json_of(trial));
  const std::string text =
      json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
  replace_file_durably(folder / "search.json", std::array<std::string_view, 1>{text});
}

void keep_state(const fs::path& folder, const Simulation& simulation) {
  const fs::path path = checkpoint_of(folder, simulation.last_step().step);
  make_checkpoint_folder(folder);
  write_checkpoint(path, simulation.snapshot());
  for (const fs::path& other : checkpoints_in(folder)) {
    if (other != path) remove_file(other);
  }
}

std::optional<Snapshot> kept_settling(const fs::path& folder) {
  for (const fs::path& path : checkpoints_in(folder)) {
    try {
      return read_checkpoint(path);
    } catch (const CheckpointError& error) {
      fmt::print(stderr, "warning: {}\n", error.what());
    }
  }
  return {};
}

void forget_state(const fs::path& folder) { remove_checkpoints(folder); }

}  // namespace scarp::cli
