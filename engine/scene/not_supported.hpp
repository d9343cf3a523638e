// SPDX-License-Identifier: BSD-3-Clause
/// What people look for in a scene and scarp does not have.
#pragma once

#include <string_view>

namespace scarp::input {

/// Why a word in a section of a scene ("top", "material", "wall", ...; "model" for names of models)
/// means what is not there, and what to do instead; empty if the word says nothing of the kind.
std::string_view not_supported(std::string_view section, std::string_view word);

}  // namespace scarp::input
