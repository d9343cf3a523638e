// SPDX-License-Identifier: BSD-3-Clause
/// Whether a command may put its results where there are some already.
#pragma once

#include <filesystem>

#include "engine/scene/scene.hpp"

namespace scarp::cli {

enum class Command { run, fos, converge };

/// Leaves the folder for the command to begin in: with none of its former results that could pass
/// for new ones. A run that has ended (or became unstable) makes way for one of a scene file of the
/// same name, a search for a search, a study for a study; with `overwrite` all that scarp has
/// written makes way. Other files stay in any case. Pre: the folder's lock is held. Errors:
/// FileError, which says what is there and what to try, before anything has been touched.
void claim_folder(const std::filesystem::path& folder, Command command, const Scene& scene,
                  bool overwrite);

}  // namespace scarp::cli
