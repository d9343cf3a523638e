// SPDX-License-Identifier: BSD-3-Clause
/// The named sets of numerics; `SCENE.md` shows them side by side.

#include <fmt/format.h>

#include "engine/errors.hpp"
#include "engine/scene/scene.hpp"

namespace scarp {

Numerics preset(const std::string& name) {
  Numerics modern;  // the defaults in scene.hpp
  if (name == "modern") return modern;
  if (name != "paper") {
    throw SceneError(fmt::format(
        "key 'preset' = \"{}\": there is no such preset. Try \"modern\" or \"paper\".", name));
  }
  Numerics paper = modern;
  paper.preset = name;
  paper.smoothing = SmoothingFunction::yang_liu;
  paper.lattice_normalisation = false;
  paper.gradient_correction = false;
  paper.stress_rotation = StressRotation::jaumann;
  paper.viscosity_alpha = 0.1;
  paper.viscosity_beta = 0.0;
  paper.artificial_stress = 0.3;
  paper.artificial_stress_exponent = 2.55;
  paper.stress_diffusion = 0.0;
  paper.integrator = Integrator::verlet;
  paper.verlet_restart_interval = 40;
  paper.cfl = 0.2;
  return paper;
}

}  // namespace scarp
