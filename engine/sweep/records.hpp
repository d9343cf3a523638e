// SPDX-License-Identifier: BSD-3-Clause
/// Packed records of all particles, soil first, then dummies, mirror images, the far record.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/particles/aligned_vector.hpp"
#include "engine/particles/particle_buffers.hpp"
#include "kernels/particle_view.hpp"

namespace scarp {

/// What turns a particle into a record; one value per material.
struct RecordScaling {
  double inverse_smoothing_length = 1.0;
  double gradient_factor = 1.0;      ///< alpha_D / (h^(d+1) M), see kernels::RecordSlot
  std::vector<double> mass;          ///< [kg]
  std::vector<double> wave_modulus;  ///< K + 4G/3 [Pa]
};

/// A position no particle is near: b = max(2-q, 0) is 0 and every product stays finite.
inline constexpr double far_away = 1e8;

class Records {
 public:
  Records() = default;
  Records(std::int64_t soil_slots, std::int64_t wall_slots);

  /// Room for this many mirror images behind the dummies; the far record follows them.
  void resize_images(std::int64_t count);

  /// Writes the records of all soil particles and returns the largest squared displacement since
  /// the lists were built [m2] (0 without build positions).
  double pack_soil(int threads, const ParticleBuffers& particles, const RecordScaling& scaling);
  /// Writes the artificial stress of particles in tension (Eq. 27 with `epsilon`), and returns
  /// whether any is. Takes memory for tension records from the first time on that any is.
  bool pack_tension(int threads, const ParticleBuffers& particles, double epsilon);

  double* wall(std::int64_t dummy) {
    return records_.data() + (first_wall_ + dummy) * kernels::record_size;
  }
  double* record(std::int64_t index) { return records_.data() + index * kernels::record_size; }
  double* tension_record(std::int64_t index) {
    return tension_records_.data() + index * kernels::tension_record_size;
  }
  std::uint8_t& tension(std::int64_t index) { return tension_[static_cast<std::size_t>(index)]; }
  bool has_tension_records() const { return !tension_records_.empty(); }
  std::int64_t first_wall() const { return first_wall_; }
  std::int64_t first_image() const { return first_image_; }
  std::int64_t far_record() const { return far_record_; }
  std::size_t bytes() const;

  /// The record part of a sweep's view.
  void fill(kernels::PairSweepView<double>& view, bool with_tension) const;

 private:
  void resize_tension();
  bool any_tension(int threads, const ParticleBuffers& particles) const;

  std::int64_t first_wall_ = 0;
  std::int64_t first_image_ = 0;
  std::int64_t far_record_ = 0;
  AlignedVector<double> records_;
  AlignedVector<double> tension_records_;
  std::vector<std::uint8_t> tension_;
};

}  // namespace scarp
