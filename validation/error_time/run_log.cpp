// SPDX-License-Identifier: BSD-3-Clause
/// Keys and lines of the run log.

#include "validation/error_time/run_log.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>

#include "engine/errors.hpp"

namespace scarp::validation {
namespace {

using Json = nlohmann::ordered_json;
constexpr std::array status_words{"ok", "unstable", "refused"};

/// JSON has no NaN: null stands for it, both ways.
double number(const Json& json) { return json.is_null() ? std::nan("") : json.get<double>(); }

Json json_of(const RunRecord& record) {
  return {{"key", record.key},
          {"setting", record.setting},
          {"spacing", record.spacing},
          {"repeat", record.repeat},
          {"status", word(record.status)},
          {"reason", record.reason},
          {"outcome", record.outcome},
          {"wall_s", record.wall_s},
          {"cpu_s", record.cpu_s},
          {"particles", record.particles},
          {"steps", record.steps},
          {"particle_steps", record.particle_steps},
          {"memory_bytes", record.memory_bytes}};
}

std::optional<RunRecord> record_of(const std::string& line) {
  try {
    const Json json = Json::parse(line);
    RunRecord record;
    record.key = json.at("key").get<std::string>();
    record.setting = json.at("setting").get<std::string>();
    record.spacing = number(json.at("spacing"));
    record.repeat = json.at("repeat").get<int>();
    const std::string status = json.at("status").get<std::string>();
    std::size_t s = 0;
    while (s < status_words.size() && status != status_words[s]) ++s;
    if (s == status_words.size()) return {};
    record.status = static_cast<RunStatus>(s);
    record.reason = json.at("reason").get<std::string>();
    record.outcome = number(json.at("outcome"));
    record.wall_s = number(json.at("wall_s"));
    record.cpu_s = number(json.at("cpu_s"));
    record.particles = number(json.at("particles"));
    record.steps = number(json.at("steps"));
    record.particle_steps = number(json.at("particle_steps"));
    record.memory_bytes = number(json.at("memory_bytes"));
    return record;
  } catch (const Json::exception&) {
    return {};
  }
}

}  // namespace

const char* word(RunStatus status) { return status_words[static_cast<std::size_t>(status)]; }

std::string run_key(const Bench& bench, const std::string& case_name, const std::string& scene_text,
                    double spacing, const Numerics& numerics, int repeat) {
  return hash_of(fmt::format("{}\n{}\n{}\n{}\n{}\n{}\n{}\n{}\n{}\n{}", bench.version, bench.program,
                             bench.isa, bench.processor, bench.threads, case_name, scene_text,
                             spacing, numerics_text(numerics), repeat));
}

std::string hash_of(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const char c : text) {
    hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  }
  return fmt::format("{:016x}", hash);
}

RunLog::RunLog(std::filesystem::path path) : path_(std::move(path)) {
  bool whole_lines = true;
  {
    std::ifstream stream(path_);
    for (std::string line; std::getline(stream, line);) {
      whole_lines = !stream.eof();
      if (auto record = record_of(line)) records_[record->key] = *record;
    }
  }
  std::ofstream stream(path_, std::ios::app);
  if (!whole_lines) stream << '\n';  // what was cut short must not swallow the next line
  if (!stream.flush()) {
    throw FileError(
        fmt::format("'{}': cannot be written. Try another folder with -o.", path_.string()));
  }
}

const RunRecord* RunLog::find(const std::string& key) const {
  const auto found = records_.find(key);
  return found == records_.end() ? nullptr : &found->second;
}

void RunLog::append(const RunRecord& record) {
  std::ofstream stream(path_, std::ios::app);
  stream << json_of(record).dump(-1, ' ', false, Json::error_handler_t::replace) << '\n';
  if (!stream.flush()) throw FileError(fmt::format("'{}': cannot be written.", path_.string()));
  records_[record.key] = record;
}

}  // namespace scarp::validation
