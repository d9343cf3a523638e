// SPDX-License-Identifier: BSD-3-Clause
/// What `validate` throws: a rule that is broken, with the key path, so that the reader can add the
/// line.
#pragma once

#include <string>

#include "engine/errors.hpp"

namespace scarp {

/// "key 'material[0].density' = -1: why. Try ..."; list items count from 0 as in the scene's
/// vectors.
class SceneProblem : public SceneError {
 public:
  SceneProblem(std::string path, const std::string& value, std::string why)
      : SceneError("key '" + path + "' = " + value + ": " + why),
        path_(std::move(path)),
        value_(value),
        why_(std::move(why)) {}
  const std::string& path() const { return path_; }
  const std::string& value() const { return value_; }
  const std::string& why() const { return why_; }

 private:
  std::string path_;
  std::string value_;
  std::string why_;
};

}  // namespace scarp
