// SPDX-License-Identifier: BSD-3-Clause
/// Keys and lines of the run log.

#include "validation/error_time/run_log.hpp"

#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>

namespace scarp::validation {
namespace {

using Json = nlohmann::ordered_json;
constexpr std::array status_words{"ok", "unstable", "refused"};

}  // namespace

const char* word(RunStatus status) { return status_words[static_cast<std::size_t>(status)]; }

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

bool read(const Json& json, RunRecord& record) {
  record.key = json.at("key").get<std::string>();
  record.setting = json.at("setting").get<std::string>();
  record.spacing = number_or_nan(json.at("spacing"));
  record.repeat = json.at("repeat").get<int>();
  const std::string status = json.at("status").get<std::string>();
  std::size_t s = 0;
  while (s < status_words.size() && status != status_words[s]) ++s;
  if (s == status_words.size()) return false;
  record.status = static_cast<RunStatus>(s);
  record.reason = json.at("reason").get<std::string>();
  record.outcome = number_or_nan(json.at("outcome"));
  record.wall_s = number_or_nan(json.at("wall_s"));
  record.cpu_s = number_or_nan(json.at("cpu_s"));
  record.particles = number_or_nan(json.at("particles"));
  record.steps = number_or_nan(json.at("steps"));
  record.particle_steps = number_or_nan(json.at("particle_steps"));
  record.memory_bytes = number_or_nan(json.at("memory_bytes"));
  return true;
}

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

}  // namespace scarp::validation
