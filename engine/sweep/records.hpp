// SPDX-License-Identifier: BSD-3-Clause
/// Packed records of all particles.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/particles/aligned_vector.hpp"
#include "engine/particles/particle_buffers.hpp"
#include "engine/particles/record_layout.hpp"
#include "engine/particles/slot_ranges.hpp"
#include "kernels/pair/term.hpp"
#include "kernels/particle_view.hpp"
#include "kernels/tensor.hpp"

namespace scarp {

/// What turns a particle into a record, besides what its group knows.
struct RecordScaling {
  double inverse_smoothing_length = 1.0;
  double gradient_factor = 1.0;  ///< alpha_D / (h^(d+1) M), see kernels::RecordSlot
  /// By material, K + 4G/3 over the mass scaling: density times squared speed of sound [Pa].
  std::vector<double> wave_modulus;
  bool scales_mass = false;  ///< some material's inertia is not its mass
  /// By material the first that is alike: as stiff, and yields or not as it does. Empty: all are
  /// alike, or no term asks.
  std::vector<std::int32_t> alike = {};
};

/// What the stress slots of the soil's records hold: the stress, or T = sigma B, which the force is
/// summed of where it is corrected (K3).
enum class StressForm { plain, corrected };

/// A position no particle is near: b = max(2-q, 0) is 0 and every product stays finite.
inline constexpr double far_away = 1e8;

/// B of particle k from the components of its moment.
kernels::SymTensor<double> inverse_moment(const double* const (&moment)[6], std::int64_t k);

class Records {
 public:
  Records() = default;
  /// Of so many slots of soil, dummies and inner points, without ghosts and images.
  Records(std::int64_t owned_slots, std::int64_t dummy_slots, std::int64_t inner_slots = 0);

  const RecordLayout& layout() const { return layout_; }
  /// Room for this many ghosts and images; what they hold is lost, that of the others stays.
  void resize(int threads, std::int64_t ghosts, std::int64_t images);

  /// Writes what `read` names of the records of soil, owned or ghosts, and returns the largest
  /// squared displacement since the lists were built [m2] (0 without build positions). Position,
  /// volume, velocity, density and stress are always written: walls and images read them. In 3D
  /// part of a corrected stress stands in the second line. Other slots than `which` stay as they
  /// are.
  double pack(int threads, Role role, const ParticleBuffers& particles,
              const RecordScaling& scaling, kernels::SlotSet read, StressForm form,
              const SlotRanges& which = {});
  /// Puts inertia over volume in place of the density, where the two differ; before forces are
  /// summed, when walls and images have had the weight. Equation: I2.
  void put_inertia(int threads, Role role, const ParticleBuffers& particles,
                   const SlotRanges& which = {});
  /// How the soil was packed last.
  StressForm stress_form() const { return form_; }
  /// T of a record, and another one into it.
  kernels::Tensor<double> corrected_stress(std::int64_t index, int dimension);
  template <int Dim>
  void put_corrected_stress(std::int64_t index, const kernels::Tensor<double>& t);
  void put_corrected_stress(std::int64_t index, int dimension, const kernels::Tensor<double>& t);
  /// The same for h D/2 of the hourglass viscosity.
  kernels::SymTensor<double> strain_rate(std::int64_t index, int dimension);
  void put_strain_rate(std::int64_t index, int dimension, const kernels::SymTensor<double>& d);
  /// Room for second lines, all zero.
  void take_second();

  /// Notes the material of this soil, or the one that stands for it.
  void put_material(int threads, Role role, const ParticleBuffers& particles,
                    const std::vector<std::int32_t>& alike);
  /// Of a record of soil or of an image. Pre: that of the soil is noted.
  std::int32_t& material(std::int64_t index) { return material_[static_cast<std::size_t>(index)]; }

  double* record(Role role, std::int64_t slot) { return record(layout_[role].first + slot); }
  double* record(std::int64_t index) { return records_.data() + index * kernels::record_size; }
  /// Second line of a record, and whether it is not zero. Pre: has_second().
  double* second(std::int64_t index) {
    return second_.data() + index * kernels::second_record_size;
  }
  std::uint8_t& mark(std::int64_t index) { return marked_[static_cast<std::size_t>(index)]; }
  bool has_second() const { return !second_.empty(); }
  std::size_t bytes() const;

  /// The record part of a sweep's view; without marks the terms that need them add nothing.
  void fill(kernels::PairSweepView<double>& view, bool with_marks) const;
  const double* records() const { return records_.data(); }
  const double* extra_lines() const { return extra_.empty() ? nullptr : extra_.data(); }

 private:
  void take_extra();
  double* corrected_value(std::int64_t index, int place);
  double* strain_rate_value(std::int64_t index, int dimension, int a, int b);

  RecordLayout layout_;
  AlignedVector<double> records_;
  AlignedVector<double> second_, extra_;
  std::vector<std::uint8_t> marked_;
  std::vector<std::int32_t> material_;
  StressForm form_ = StressForm::plain;
};

}  // namespace scarp
