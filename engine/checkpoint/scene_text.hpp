// SPDX-License-Identifier: BSD-3-Clause
/// A scene as text, to tell whether a snapshot belongs to it.
#pragma once

#include <string>

#include "engine/scene/scene.hpp"

namespace scarp {

/// One line "numerics.cfl = 1" for each value that the course of a run depends on, SI, exact. What
/// only names or writes (title, file, probes, intervals of outputs and checkpoints) is left out.
/// The stages come last.
std::string scene_text(const Scene& scene);

/// The same for what only decides which outputs a run leaves: probes, names of walls, intervals.
std::string output_text(const Scene& scene);

/// Whether `here` is `stored` with nothing but stages behind its last one.
bool only_adds_stages(const std::string& stored, const std::string& here);

/// The first line in which two such texts differ, as "numerics.cfl = 1, here numerics.cfl = 0.8";
/// empty if they are equal.
std::string first_difference(const std::string& stored, const std::string& here);

}  // namespace scarp
