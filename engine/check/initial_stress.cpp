// SPDX-License-Identifier: BSD-3-Clause
/// K0 against the yield surface, where the soil carries most.
#include "engine/check/initial_stress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "engine/particles/soil_above.hpp"

namespace scarp {
namespace {

/// Pressure along gravity of each particle [Pa].
std::vector<double> pressures(const Simulation& simulation) {
  const Vec3 up = upward(simulation.scene());
  const std::vector<double> stress = simulation.field("stress");
  std::vector<double> pressure(stress.size() / 6);
  for (std::size_t i = 0; i < pressure.size(); ++i) {
    const double* s = &stress[6 * i];
    for (std::size_t a = 0; a < 3; ++a) {
      const std::size_t b = (a + 1) % 3;
      pressure[i] -= s[a] * up[a] * up[a] + 2.0 * s[a + 3] * up[a] * up[b];
    }
  }
  return pressure;
}

using Stress = kernels::SymTensor<double>;

/// f of the model at the start of a run, > 0 outside its yield surface [Pa].
class YieldSurface {
 public:
  YieldSurface(const Material& material, double reduction)
      : info_(material.model.info()),
        constants_(material.model.prepare({reduction, 1.0, material.density})) {
    for (const kernels::StateField& field : info_.state_fields)
      history_.push_back(field.initial_value);
  }
  double operator()(const Stress& stress) const {
    return info_.yield_function(constants_, stress, history_);
  }

 private:
  const kernels::ModelInfo& info_;
  kernels::ModelConstants constants_;
  std::vector<double> history_;
};

/// Where f changes its sign between a point inside and one outside.
template <class F>
double boundary_between(double inside, double outside, const F& f) {
  for (int halving = 0; halving < 200; ++halving) {
    const double middle = 0.5 * (inside + outside);
    (f(middle) > 0.0 ? outside : inside) = middle;
  }
  return inside;
}

/// The deviator of a uniform stress over what the surface bears at its mean stress.
double utilisation(const std::array<double, 6>& s, const Material& material, double reduction) {
  const YieldSurface surface(material, reduction);
  const Stress stress{s[0], s[1], s[2], s[3], s[4], s[5]};
  const Stress mean = kernels::isotropic(trace(stress) / 3.0), deviatoric = deviator(stress);
  const auto f = [&](double share) { return surface(mean + share * deviatoric); };
  if (!(f(1.0) > 0.0)) return 0.0;
  if (f(0.0) > 0.0) return std::numeric_limits<double>::infinity();
  return 1.0 / boundary_between(0.0, 1.0, f);
}

/// Models that yield and say where.
bool has_surface(const Material& material) {
  const SoilModel& model = material.model;
  return model.yields() && !std::isnan(YieldSurface(material, 1.0)(kernels::isotropic(0.0)));
}

std::vector<std::string> uniform_warnings(const Scene& scene) {
  std::vector<std::string> found;
  for (std::size_t m = 0; m < scene.materials.size(); ++m) {
    const Material& material = scene.materials[m];
    if (!is_used(scene, m) || !has_surface(material)) continue;
    const double share =
        utilisation(scene.uniform_stress, material, reduction_of(scene.stages.front(), material));
    if (share <= 1.0 + 1e-9) continue;
    found.push_back(fmt::format(
        "material '{}': the uniform stress is outside its yield surface{}; the first step takes it "
        "back. Try a stress with less shear or more pressure.",
        material.name,
        std::isfinite(share) ? fmt::format(", {:.3g} times what the surface bears", share)
                             : ", beyond the tension that the surface bears"));
  }
  return found;
}

}  // namespace

RestRange rest_range(const Material& material, double reduction, double pressure) {
  const YieldSurface surface(material, reduction);
  const auto f = [&](double k) {
    return surface({-pressure, -k * pressure, -k * pressure, 0.0, 0.0, 0.0});
  };
  constexpr double widest = 1e9;
  RestRange range;
  range.active = f(0.0) > 0.0 ? boundary_between(1.0, 0.0, f) : 0.0;
  range.passive =
      f(widest) > 0.0 ? boundary_between(1.0, widest, f) : std::numeric_limits<double>::infinity();
  return range;
}

std::vector<std::string> initial_stress_warnings(const Simulation& simulation) {
  const Scene& scene = simulation.scene();
  std::vector<std::string> found;
  if (scene.initial_stress == InitialStress::uniform) return uniform_warnings(scene);
  if (scene.initial_stress != InitialStress::geostatic) return found;
  const std::vector<double> pressure = pressures(simulation);
  const std::vector<double> of = simulation.field("material");
  for (std::size_t m = 0; m < scene.materials.size(); ++m) {
    const Material& material = scene.materials[m];
    if (!has_surface(material)) continue;
    const double reduction = reduction_of(scene.stages.front(), material);
    const double k0 = k0_of(scene, material);
    const auto holds = [&](double p) {
      const RestRange range = rest_range(material, reduction, p);
      constexpr double close = 1e-9;  // K0 on the surface itself is meant to be there
      return k0 >= range.active - close && k0 <= range.passive + close;
    };
    std::size_t count = 0, outside = 0;
    double most = 0.0;
    for (std::size_t i = 0; i < of.size(); ++i) {
      if (static_cast<std::size_t>(of[i]) != m || !(pressure[i] > 0.0)) continue;
      ++count;
      if (!holds(pressure[i])) ++outside;
      most = std::max(most, pressure[i]);
    }
    if (outside == 0) continue;
    const RestRange range = rest_range(material, reduction, most);
    const double becomes = std::clamp(k0, range.active, range.passive);
    found.push_back(fmt::format(
        "material '{}': K0 = {:.3g}{} is outside its yield surface in {:.0f} % of its soil. At its "
        "deepest, under {:.3g} kPa, the surface bears {:.3g} to {:.3g}, so K0 becomes {:.3g} there "
        "as "
        "it settles. Try k0 = {:.3g}, or a stronger soil (strength_reduction below 1) in stage "
        "'{}'.",
        material.name, k0, !material.k0 && !scene.initial_k0 ? ", which is nu/(1 - nu)," : "",
        100.0 * static_cast<double>(outside) / static_cast<double>(count), 1e-3 * most,
        range.active, range.passive, becomes, becomes, scene.stages.front().name));
  }
  return found;
}

}  // namespace scarp
