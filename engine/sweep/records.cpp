// SPDX-License-Identifier: BSD-3-Clause
/// Packed records of all particles.
#include "engine/sweep/records.hpp"

#include <algorithm>
#include <cmath>

#include "engine/particles/each_slot.hpp"
#include "kernels/pair/list.hpp"

namespace scarp {

using namespace kernels;

namespace {

SymTensor<double> tensor_of(const double* const (&fields)[6], std::int64_t k) {
  const auto value = [&](int c) { return fields[c] != nullptr ? fields[c][k] : 0.0; };
  return {value(xx), value(yy), value(zz), value(xy), value(yz), value(zx)};
}

}  // namespace

Records::Records(std::int64_t owned_slots, std::int64_t dummy_slots, std::int64_t inner_slots) {
  layout_.resize(Role::owned, owned_slots);
  layout_.resize(Role::dummy, dummy_slots);
  layout_.resize(Role::inner, inner_slots);
  resize(1, 0, 0);
}

void Records::resize(int threads, std::int64_t ghosts, std::int64_t images) {
  const std::int64_t kept = records_.empty() ? 0 : layout_[Role::inner].end();
  layout_.resize(Role::ghost, ghosts);
  layout_.resize(Role::image, images);
  records_.resize(static_cast<std::size_t>(layout_.records() * record_size));
  const auto empty = [&](auto& lines, std::int64_t size, auto value) {
    parallel_chunks(threads, layout_.records() - kept, particle_chunk,
                    [&](std::int64_t begin, std::int64_t end) {
                      std::fill(lines.begin() + (kept + begin) * size,
                                lines.begin() + (kept + end) * size, value);
                    });
  };
  empty(records_, record_size, 0.0);
  parallel_chunks(threads, layout_.records() - kept, particle_chunk,
                  [&](std::int64_t begin, std::int64_t end) {
                    for (std::int64_t k = kept + begin; k < kept + end; ++k) {
                      record(k)[record_x] = far_away;
                      record(k)[record_density] = 1.0;
                    }
                  });
  if (has_second()) {
    take_second();
    empty(second_, second_record_size, 0.0);
    empty(marked_, 1, std::uint8_t{0});
  }
  if (!extra_.empty()) {
    take_extra();
    empty(extra_, extra_record_size, 0.0);
  }
}

double Records::pack(int threads, Role role, const ParticleBuffers& particles,
                     const RecordScaling& scaling, SlotSet read, StressForm form,
                     const SlotRanges& which) {
  const int dimension = particles.dimension();
  const double *position[3], *velocity[3], *built[3], *stress[6], *moment[6], *strain_rate[6];
  particles.components(Field::position, position);
  particles.components(Field::velocity, velocity);
  particles.components(Field::build_position, built);
  particles.components(Field::stress, stress);
  particles.components(Field::force_moment, moment);
  particles.components(Field::strain_rate, strain_rate);
  if (form == StressForm::corrected && dimension == 3) take_extra();
  form_ = form;
  const double* density = particles.component(Field::density);
  const double* diffusivity = read.has(record_diffusivity) && form == StressForm::plain
                                  ? particles.component(Field::diffusivity)
                                  : nullptr;
  const bool sound_speed = read.has(record_sound_speed);
  const double scale = scaling.inverse_smoothing_length, half_length = 0.5 / scale;
  const bool moves = built[0] != nullptr;
  const std::int64_t first_record = layout_[role].first;
  double* const first = record(first_record);
  double largest = 0.0;
  for (std::size_t index = 0; index < particles.groups().size(); ++index) {
    const ParticleGroup& group = particles.groups()[index];
    const double volume_mass = group.mass * scaling.gradient_factor;
    const double modulus = scaling.wave_modulus[group.material];
    const auto pack = [&](std::int64_t begin, std::int64_t end) {
      double farthest = 0.0;
      for (std::int64_t k = begin; k < end; ++k) {
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
        if (form == StressForm::corrected) {
          put_corrected_stress(
              first_record + k, dimension,
              kernels::corrected_stress(tensor_of(stress, k), inverse_moment(moment, k)));
          if (strain_rate[xx] != nullptr)
            put_strain_rate(first_record + k, dimension, half_length * tensor_of(strain_rate, k));
          continue;
        }
        for (int c = 0; c < (dimension == 2 ? 4 : 6); ++c) r[record_stress + c] = stress[c][k];
        if (diffusivity != nullptr) r[record_diffusivity] = diffusivity[k] * scale;
      }
      return farthest;
    };
    const double moved = reduce_slots(threads, which, group, index, group.end(), 0.0, pack,
                                      [](double& total, double part) {
                                        if (!(part <= total)) total = part;
                                      });
    if (!(moved <= largest)) largest = moved;
  }
  return largest;
}

void Records::put_inertia(int threads, Role role, const ParticleBuffers& particles,
                          const SlotRanges& which) {
  const double* density = particles.component(Field::density);
  double* const first = record(layout_[role].first);
  each_slot(threads, which, particles.slots(), [&](std::int64_t begin, std::int64_t end) {
    each_group(particles.groups(), begin, end,
               [&](const ParticleGroup& group, std::int64_t from, std::int64_t to) {
                 if (group.mass_scaling == 1.0) return;
                 to = std::min(to, group.end());
                 for (std::int64_t k = from; k < to; ++k)
                   first[k * record_size + record_density] = group.mass_scaling * density[k];
               });
  });
}

void Records::put_material(int threads, Role role, const ParticleBuffers& particles,
                           const std::vector<std::int32_t>& alike) {
  material_.resize(static_cast<std::size_t>(layout_.records()));
  const auto first = material_.begin() + layout_[role].first;
  parallel_chunks(threads, particles.slots(), particle_chunk,
                  [&](std::int64_t begin, std::int64_t end) {
                    each_group(particles.groups(), begin, end,
                               [&](const ParticleGroup& group, std::int64_t from, std::int64_t to) {
                                 std::fill(first + from, first + to, alike[group.material]);
                               });
                  });
}

void Records::take_second() {
  second_.resize(static_cast<std::size_t>(layout_.records()) * second_record_size, 0.0);
  marked_.resize(static_cast<std::size_t>(layout_.records()), 0);
}
void Records::take_extra() {
  extra_.resize(static_cast<std::size_t>(layout_.records()) * extra_record_size, 0.0);
}

SymTensor<double> inverse_moment(const double* const (&moment)[6], std::int64_t k) {
  SymTensor<double> m = tensor_of(moment, k);
  if (moment[yz] == nullptr) m.zz = 1.0;  // 2D
  return inverse_of(m);
}

double* Records::corrected_value(std::int64_t index, int place) {
  return place < 8 ? record(index) + record_stress + place
                   : extra_.data() + index * extra_record_size + corrected_extra + place - 8;
}
template <int Dim>
void Records::put_corrected_stress(std::int64_t index, const Tensor<double>& t) {
  for (int a = 0; a < Dim; ++a) {
    for (int b = 0; b < Dim; ++b) *corrected_value(index, corrected_place<Dim>(a, b)) = t.m[a][b];
  }
}
template void Records::put_corrected_stress<2>(std::int64_t, const Tensor<double>&);
template void Records::put_corrected_stress<3>(std::int64_t, const Tensor<double>&);
void Records::put_corrected_stress(std::int64_t index, int dimension, const Tensor<double>& t) {
  if (dimension == 2) return put_corrected_stress<2>(index, t);
  put_corrected_stress<3>(index, t);
}
Tensor<double> Records::corrected_stress(std::int64_t index, int dimension) {
  Tensor<double> t{};
  for (int a = 0; a < dimension; ++a) {
    for (int b = 0; b < dimension; ++b)
      t.m[a][b] = *corrected_value(index, corrected_place_of(dimension, a, b));
  }
  return t;
}

double* Records::strain_rate_value(std::int64_t index, int dimension, int a, int b) {
  if (dimension == 2) return record(index) + record_stress + strain_rate_place[a][b];
  return extra_.data() + index * extra_record_size + first_second<PairTerms, HourglassViscosity> +
         tensor_index[a][b];
}
void Records::put_strain_rate(std::int64_t index, int dimension, const SymTensor<double>& d) {
  const double all[6] = {d.xx, d.yy, d.zz, d.xy, d.yz, d.zx};
  for (int a = 0; a < dimension; ++a) {
    for (int b = a; b < dimension; ++b)
      *strain_rate_value(index, dimension, a, b) = all[tensor_index[a][b]];
  }
}
SymTensor<double> Records::strain_rate(std::int64_t index, int dimension) {
  double all[6] = {};
  for (int a = 0; a < dimension; ++a) {
    for (int b = a; b < dimension; ++b)
      all[tensor_index[a][b]] = *strain_rate_value(index, dimension, a, b);
  }
  return {all[xx], all[yy], all[zz], all[xy], all[yz], all[zx]};
}

void Records::fill(PairSweepView<double>& view, bool with_marks) const {
  view.records = records_.data();
  view.second = with_marks ? second_.data() : nullptr;
  view.marked = with_marks ? marked_.data() : nullptr;
  view.material = material_.empty() ? nullptr : material_.data();
  view.extra = form_ == StressForm::corrected ? extra_lines() : nullptr;
}

std::size_t Records::bytes() const {
  return (records_.size() + second_.size() + extra_.size()) * sizeof(double) + marked_.size() +
         material_.size() * sizeof(std::int32_t);
}

}  // namespace scarp
