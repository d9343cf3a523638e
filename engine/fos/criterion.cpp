// SPDX-License-Identifier: BSD-3-Clause
/// Which scenes can be asked for their factor of safety, and what counts as failure in them.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/errors.hpp"
#include "engine/fos/slope_height.hpp"
#include "engine/fos/strength_reduction.hpp"
#include "engine/scene/nearest_name.hpp"

namespace scarp {
namespace {

constexpr double failing_share = 0.01;  // of the height
// All in free falls over the height, sqrt(2 H/g). From 0.7 on the factor does not depend on the
// ramp; within five a mass driven a quarter of a per cent above its limit crosses 1 % of the
// height: H/100 = e g sin(a) t^2/2 with e = 0.0025 and the sine of a flat slip surface, 0.2. With a
// span of half a fall no verdict of `slopes_fos` and `slope_2d` is another than at the window's
// end.
constexpr double ramp_free_falls = 1.4, window_free_falls = 5.0, span_free_falls = 0.5;

std::string at_file(const Scene& scene) {
  return scene.file.empty() ? std::string() : scene.file + ": ";
}

[[noreturn]] void refuse(const Scene& scene, const std::string& why) {
  throw SceneError(at_file(scene) + why);
}

}  // namespace

std::optional<double> settled_reduction(const Scene& scene) {
  const Stage& before = scene.stages[scene.stages.size() - 2];
  if (!before.material_strength_reduction.empty()) return {};
  return before.strength_reduction;
}

void check_reducible(const Scene& scene) {
  if (scene.stages.size() < 2) {
    refuse(scene,
           fmt::format("stage: there is {} stage, but a factor of safety needs two: those before "
                       "the last settle the slope, the last is the one whose strength is cut. Try "
                       "[[stage]] name = \"settle\", until = \"rest\", duration = \"10 s\" before "
                       "it.",
                       scene.stages.size()));
  }
  const auto last = scene.stages.end() - 1;
  if (std::none_of(scene.stages.begin(), last,
                   [](const Stage& stage) { return stage.until == StageEnd::rest; })) {
    refuse(scene,
           fmt::format("stage: none before the last one ('{}') has until = \"rest\", so nothing "
                       "says that the slope has settled when its strength is cut. Try until = "
                       "\"rest\" in stage '{}'.",
                       last->name, (last - 1)->name));
  }
  for (const Wall& wall : scene.walls) {
    const bool goes = wall.removed_at == last->name;
    const bool moves = wall.velocity != Vec3{};
    if (!goes && !moves) continue;
    refuse(scene,
           fmt::format("wall '{}': it {} in the last stage ('{}'), so what the slope does "
                       "there is not a matter of its strength alone. Try to do that in a "
                       "stage before, and cut the strength in one that changes nothing else.",
                       wall.name, goes ? "is removed" : "moves", last->name));
  }
  for (const Material& material : scene.materials) {
    if (material.mass_scaling == 1.0 || !material.model.yields()) continue;
    refuse(
        scene,
        fmt::format("material '{}': with mass_scaling = {:.4g} it slides {:.3g} times more slowly "
                    "than soil does, so that a slope that fails would seem to stand. Try "
                    "without it, or model = \"linear_elastic\" for what only carries.",
                    material.name, material.mass_scaling, std::sqrt(material.mass_scaling)));
  }
  const auto yields = [](const Material& material) { return material.model.yields(); };
  if (std::none_of(scene.materials.begin(), scene.materials.end(), yields)) {
    refuse(scene,
           "material: none of them can yield, so there is no strength to cut. Try model = "
           "\"drucker_prager\".");
  }
}

Criterion choose_criterion(const Scene& scene, const CriterionOptions& options) {
  Criterion criterion;
  // Soil that softens may come to rest and set off again.
  const auto softens = [](const Material& material) { return material.model.softens(); };
  criterion.early_stop =
      options.early_stop && std::none_of(scene.materials.begin(), scene.materials.end(), softens);
  criterion.height = options.height ? *options.height : slope_height(scene);
  if (!(criterion.height > 0.5 * scene.spacing)) {
    refuse(scene,
           "the ground is level, so the slope has no height to measure displacements with. "
           "Give --height.");
  }
  const Vec3& g = scene.gravity;
  const double weight = std::hypot(g[0], g[1], g[2]);
  if (!(weight > 0.0)) {
    refuse(scene, "gravity: it is 0, so nothing drives the slope. Try 9.81 downward.");
  }
  const double free_fall = std::sqrt(2.0 * criterion.height / weight);
  criterion.limit = failing_share * criterion.height;
  criterion.window = options.window.value_or(window_free_falls * free_fall);
  criterion.ramp = options.ramp.value_or(ramp_free_falls * free_fall);
  criterion.span = span_free_falls * free_fall;
  if (!options.probe.empty()) {
    std::vector<std::string> names;
    for (const Probe& probe : scene.probes) names.push_back(probe.name);
    if (std::find(names.begin(), names.end(), options.probe) == names.end()) {
      refuse(scene, fmt::format("no probe is called '{}'. {}", options.probe,
                                did_you_mean(options.probe, names)));
    }
    criterion.probe = options.probe;
  } else if (!scene.probes.empty()) {
    criterion.probe = scene.probes.front().name;
  }
  return criterion;
}

}  // namespace scarp
