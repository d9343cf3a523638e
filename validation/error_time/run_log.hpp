// SPDX-License-Identifier: BSD-3-Clause
/// What each run of a setting gave, and what decides it.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "engine/scene/scene.hpp"
#include "validation/error_time/settings.hpp"
#include "validation/record_log.hpp"

namespace scarp::validation {

/// Where and with what runs are measured; part of every key.
struct Bench {
  std::string version, isa, processor;
  int threads = 0;
  std::string program;  ///< hash of the program itself: another build measures anew
};

/// FNV-1a of 64 bits, in hexadecimal.
std::string hash_of(std::string_view text);

enum class RunStatus { ok, unstable, refused };
const char* word(RunStatus status);

/// One run of one setting.
struct RunRecord {
  std::string key;
  std::string setting;   ///< in words
  double spacing = 0.0;  ///< [m]
  int repeat = 0;
  RunStatus status = RunStatus::ok;
  std::string reason;                ///< why it is not ok
  double outcome = 0.0;              ///< what the problem returned
  double wall_s = 0.0, cpu_s = 0.0;  ///< of the stepping [s]
  double particles = 0.0, steps = 0.0, particle_steps = 0.0;
  double memory_bytes = 0.0;
};

/// 16 hexadecimal digits (FNV-1a) of everything that decides what a run gives: program version,
/// instruction set, processor, threads, case, scene file, spacing, numerics, number of the repeat.
std::string run_key(const Bench& bench, const std::string& case_name, const std::string& scene_text,
                    double spacing, const Numerics& numerics, int repeat);

nlohmann::ordered_json json_of(const RunRecord& record);
/// False if the status is none; a JSON exception where a field is missing.
bool read(const nlohmann::ordered_json& json, RunRecord& record);

using RunLog = RecordLog<RunRecord>;

}  // namespace scarp::validation
