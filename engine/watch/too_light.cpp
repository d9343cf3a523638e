// SPDX-License-Identifier: BSD-3-Clause
/// Inertia against that of the present neighbours.
#include "engine/watch/too_light.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "engine/parallel.hpp"
#include "engine/particles/shared_inertia.hpp"
#include "engine/state.hpp"
#include "engine/watch/watch.hpp"

namespace scarp {
namespace {

/// Of the inertia that is asked for: rounding up and the margin of the step leave room for 2.
constexpr double too_little = 0.25;

struct TooLight {
  std::int64_t slot = -1;
  double asked = 0.0;
};

/// Looks through lists that are about to be built anew, which still hold whoever is within 2h.
/// Among its like no soil asks for more than it has.
class LightSearch {
 public:
  explicit LightSearch(const State& state)
      : state_(state),
        particles_(state.particles),
        lists_(state.neighbours.lists.view()),
        soil_end_(state.sweep.records.layout()[Role::owned].end()),
        asked_(state.scene) {
    particles_.components(Field::position, position_);
  }

  TooLight first_of(std::int64_t begin, std::int64_t end) {
    TooLight found;
    for (std::int64_t cluster = begin; cluster < end && found.slot < 0; ++cluster)
      found = look_at(cluster);
    return found;
  }

 private:
  TooLight look_at(std::int64_t cluster) {
    const std::int64_t size = state_.kernels.cluster_size, first = cluster * size;
    const ParticleGroup& group = particles_.group_of(first);
    find_neighbours(cluster, group.material);
    if (!mixed_) return {};
    for (std::int64_t k = first; k < std::min(first + size, group.end()); ++k) {
      AskedInertia::Sums sums;
      for (const std::int64_t j : neighbours_)
        asked_.add(group.material, particles_.group_of(j).material, distance(k, j), sums);
      const double asked = asked_.of(group.material, sums);
      if (group.mass_scaling < too_little * asked) return {k, asked};
    }
    return {};
  }

  void find_neighbours(std::int64_t cluster, std::size_t material) {
    neighbours_.clear();
    mixed_ = false;
    for (std::int64_t block = lists_.soil_begin[cluster]; block < lists_.wall_begin[cluster];
         ++block) {
      for (std::int64_t k = 0; k < kernels::entry_block; ++k) {
        const std::uint16_t place = lists_.place[block * kernels::entry_block + k];
        const std::int64_t record = lists_.page[block] + std::int64_t{place};
        if (place == kernels::no_neighbour || record >= soil_end_) continue;
        neighbours_.push_back(record);
        mixed_ = mixed_ || particles_.group_of(record).material != material;
      }
    }
  }

  double distance(std::int64_t i, std::int64_t j) const {
    double square = 0.0;
    for (int a = 0; a < particles_.dimension(); ++a) {
      const double along = position_[a][i] - position_[a][j];
      square += along * along;
    }
    return std::sqrt(square);
  }

  const State& state_;
  const ParticleBuffers& particles_;
  kernels::NeighbourView lists_;
  std::int64_t soil_end_;
  AskedInertia asked_;
  const double* position_[3];
  std::vector<std::int64_t> neighbours_;
  bool mixed_ = false;  ///< some of them are of another material
};

}  // namespace

void watch_inertia(const State& state) {
  if (!state.scaling.scales_mass) return;
  const TooLight light = parallel_reduce(
      state.threads, state.neighbours.lists.clusters(), particle_chunk / state.kernels.cluster_size,
      TooLight{},
      [&](std::int64_t begin, std::int64_t end) { return LightSearch(state).first_of(begin, end); },
      [](TooLight& first, const TooLight& part) {
        if (first.slot < 0) first = part;
      });
  if (light.slot < 0) return;
  Instability found = at_particle(state, light.slot);
  found.field = std::string("inertia over mass");
  found.unit = std::string("-");
  found.value = state.particles.group_of(light.slot).mass_scaling;
  found.limit = too_little * light.asked;
  found.cause =
      "soil that has come to touch a part with mass_scaling, which only bears the step "
      "beside soil that touched it from the start";
  found.advice =
      "without mass_scaling of that part, or with less of it; a lower Young's modulus "
      "of it makes the step longer as well";
  throw SimulationInstability(found);
}

}  // namespace scarp
