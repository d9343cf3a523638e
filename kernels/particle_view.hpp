// SPDX-License-Identifier: BSD-3-Clause
/// Views of the particle arrays that sweeps and passes read and write; they own nothing.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "kernels/always_inline.hpp"

namespace scarp::kernels {

/// Order of the components of a symmetric tensor everywhere; 2D uses the first four.
enum Component { xx, yy, zz, xy, yz, zx };

/// What a pair needs of particle j, packed so that one pair touches one or two cache lines, four
/// values that are used together side by side (RecordQuad).
/// Positions are in units of h; `volume` is V_j alpha_D / (h^(d+1) M), so that factor times dW/dq /
/// q times a position difference is V_j grad W; `diffusivity` is D_j / h.
enum RecordSlot {
  record_x,
  record_y,
  record_z,
  record_volume,
  record_velocity_x,
  record_velocity_y,
  record_velocity_z,
  record_density,
  record_stress,  ///< six components
  record_sound_speed = record_stress + 6,
  record_diffusivity,
  record_size
};
static_assert(record_size == 16);
static_assert(record_x % 4 == 0 && record_velocity_x % 4 == 0 && record_stress % 4 == 0,
              "vectors load four values from aligned places");

/// In single precision a record's position is a 32-bit integer, its bits in place of the float: a
/// multiple of this length in units of h, so that differences of positions are exact and know no
/// origin.
inline constexpr double position_step = 0x1p-18;
/// Positions further than this from the origin of the records do not fit: with the far record at
/// twice the distance no difference overflows.
inline constexpr double position_reach = 0x1p29 * position_step;

/// Moments with a smaller determinant are not inverted, or where forces are corrected led to the
/// identity (`keep_invertible`): a few stray neighbours in a line or plane. Edges (0.15 in 2D, 0.09
/// in 3D) and corners (0.03 in 3D) of a lattice are not: they must not take rotation for strain.
template <int Dim>
inline constexpr double smallest_moment_determinant = Dim == 2 ? 0.1 : 0.01;

/// Most that the velocity of a dummy lies beyond that of its wall, in soil velocities relative to
/// the wall (B1). A dense layer half a spacing off the face would have 1 to 3. The lower the limit,
/// the more a thin elastic layer feeds waves by itself (engine/THEORY.md, section 4); but soil
/// under the edge of a footing loses its contact beyond the lower one (case `footing`).
inline constexpr double extrapolation_limit = 0.8;
inline constexpr double extrapolation_limit_near_edge = 0.5;

/// A second line of a record for terms that need more of particle j: each has its own values there
/// (PairTerm::second_slots). Packed only where a term of the run reads it.
inline constexpr int second_record_size = 8;
/// The same for values that every pair reads; in 3D alone.
inline constexpr int extra_record_size = 8;
/// Values by particle that all pair terms of a sweep may write together.
inline constexpr int most_outputs = 32;

/// Wall face of a dummy particle: unit normal towards the soil, distance behind the face in units
/// of h, limit of its extrapolation.
enum WallSlot {
  wall_normal_x,
  wall_normal_y,
  wall_normal_z,
  wall_distance,
  wall_limit,
  wall_record_size
};

/// Neighbours of clusters of particles, in blocks of `entry_block` records that share a page, so
/// that two bytes tell each: page[block] + place[entry], or the far record for `no_neighbour`.
/// Blocks [soil_begin[c], wall_begin[c]) hold soil and images, [wall_begin[c], wall_end[c])
/// dummies, [wall_end[c], soil_begin[c + 1]) inner points of walls, which have no volume.
struct NeighbourView {
  const std::int32_t* page;        ///< by block: first record of its page
  const std::uint16_t* place;      ///< by entry, entry_block to a block
  const std::int64_t* soil_begin;  ///< clusters and one more
  const std::int64_t* wall_begin;
  const std::int64_t* wall_end;
  std::int32_t far_record;
};
inline constexpr int entry_block = 8;
inline constexpr std::uint16_t no_neighbour = 0xffff;
inline constexpr std::int32_t page_size = no_neighbour;

/// Coefficients of the smoothing function, see `kernels/smoothing/smoothing.hpp`, in truncated
/// powers b = max(2-q, 0), a = max(1-q, 0).
template <class Real>
struct SmoothingView {
  Real derivative[3];     ///< of b^2, b^3, b^4
  Real derivative_inner;  ///< of a^2
  Real value[3];          ///< of b^3, b^4, b^5
  Real value_inner;       ///< of a^3
};

/// F^n of the artificial stress in the truncated powers of the smoothing function: b^2 times the
/// polynomial `outer` in b plus a^3 times the polynomial `inner` in a.
template <class Real>
struct TensionFactorView {
  Real outer[8];
  Real inner[5];
};

/// Run-time constants of a pair sweep.
template <class Real>
struct PairConstants {
  SmoothingView<Real> smoothing;
  Real viscosity_alpha;
  Real viscosity_beta;
  Real hourglass_viscosity;
  Real gravity[3];  ///< times h [m2/s2], for the lithostatic part of diffusion
  TensionFactorView<Real> tension_factor;
};

/// Input and output of a pair sweep. Records start on a cache line. Outputs are SoA by particle,
/// SI; a null pointer leaves one out.
template <class Real>
struct PairSweepView {
  const Real* records;         ///< soil, dummies, mirror images, far record; x record_size
  const Real* second;          ///< second lines, x second_record_size; null: no term reads them
  const Real* extra;           ///< extra lines, x extra_record_size; null: no term reads them
  const std::uint8_t* marked;  ///< 1 where the second line is not zero
  /// By record of soil its material, alike ones as one; each cluster has one. Null: all are alike.
  const std::int32_t* material;
  const std::int32_t* clusters;  ///< the active ones
  NeighbourView neighbours;
  PairConstants<Real> constants;
  double smoothing_length;
  /// What each term of `PairTerms` writes, component by component (`output_place`).
  double* output[most_outputs];
};

/// State and rates of a range of particles for the stress pass and the update; SoA, SI, null where
/// the scene does not use a field.
struct ParticleView {
  double* position[3];
  double* velocity[3];
  double* density;
  double* stress[6];
  double* previous_velocity[3];  ///< level n-1 of the Verlet scheme
  double* previous_density;
  double* previous_stress[6];
  double* history[4];      ///< history variables of the model, in its order
  double* plastic_work;    ///< per mass [J/kg]
  double* diffusion_work;  ///< per mass [J/kg]
  double* stress_work;     ///< of the stress on the strain the stress pass used, per mass [J/kg]
  double* diffusivity;     ///< D of the stress diffusion [m2/s]
  const double* density_rate;
  const double* velocity_gradient[9];
  double* strain_rate[6];  ///< of the corrected gradient, for the hourglass viscosity [1/s]
  const double* moment[6];
  double* force_moment[6];  ///< at the end of the step; null: the force is not corrected
  const double* acceleration[3];
  const double* diffusion_rate[6];
  const double* diffusion_slope;
};

/// What a model keeps of its parameters, packed so that passes of all models have one type.
struct ModelConstants {
  alignas(8) unsigned char bytes[256];
};
template <class Constants>
inline ModelConstants packed(const Constants& constants) {
  static_assert(std::is_trivially_copyable_v<Constants> &&
                sizeof(Constants) <= sizeof(ModelConstants));
  ModelConstants all{};
  __builtin_memcpy(all.bytes, &constants, sizeof(Constants));
  return all;
}
template <class Constants>
SCARP_INLINE Constants unpacked(const ModelConstants& all) {
  Constants constants;
  __builtin_memcpy(&constants, all.bytes, sizeof(Constants));
  return constants;
}

/// What the stress pass needs besides the particles: one material, one step.
struct StressPassConstants {
  ModelConstants model;
  double reference_density;
  double density_minimum, density_maximum;  ///< absolute [kg/m3]; applied if gradient_correction
  double leap;                              ///< time over which the rates act [s]
  double plastic_share;                     ///< part of a plastic increment that is new: dt / leap
  double smoothing_length;
  double diffusion_cap;  ///< 0: no diffusion
  double diffusion_shear_gate;
  double gravity[3];
  double k0;  ///< horizontal over vertical stress, for the diffusion
  bool gradient_correction;
  bool hughes_winget;
};

/// What the Verlet update needs besides StressPassConstants.
struct VerletConstants {
  double dt;       ///< from n to n+1 [s]
  bool leaps;      ///< base level is n-1 (Eq. 28); false: n (Eq. 29)
  double damping;  ///< c_d of F = -c_d v [1/s]
};

/// Candidate test of the list build: which of `count` points lie within `radius` of any of
/// `cluster_count`.
struct CandidateView {
  const double* x;
  const double* y;
  const double* z;
  int count;  ///< padded by 8 with far points
  const double* cluster_x;
  const double* cluster_y;
  const double* cluster_z;
  int cluster_count;
  double radius_squared;
};

/// What a wall sweep makes of the soil near dummies.
enum class WallSums {
  extrapolation,     ///< velocity and stress, where forces are not corrected
  gradient,          ///< G_w/sum_k W_wk
  corrected_stress,  ///< average of T
  weight             ///< sum_k W_wk and height alone
};
inline constexpr int wall_sums_count = 4;

/// Input and output of the wall sweeps. The records of the dummies come with the velocity of their
/// wall; records and faces start on a cache line.
template <class Real>
struct WallSweepView {
  const Real* records;
  const Real* extra;         ///< extra lines; null: none
  NeighbourView neighbours;  ///< clusters of dummies, entries in the soil range
  SmoothingView<Real> smoothing;
  Real gravity[3];          ///< g times h [m2/s2]
  std::int64_t first_wall;  ///< index of the first dummy in `records`
  const Real* faces;        ///< dummies x wall_record_size, padding included
  double* velocity[3];      ///< by dummy [m/s]; extrapolation alone
  /// By dummy: stress [Pa]; G_w/sum W in the order of the components of a 3 x 3 matrix, or T in
  /// the order of `corrected_place`, without the weight of the soil along the normal.
  double* sums[10];
  /// By dummy, 0 without soil in reach: sum W; where forces are corrected mean height of the soil
  /// over the dummy along its normal, in h; and with T the weight of the soil along the normal
  /// [Pa].
  double *weight, *height, *overburden;
};

}  // namespace scarp::kernels
