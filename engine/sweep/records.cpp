// SPDX-License-Identifier: BSD-3-Clause
/// Packed records of all particles.
#include "engine/sweep/records.hpp"

#include <algorithm>
#include <cmath>

#include "engine/parallel.hpp"
#include "kernels/pair/artificial_stress_tensor.hpp"

namespace scarp {

using namespace kernels;

namespace {

SymTensor<double> stress_of(const double* const (&stress)[6], std::int64_t k, int dimension) {
  return {stress[xx][k],
          stress[yy][k],
          stress[zz][k],
          stress[xy][k],
          dimension == 3 ? stress[yz][k] : 0.0,
          dimension == 3 ? stress[zx][k] : 0.0};
}

}  // namespace

Records::Records(std::int64_t soil_slots, std::int64_t wall_slots)
    : first_wall_(soil_slots), first_image_(soil_slots + wall_slots), far_record_(first_image_) {
  resize_images(0);
}

void Records::resize_images(std::int64_t count) {
  const auto set_far = [this](std::size_t from) {
    for (std::size_t k = from; k * record_size < records_.size(); ++k) {
      std::fill_n(records_.begin() + static_cast<std::ptrdiff_t>(k * record_size), record_size,
                  0.0);
      records_[k * record_size + record_x] = far_away;
      records_[k * record_size + record_density] = 1.0;
    }
  };
  const auto kept = records_.empty() ? std::size_t{0} : static_cast<std::size_t>(first_image_);
  far_record_ = first_image_ + count;
  const auto total = static_cast<std::size_t>(far_record_ + 1);
  records_.resize(total * record_size);
  set_far(kept);
  if (has_tension_records()) {
    resize_tension();
    std::fill(tension_records_.begin() + first_image_ * tension_record_size, tension_records_.end(),
              0.0);
    std::fill(tension_.begin() + first_image_, tension_.end(), std::uint8_t{0});
  }
}

double Records::pack_soil(int threads, const ParticleBuffers& particles,
                          const RecordScaling& scaling) {
  const int dimension = particles.dimension();
  const double *position[3], *velocity[3], *built[3], *stress[6];
  particles.components(Field::position, position);
  particles.components(Field::velocity, velocity);
  particles.components(Field::build_position, built);
  particles.components(Field::stress, stress);
  const double* density = particles.component(Field::density);
  const double* diffusivity = particles.component(Field::diffusivity);
  const double scale = scaling.inverse_smoothing_length;
  double largest = 0.0;
  for (const ParticleGroup& group : particles.groups()) {
    const double volume_mass = scaling.mass[group.material] * scaling.gradient_factor;
    const double modulus = scaling.wave_modulus[group.material];
    const auto pack = [&](std::int64_t begin, std::int64_t end) {
      double farthest = 0.0;
      for (std::int64_t k = group.first + begin; k < group.first + end; ++k) {
        double* r = records_.data() + k * record_size;
        double moved = 0.0;
        for (int a = 0; a < dimension; ++a) {
          r[record_x + a] = position[a][k] * scale;
          r[record_velocity_x + a] = velocity[a][k];
          const double step = position[a][k] - built[a][k];
          moved += step * step;
        }
        if (!(moved <= farthest)) farthest = moved;
        const double inverse_density = 1.0 / density[k];
        r[record_volume] = volume_mass * inverse_density;
        r[record_density] = density[k];
        r[record_sound_speed] = std::sqrt(modulus * inverse_density);
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

void Records::resize_tension() {
  const auto total = static_cast<std::size_t>(far_record_ + 1);
  tension_records_.resize(total * tension_record_size, 0.0);
  tension_.resize(total, 0);
}

bool Records::any_tension(int threads, const ParticleBuffers& particles) const {
  const double* stress[6];
  particles.components(Field::stress, stress);
  bool any = false;
  for (const ParticleGroup& group : particles.groups()) {
    const auto look = [&](std::int64_t begin, std::int64_t end) {
      for (std::int64_t k = group.first + begin; k < group.first + end; ++k) {
        if (!in_compression(stress_of(stress, k, particles.dimension()), particles.dimension()))
          return 1;
      }
      return 0;
    };
    any |= parallel_reduce(threads, group.count, particle_chunk, 0, look,
                           [](int& total, int part) { total |= part; }) != 0;
  }
  return any;
}

bool Records::pack_tension(int threads, const ParticleBuffers& particles, double epsilon) {
  if (!has_tension_records()) {
    if (!any_tension(threads, particles)) return false;
    resize_tension();
  }
  const int dimension = particles.dimension();
  const double* stress[6];
  particles.components(Field::stress, stress);
  const double* density = particles.component(Field::density);
  bool any = false;
  for (const ParticleGroup& group : particles.groups()) {
    const auto pack = [&](std::int64_t begin, std::int64_t end) {
      int found = 0;
      for (std::int64_t k = group.first + begin; k < group.first + end; ++k) {
        const SymTensor<double> s = stress_of(stress, k, dimension);
        double* r = tension_records_.data() + k * tension_record_size;
        if (in_compression(s, dimension)) {
          if (tension_[static_cast<std::size_t>(k)] != 0)
            std::fill(r, r + tension_record_size, 0.0);
          tension_[static_cast<std::size_t>(k)] = 0;
          continue;
        }
        const SymTensor<double> tensile = positive_part(s, dimension);
        const double factor =
            -epsilon / density[k];  // rho R, since the sweep divides by one density only
        r[xx] = factor * tensile.xx;
        r[yy] = factor * tensile.yy;
        r[zz] = factor * tensile.zz;
        r[xy] = factor * tensile.xy;
        r[yz] = factor * tensile.yz;
        r[zx] = factor * tensile.zx;
        tension_[static_cast<std::size_t>(k)] = 1;
        found = 1;
      }
      return found;
    };
    any |= parallel_reduce(threads, group.count, particle_chunk, 0, pack,
                           [](int& total, int part) { total |= part; }) != 0;
  }
  return any;
}

void Records::fill(PairSweepView<double>& view, bool with_tension) const {
  view.records = records_.data();
  view.tension_records = with_tension ? tension_records_.data() : nullptr;
  view.tension = with_tension ? tension_.data() : nullptr;
}

std::size_t Records::bytes() const {
  return (records_.size() + tension_records_.size()) * sizeof(double) + tension_.size();
}

}  // namespace scarp
