// SPDX-License-Identifier: BSD-3-Clause
// Included by one tiny source per instruction set, which defines SCARP_ARCH, SCARP_ISA and
// SCARP_ISA_NAME. Variants add: 22 sweeps in double and 16 in single precision in the full set, 10
// of each in the general one (SSE2 and the smoke set).
#include <array>

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

using enum Term;

/// What a scene without gradient correction, with it, and with the stress diffusion sums of the
/// velocity; and what it sums of the stress. `conjugate` ones are of scenes that correct forces
/// too.
constexpr TermSet plain{continuity, velocity_gradient}, corrected{velocity_gradient, moment},
    diffused{velocity_gradient, moment, diffusion}, viscous{momentum, viscosity},
    tensile{momentum, viscosity, artificial_stress},
    any_gradient = plain | diffused, conjugate_gradient = diffused | TermSet{wall_gradient},
    conjugate_viscous = viscous | TermSet{force_correction},
    conjugate_force = tensile | TermSet{force_correction, hourglass_viscosity};

template <class Real, int Dim, TermSet... Set>
constexpr std::array<CompiledSweep<Real>, sizeof...(Set)> compiled{
    {{{Dim, Set}, &pair_sweep<Arch, Real, Dim, Set>}...}};

template <class Real, std::size_t... Count>
consteval auto joined(const std::array<CompiledSweep<Real>, Count>&... part) {
  std::array<CompiledSweep<Real>, (Count + ...)> all{};
  std::size_t next = 0;
  const auto append = [&](const auto& sweeps) {
    for (const CompiledSweep<Real>& sweep : sweeps) all[next++] = sweep;
  };
  (append(part), ...);
  return all;
}

/// Special before general. The last four cover every scene, whose gradients and forces are then
/// summed one after the other. Before them stands what presets and validation cases run: the sweep
/// of "paper" without soil in tension and with it, that of "modern" with Verlet's integrator; the
/// gradients of "modern" for elastic bodies and for soil, and its forces. In single precision
/// sweeps that are rarely run have no kernel of their own.
#if defined(SCARP_GENERAL_SET) || defined(SCARP_KERNEL_SET_SMOKE)
template <class Real, int Dim>
constexpr auto special = compiled<Real, Dim, plain | tensile>;
#else
template <class Real, int Dim>
constexpr auto special = compiled<Real, Dim, plain | viscous, plain | tensile, diffused | viscous,
                                  corrected, diffused, viscous, conjugate_viscous>;
template <int Dim>
constexpr auto special<float, Dim> =
    compiled<float, Dim, plain | viscous, plain | tensile, diffused, conjugate_viscous>;
#endif
template <class Real, int Dim>
constexpr auto general =
    compiled<Real, Dim, any_gradient, tensile, conjugate_gradient, conjugate_force>;

template <class Real>
constexpr auto sweeps = joined(special<Real, 2>, general<Real, 2>, special<Real, 3>,
                               general<Real, 3>);

template <class... Model>
constexpr std::array<ModelPasses, sizeof...(Model)> passes_of(ModelList<Model...>) {
  using T = Batch<double, Arch>;
  return {ModelPasses{{&advance_stress<T, 2, Model>, &advance_stress<T, 3, Model>},
                      {&advance_verlet<T, 2, Model>, &advance_verlet<T, 3, Model>}}...};
}
constexpr std::array<ModelPasses, Models::size> passes = passes_of(Models{});

}  // namespace

const KernelTable& SCARP_TABLE() {
  static constexpr KernelTable table{SCARP_ISA,
                                     SCARP_ISA_NAME,
                                     cluster_size<double, Arch>,
                                     cluster_size<float, Arch>,
                                     sweeps<double>,
                                     sweeps<float>,
                                     {{{&wall_sweep<Arch, double, 2, WallSums::extrapolation>,
                                        &wall_sweep<Arch, double, 3, WallSums::extrapolation>},
                                       {&wall_sweep<Arch, double, 2, WallSums::gradient>,
                                        &wall_sweep<Arch, double, 3, WallSums::gradient>},
                                       {&wall_sweep<Arch, double, 2, WallSums::corrected_stress>,
                                        &wall_sweep<Arch, double, 3, WallSums::corrected_stress>},
                                       {&wall_sweep<Arch, double, 2, WallSums::weight>,
                                        &wall_sweep<Arch, double, 3, WallSums::weight>}}},
                                     passes,
                                     &filter_candidates<Arch>};
  return table;
}

}  // namespace scarp::kernels
