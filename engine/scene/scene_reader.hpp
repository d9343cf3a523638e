// SPDX-License-Identifier: BSD-3-Clause
/// Scenes from TOML; `SCENE.md` documents every key.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "engine/scene/scene.hpp"

namespace scarp {

/// What a command line may put in place of the scene's own words.
struct SceneOverrides {
  std::string preset{};  ///< rows under [numerics] still apply on top; empty: the scene's
  std::optional<double> spacing{};  ///< [m]; empty: the scene's
};

/// Reads and validates a scene. Errors: FileError if the file cannot be read; SceneError
/// "file:line: key 'a.b' = value: why. Try ..." for anything wrong with it, whatever the bytes.
Scene read_scene(const std::filesystem::path& path, const SceneOverrides& overrides = {});

/// The same from text; `name` stands for the file in messages and becomes `Scene::file`.
Scene read_scene_text(std::string_view text, const std::string& name,
                      const SceneOverrides& overrides = {});

}  // namespace scarp
