// SPDX-License-Identifier: BSD-3-Clause
/// Finds the soil with the fastest growth, and a smoothing function without it.
#include "engine/check/lattice_warning.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "engine/check/body_range.hpp"
#include "engine/check/lattice_growth.hpp"
#include "engine/scene/smoothing_choice.hpp"

namespace scarp {
namespace {

/// Of the time without damping; a stage without end counts as ten free falls over the soil.
double time_to_grow(const Scene& scene, double fall) {
  double time = 0.0;
  for (const Stage& stage : scene.stages) {
    const bool damped =
        stage.damping ? *stage.damping > 0.0 : stage.until == StageEnd::rest && stage.reset_after;
    if (!damped) time += stage.duration.value_or(0.0) > 0.0 ? *stage.duration : 10.0 * fall;
  }
  return time;
}

struct Span {
  double low = std::numeric_limits<double>::infinity(), high = -low;
};

/// Where bodies stand along gravity, of all and by material [m].
struct Heights {
  Span all;
  std::vector<Span> of;
};

Heights heights(const Scene& scene, std::size_t axis, double up) {
  Heights found{{}, std::vector<Span>(scene.materials.size())};
  const std::vector<BodyRange> ranges = body_ranges(scene, axis);
  for (std::size_t body = 0; body < ranges.size(); ++body) {
    const double a = up * ranges[body].low, b = up * ranges[body].high;
    for (Span* range : {&found.all, &found.of[material_of(scene, scene.bodies[body])]}) {
      range->low = std::min({range->low, a, b});
      range->high = std::max({range->high, a, b});
    }
  }
  return found;
}

struct Choice {
  SmoothingFunction function;
  double ratio;
};

/// Those with the same support first.
std::optional<Choice> without_growth(const Scene& scene, const LoadedLattice& loaded,
                                     double enough) {
  const double own = smoothing_ratio_of(scene);
  const std::array choices{
      Choice{SmoothingFunction::wendland_c2, own}, Choice{SmoothingFunction::yang_liu, own},
      Choice{smoothing_function_of({}, scene.dimension), smoothing_ratio_of({}, scene.dimension)},
      Choice{SmoothingFunction::yang_liu, 1.3}, Choice{SmoothingFunction::wendland_c2, 1.5}};
  for (const Choice& choice : choices) {
    LoadedLattice other = loaded;
    other.smoothing = &kernels::smoothing_functions[static_cast<std::size_t>(choice.function)];
    other.smoothing_ratio = choice.ratio;
    if (growth_rate(other) < enough) return choice;
  }
  return {};
}

}  // namespace

void check_lattice(const Scene& scene, std::vector<std::string>& found) {
  const double g = std::hypot(scene.gravity[0], scene.gravity[1], scene.gravity[2]);
  if (g == 0.0 || scene.bodies.empty()) return;
  const std::size_t axis = gravity_axis(scene);
  const Heights levels = heights(scene, axis, scene.gravity[axis] < 0.0 ? 1.0 : -1.0);
  const double fall = std::sqrt(2.0 * (levels.all.high - levels.all.low) / g);
  const double thousandfold = std::log(1e3) / time_to_grow(scene, fall);
  double most = 0.0;
  LoadedLattice worst;
  const Material* of = nullptr;
  for (std::size_t m = 0; m < scene.materials.size(); ++m) {
    const Material& material = scene.materials[m];
    const double depth = levels.all.high - levels.of[m].low;
    if (!(depth > 0.0)) continue;
    const auto moduli = material.model.moduli();
    LoadedLattice loaded;
    loaded.smoothing = &smoothing_of(scene);
    loaded.smoothing_ratio = smoothing_ratio_of(scene);
    loaded.dimension = scene.dimension;
    loaded.normalised = scene.numerics.lattice_normalisation;
    loaded.spacing = scene.spacing;
    loaded.wave_modulus = moduli.wave_modulus();
    loaded.shear_modulus = moduli.shear_modulus;
    loaded.inertia = material.mass_scaling * material.density;
    loaded.viscosity_alpha = scene.numerics.viscosity_alpha;
    loaded.pressure = material.density * g * depth;
    loaded.k0 = k0_of(scene, material);
    for (std::size_t a = 0; a < 3; ++a) loaded.down[a] = scene.gravity[a] / g;
    const double rate = growth_rate(loaded);
    if (rate <= most) continue;
    most = rate;
    worst = loaded;
    of = &material;
  }
  if (of == nullptr || !(most > thousandfold)) return;
  const auto choice = without_growth(scene, worst, 0.1 * thousandfold);
  const auto word = [](SmoothingFunction f) {
    return kernels::smoothing_functions[static_cast<std::size_t>(f)].name;
  };
  std::string text = fmt::format(
      "numerics: the lattice that '{}' with smoothing_ratio = {:g} gives does not stand under the "
      "{:.3g} kPa at the base of material '{}': zigzags from row to row, which the velocity "
      "gradient "
      "does not see, grow tenfold in {:.2g} s without damping, so that soil that should stand "
      "begins to move.",
      worst.smoothing->name, worst.smoothing_ratio, 1e-3 * worst.pressure, of->name,
      std::log(10.0) / most);
  if (choice) {
    text += fmt::format(" Try smoothing = \"{}\"{}.", word(choice->function),
                        choice->ratio == worst.smoothing_ratio
                            ? std::string(" with the same ratio")
                            : fmt::format(", smoothing_ratio = {:g}", choice->ratio));
  } else {
    text += " Try a stiffer soil or a coarser spacing.";
  }
  found.push_back(std::move(text));
}

}  // namespace scarp
