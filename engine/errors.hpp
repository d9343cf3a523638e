// SPDX-License-Identifier: BSD-3-Clause
/// The typed exceptions of the library; nothing else is thrown on purpose, nothing is printed.
#pragma once

#include <stdexcept>
#include <string>

namespace scarp {

/// Base of all errors the library reports.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
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

/// A run that left the physical range; the message names step, particle, field, value, likely
/// cause.
class SimulationInstability : public Error {
 public:
  using Error::Error;
};

}  // namespace scarp
