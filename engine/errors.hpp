// SPDX-License-Identifier: BSD-3-Clause
/// The typed exceptions of the library; nothing else is thrown on purpose, nothing is printed.
#pragma once

#include <array>
#include <cstdint>
#include <exception>
#include <optional>
#include <stdexcept>
#include <string>

namespace scarp {

/// Base of all errors the library reports.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// `RunOptions::stop` asked for an end. No Error, since nothing is wrong: what takes an error as an
/// answer must not take this for one.
class Stopped : public std::exception {
 public:
  const char* what() const noexcept override { return "stopped on request"; }
};

/// A scene that cannot be run; the message names file, line, key, value, reason and what to try.
class SceneError : public Error {
 public:
  using Error::Error;
};

/// A file that cannot be read or written.
class FileError : public Error {
 public:
  using Error::Error;
};

/// A checkpoint that cannot be gone on from: damaged, of another scene or version.
class CheckpointError : public Error {
 public:
  using Error::Error;
};

/// A state that soil cannot have, at which a run was stopped.
struct Instability {
  std::uint64_t step = 0;
  double time = 0.0;  ///< [s]
  std::string stage;
  std::int64_t particle = -1;        ///< permanent id
  std::array<double, 3> position{};  ///< of the particle [m]
  std::string field, unit;           ///< "density", "velocity", "energy", ...
  double value = 0.0, limit = 0.0;   ///< a limit of NaN: the value is not finite
  std::string cause, advice;         ///< likely cause; what to try

  std::string message() const;
};

/// A run that left the physical range; the message names step, time, particle, field, value, likely
/// cause and what to try.
class SimulationInstability : public Error {
 public:
  using Error::Error;
  explicit SimulationInstability(Instability what)
      : Error(what.message()), what_happened_(std::move(what)) {}

  /// Empty where a caller of the library judged by rules of its own.
  const std::optional<Instability>& what_happened() const { return what_happened_; }

 private:
  std::optional<Instability> what_happened_;
};

/// Why a run or a command ended, whatever was thrown: its own words, or plain ones where it has
/// none.
std::string reason_of(const std::exception_ptr& thrown);

}  // namespace scarp
