// SPDX-License-Identifier: BSD-3-Clause
/// Packed records of all particles.
#include "engine/sweep/records.hpp"

#include <algorithm>
#include <cmath>

#include "engine/parallel.hpp"

namespace scarp {

using namespace kernels;

Records::Records(std::int64_t owned_slots, std::int64_t dummy_slots) {
  layout_.resize(Role::owned, owned_slots);
  layout_.resize(Role::dummy, dummy_slots);
  resize(0, 0);
}

void Records::resize(std::int64_t ghosts, std::int64_t images) {
  const std::int64_t kept = records_.empty() ? 0 : layout_[Role::dummy].end();
  layout_.resize(Role::ghost, ghosts);
  layout_.resize(Role::image, images);
  records_.resize(static_cast<std::size_t>(layout_.records() * record_size));
  for (std::int64_t k = kept; k < layout_.records(); ++k) {
    std::fill_n(record(k), record_size, 0.0);
    record(k)[record_x] = far_away;
    record(k)[record_density] = 1.0;
  }
  if (has_second()) {
    take_second();
    std::fill(second_.begin() + kept * second_record_size, second_.end(), 0.0);
    std::fill(marked_.begin() + kept, marked_.end(), std::uint8_t{0});
  }
}

double Records::pack(int threads, Role role, const ParticleBuffers& particles,
                     const RecordScaling& scaling, SlotSet read) {
  const int dimension = particles.dimension();
  const double *position[3], *velocity[3], *built[3], *stress[6];
  particles.components(Field::position, position);
  particles.components(Field::velocity, velocity);
  particles.components(Field::build_position, built);
  particles.components(Field::stress, stress);
  const double* density = particles.component(Field::density);
  const double* diffusivity =
      read.has(record_diffusivity) ? particles.component(Field::diffusivity) : nullptr;
  const bool sound_speed = read.has(record_sound_speed);
  const double scale = scaling.inverse_smoothing_length;
  const bool moves = built[0] != nullptr;
  double* const first = record(role, 0);
  double largest = 0.0;
  for (const ParticleGroup& group : particles.groups()) {
    const double volume_mass = group.mass * scaling.gradient_factor;
    const double modulus = scaling.wave_modulus[group.material];
    const auto pack = [&](std::int64_t begin, std::int64_t end) {
      double farthest = 0.0;
      for (std::int64_t k = group.first + begin; k < group.first + end; ++k) {
        double* r = first + k * record_size;
        double moved = 0.0;
        for (int a = 0; a < dimension; ++a) {
          r[record_x + a] = position[a][k] * scale;
          r[record_velocity_x + a] = velocity[a][k];
          const double step = moves ? position[a][k] - built[a][k] : 0.0;
          moved += step * step;
        }
        if (!(moved <= farthest)) farthest = moved;
        const double inverse_density = 1.0 / density[k];
        r[record_volume] = volume_mass * inverse_density;
        r[record_density] = density[k];
        if (sound_speed) r[record_sound_speed] = std::sqrt(modulus * inverse_density);
        for (int c = 0; c < (dimension == 2 ? 4 : 6); ++c) r[record_stress + c] = stress[c][k];
        if (diffusivity != nullptr) r[record_diffusivity] = diffusivity[k] * scale;
      }
      return farthest;
    };
    const double moved = parallel_reduce(threads, group.count, particle_chunk, 0.0, pack,
                                         [](double& total, double part) {
                                           if (!(part <= total)) total = part;
                                         });
    if (!(moved <= largest)) largest = moved;
  }
  return largest;
}

void Records::take_second() {
  const auto total = static_cast<std::size_t>(layout_.records());
  second_.resize(total * second_record_size, 0.0);
  marked_.resize(total, 0);
}

void Records::fill(PairSweepView<double>& view, bool with_second) const {
  view.records = records_.data();
  view.second = with_second ? second_.data() : nullptr;
  view.marked = with_second ? marked_.data() : nullptr;
}

std::size_t Records::bytes() const {
  return (records_.size() + second_.size()) * sizeof(double) + marked_.size();
}

}  // namespace scarp
