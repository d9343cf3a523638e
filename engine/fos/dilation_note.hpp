// SPDX-License-Identifier: BSD-3-Clause
/// What a scene's dilation does to its factor of safety.
#pragma once

#include <optional>
#include <string>

#include "engine/scene/scene.hpp"

namespace scarp {

/// Whether the last stage of a scene cuts the strength, or `scarp fos` would take it.
bool looks_reducible(const Scene& scene);

/// A sentence, if a body can yield with friction but without dilation, the default: published
/// factors are for psi = phi. With `factor`, found with the scene's psi, also the most that psi =
/// phi could give in plane strain: a band that shears at constant volume holds q (c + s tan phi), q
/// = 1/sqrt(1 + 4/3 tan^2 phi) with the reduced phi (THEORY.md section 5), so factor/q.
std::optional<std::string> dilation_note(const Scene& scene, std::optional<double> factor = {});

}  // namespace scarp
