// SPDX-License-Identifier: BSD-3-Clause
/// Inertia that the stiffness of the neighbourhoods asks for.
#include "engine/particles/shared_inertia.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>

#include "engine/scene/smoothing_choice.hpp"
#include "kernels/smoothing/list.hpp"

namespace scarp {
namespace {

/// Less than this over the own inertia is no reason for a group of its own: what the lattice bears
/// beyond the step is more (THEORY.md, section 10).
constexpr double enough_more = 1.1;

using Cell = std::array<std::int64_t, 3>;
struct CellHash {
  std::size_t operator()(const Cell& c) const {
    const auto u = [](std::int64_t i) { return static_cast<std::uint64_t>(i); };
    return u(c[0]) * 73856093u ^ u(c[1]) * 19349663u ^ u(c[2]) * 83492791u;
  }
};

}  // namespace

AskedInertia::AskedInertia(const Scene& scene)
    : form_(smoothing_of(scene)), smoothing_length_(smoothing_length_of(scene)) {
  double fastest = 0.0;
  for (const Material& material : scene.materials)
    fastest = std::max(fastest, material.sound_speed());
  for (const Material& material : scene.materials) {
    modulus_.push_back(material.model.moduli().wave_modulus());
    unscaled_modulus_.push_back(material.density * fastest * fastest);
    mass_scaling_.push_back(material.mass_scaling);
  }
}

double AskedInertia::of(std::size_t material, const Sums& sums) const {
  const double own = mass_scaling_[material];
  if (!(sums.moduli > enough_more * own * sums.weights)) return own;
  return std::max(own, std::exp2(std::ceil(std::log2(sums.moduli / sums.weights))));
}

std::vector<double> shared_inertia(const Scene& scene, const Particles& soil) {
  const std::size_t count = soil.position.size();
  std::vector<double> inertia(count, 1.0);
  if (!scales_mass(scene)) return inertia;
  const AskedInertia asked(scene);
  const double reach = 2.0 * smoothing_length_of(scene);
  const auto cell_of = [&](const Vec3& x) {
    Cell cell{};
    for (std::size_t a = 0; a < 3; ++a)
      cell[a] = static_cast<std::int64_t>(std::floor(x[a] / reach));
    return cell;
  };
  std::unordered_map<Cell, std::vector<std::size_t>, CellHash> cells;
  for (std::size_t k = 0; k < count; ++k) cells[cell_of(soil.position[k])].push_back(k);
  for (std::size_t k = 0; k < count; ++k) {
    const Vec3& x = soil.position[k];
    const Cell centre = cell_of(x);
    AskedInertia::Sums sums;
    const std::int64_t deep = scene.dimension == 3 ? 1 : 0;
    for (std::int64_t a = -1; a <= 1; ++a) {
      for (std::int64_t b = -1; b <= 1; ++b) {
        for (std::int64_t c = -deep; c <= deep; ++c) {
          const auto found = cells.find({centre[0] + a, centre[1] + b, centre[2] + c});
          if (found == cells.end()) continue;
          for (const std::size_t j : found->second) {
            const Vec3& y = soil.position[j];
            asked.add(soil.material[k], soil.material[j],
                      std::hypot(x[0] - y[0], x[1] - y[1], x[2] - y[2]), sums);
          }
        }
      }
    }
    inertia[k] = asked.of(soil.material[k], sums);
  }
  return inertia;
}

}  // namespace scarp
