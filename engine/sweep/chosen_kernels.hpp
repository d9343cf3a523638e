// SPDX-License-Identifier: BSD-3-Clause
/// What of the compiled kernels a scene runs, and which particle fields its pair terms use.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/particles/field_list.hpp"
#include "engine/scene/scene.hpp"
#include "kernels/isa/kernel_table.hpp"
#include "kernels/pair/term.hpp"

namespace scarp {

/// A pair sweep in the precision of the run; the other one is null.
struct SweepKernel {
  kernels::PairSweep<double> in_double = nullptr;
  kernels::PairSweep<float> mixed = nullptr;

  explicit operator bool() const { return in_double != nullptr || mixed != nullptr; }
};

/// A sweep, and the one that runs while the second line of every record is zero.
struct ChosenSweep {
  SweepKernel whole, unmarked;
};

/// Sweeps and passes chosen once per run.
struct ChosenKernels {
  const kernels::KernelTable* table = nullptr;
  int cluster_size = 0;  ///< of the pair sweeps
  kernels::TermSettings settings;
  kernels::TermSet terms;  ///< the scene's
  kernels::SlotSet slots;  ///< of the records that they read
  ChosenSweep fused;       ///< Verlet's; none: the two halves one after the other
  ChosenSweep gradient;    ///< of the velocity
  ChosenSweep force;       ///< also of wall reactions and energies

  /// Whether gradients and forces are corrected; the records then hold one or the other.
  bool corrects_forces() const { return terms.has(kernels::Term::force_correction); }
};

/// What the numerics ask of the pair terms; `yields`: any material does.
kernels::TermSettings term_settings(const Numerics& numerics, bool yields);
ChosenKernels choose_kernels(const Scene& scene, bool yields, const kernels::KernelTable& table);

/// By material the first with its moduli that yields or not as it does: between such the stress
/// diffuses (D1). Empty where it is one for all.
std::vector<std::int32_t> first_alike(const std::vector<Material>& materials);

/// The row of a field that a term names; every one is there.
Field field_of(const kernels::FieldUse& use);
/// The fields of every run.
inline constexpr std::array<Field, 6> fields_of_every_run{
    Field::position, Field::velocity,           Field::density,
    Field::stress,   Field::reference_position, Field::build_position};
/// The fields that these terms write and read beyond those.
std::vector<Field> fields_of(kernels::TermSet terms);
/// Where the components of a field that a pair term writes begin in PairSweepView::output.
int output_place(Field field);

}  // namespace scarp
