// SPDX-License-Identifier: BSD-3-Clause
// Included by one tiny source per instruction set, which defines SCARP_ARCH, SCARP_ISA and
// SCARP_ISA_NAME. Variants add: 28 sweeps in double and 18 in single precision in the full set, 6
// of each in the general one (SSE2 and the smoke set).

#include "kernels/constitutive/list.hpp"
#include "kernels/constitutive/stress_pass.hpp"
#include "kernels/isa/kernel_table.hpp"
#include "kernels/neighbour_filter.hpp"
#include "kernels/pair/pair_sweep.hpp"
#include "kernels/pair/wall_sweep.hpp"
#include "kernels/simd_math.hpp"

namespace scarp::kernels {
namespace {

using Arch = SCARP_ARCH;

template <int Dim, Terms Which, bool UseViscosity, bool UseArtificialStress, bool UseCorrection,
          bool UseDiffusion, bool UseContinuity = Which != Terms::force>
constexpr CompiledSweep<double> compiled{
    {Dim, Which, UseViscosity, UseArtificialStress, UseCorrection, UseDiffusion, UseContinuity},
    &pair_sweep<Arch, double,
                SweepTraits<Dim, Which, UseViscosity, UseArtificialStress, UseCorrection,
                            UseDiffusion, UseContinuity>>};

constexpr bool on = true, off = false;
constexpr CompiledSweep<double> sweeps[] = {
#if !defined(SCARP_GENERAL_SET) && !defined(SCARP_KERNEL_SET_SMOKE)
    compiled<2, Terms::fused, off, off, off, off>,
    compiled<2, Terms::fused, off, off, on, on, off>,
    compiled<2, Terms::fused, on, off, off, off>,
    compiled<2, Terms::fused, on, off, on, off, off>,
    compiled<2, Terms::fused, on, off, on, on, off>,
    compiled<2, Terms::fused, on, on, off, off>,
    compiled<2, Terms::gradient, off, off, off, off>,
    compiled<2, Terms::gradient, off, off, on, off, off>,
    compiled<2, Terms::gradient, off, off, on, on, off>,
    compiled<2, Terms::force, off, off, off, off>,
    compiled<2, Terms::force, on, off, off, off>,
    compiled<3, Terms::fused, off, off, off, off>,
    compiled<3, Terms::fused, off, off, on, on, off>,
    compiled<3, Terms::fused, on, off, off, off>,
    compiled<3, Terms::fused, on, off, on, off, off>,
    compiled<3, Terms::fused, on, off, on, on, off>,
    compiled<3, Terms::fused, on, on, off, off>,
    compiled<3, Terms::gradient, off, off, off, off>,
    compiled<3, Terms::gradient, off, off, on, off, off>,
    compiled<3, Terms::gradient, off, off, on, on, off>,
    compiled<3, Terms::force, off, off, off, off>,
    compiled<3, Terms::force, on, off, off, off>,
#endif
    compiled<2, Terms::fused, on, on, on, on>,
    compiled<2, Terms::gradient, off, off, on, on>,
    compiled<2, Terms::force, on, on, off, off>,
    compiled<3, Terms::fused, on, on, on, on>,
    compiled<3, Terms::gradient, off, off, on, on>,
    compiled<3, Terms::force, on, on, off, off>,
};

template <int Dim, Terms Which, bool UseViscosity, bool UseArtificialStress, bool UseCorrection,
          bool UseDiffusion, bool UseContinuity = Which != Terms::force>
constexpr CompiledSweep<float> in_float{
    {Dim, Which, UseViscosity, UseArtificialStress, UseCorrection, UseDiffusion, UseContinuity},
    &pair_sweep<Arch, float,
                SweepTraits<Dim, Which, UseViscosity, UseArtificialStress, UseCorrection,
                            UseDiffusion, UseContinuity>>};

constexpr CompiledSweep<float> mixed[] = {
#if !defined(SCARP_GENERAL_SET) && !defined(SCARP_KERNEL_SET_SMOKE)
    in_float<2, Terms::fused, on, off, off, off>,
    in_float<2, Terms::fused, on, on, off, off>,
    in_float<2, Terms::gradient, off, off, off, off>,
    in_float<2, Terms::gradient, off, off, on, off, off>,
    in_float<2, Terms::gradient, off, off, on, on, off>,
    in_float<2, Terms::force, on, off, off, off>,
    in_float<3, Terms::fused, on, off, off, off>,
    in_float<3, Terms::fused, on, on, off, off>,
    in_float<3, Terms::gradient, off, off, off, off>,
    in_float<3, Terms::gradient, off, off, on, off, off>,
    in_float<3, Terms::gradient, off, off, on, on, off>,
    in_float<3, Terms::force, on, off, off, off>,
#endif
    in_float<2, Terms::fused, on, on, on, on>,
    in_float<2, Terms::gradient, off, off, on, on>,
    in_float<2, Terms::force, on, on, off, off>,
    in_float<3, Terms::fused, on, on, on, on>,
    in_float<3, Terms::gradient, off, off, on, on>,
    in_float<3, Terms::force, on, on, off, off>,
};

constexpr std::array<ModelPasses, Models::size> passes = []<class... Model>(ModelList<Model...>) {
  using T = Batch<double, Arch>;
  return std::array<ModelPasses, Models::size>{
      ModelPasses{{&advance_stress<T, 2, Model>, &advance_stress<T, 3, Model>},
                  {&advance_verlet<T, 2, Model>, &advance_verlet<T, 3, Model>}}...};
}(Models{});

}  // namespace

const KernelTable& SCARP_TABLE() {
  static constexpr KernelTable table{SCARP_ISA,
                                     SCARP_ISA_NAME,
                                     cluster_size<double, Arch>,
                                     cluster_size<float, Arch>,
                                     sweeps,
                                     mixed,
                                     {&wall_sweep<Arch, double, 2>, &wall_sweep<Arch, double, 3>},
                                     passes,
                                     &filter_candidates<Arch>};
  return table;
}

}  // namespace scarp::kernels
