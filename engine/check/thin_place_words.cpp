// SPDX-License-Identifier: BSD-3-Clause
/// Sentences for gaps, layers and tips.
#include "engine/check/thin_place_words.hpp"

#include <fmt/format.h>

namespace scarp {

std::string words_of(const Scene& scene, const ThinKind& kind, const ThinPlace& found) {
  const std::string place = point_text(found.place, scene.dimension);
  const std::string more =
      found.count > 1 ? fmt::format(" (the narrowest of {} such places)", found.count) : "";
  if (kind.material < 0) {
    const std::string where =
        kind.below == kind.above
            ? fmt::format("in body[{}]", kind.below)
            : fmt::format("between body[{}] and body[{}]", kind.below, kind.above);
    return fmt::format(
        "{}: {} at {} is {:.3g} m wide, less than two spacings of {:g} m{}: below one spacing it "
        "may "
        "vanish, and below two the soil on its sides acts across it. Try spacing = {:.3g}, or a "
        "wider "
        "one.",
        where, found.hole ? "the hole" : "the gap", place, found.width, scene.spacing, more,
        found.width / spacings_wanted);
  }
  if (found.tapers > 0.0) {
    return fmt::format(
        "body[{}]: from {} on it thins out to nothing over {:.3g} m, all of it thinner than two "
        "spacings of {:g} m{}: where it is thinner than one it may vanish. Try to end it where it "
        "is "
        "{:.3g} m thick, or a smaller spacing.",
        kind.body, place, found.tapers, scene.spacing, more, spacings_wanted * scene.spacing);
  }
  const std::string& material = scene.materials[static_cast<std::size_t>(kind.material)].name;
  return fmt::format(
      "material '{}': the layer of body[{}] at {} is {:.3g} m thick, less than two spacings of "
      "{:g} "
      "m{}: a single row of particles cannot shear in itself, and what is thinner than a spacing "
      "may "
      "vanish. Two to three rows are needed; a row of weak soil between stronger soil takes the "
      "row above it too. Try spacing = {:.3g} to {:.3g}, or a thicker one.",
      material, kind.body, place, found.width, scene.spacing, more, found.width / 3.0,
      found.width / spacings_wanted);
}

}  // namespace scarp
