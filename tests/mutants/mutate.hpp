// SPDX-License-Identifier: BSD-3-Clause
/// Scenes with a few of their words changed: most can still be read, so that what follows the
/// reader is met as well.
#pragma once

#include <random>
#include <string>
#include <vector>

namespace scarp {

using Random = std::mt19937_64;  // its numbers are the same on every machine

/// `scene` after one to four changes of keys, numbers, units, text, lines and sections; a few get
/// bytes that are wrong instead. `others`: scenes to take lines from.
std::string mutate(const std::string& scene, const std::vector<std::string>& others,
                   Random& random);

}  // namespace scarp
