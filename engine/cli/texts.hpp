// SPDX-License-Identifier: BSD-3-Clause
/// Texts of the repository that the program carries along; `cmake/embed_text.cmake` makes them.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace scarp::cli {

struct Text {
  std::string_view name, text;
};

extern const std::span<const Text> templates;    ///< engine/scene/templates
extern const std::span<const Text> scene_pages;  ///< engine/scene/SCENE.md

/// Errors: UsageError that names those there are.
const Text& template_named(const std::string& name);

}  // namespace scarp::cli
