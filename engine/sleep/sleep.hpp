// SPDX-License-Identifier: BSD-3-Clause
/// Soil asleep: blocks of particles that rest are neither swept nor updated until something near
/// them moves.
#pragma once

#include <cstddef>
#include <cstdint>
#include <numbers>
#include <span>
#include <vector>

#include "engine/boundary/mirror_images.hpp"
#include "engine/boundary/walls.hpp"
#include "engine/particles/slot_ranges.hpp"
#include "engine/sleep/block_graph.hpp"
#include "engine/step/phase.hpp"

namespace scarp {

struct State;

/// What soil that sleeps is to the sweeps: `edge` has neighbours that are awake, so its force is
/// summed and looked at; `read` is what those sums and the dummies near them read besides.
enum class Rest : std::uint8_t { awake, edge, read, deep };

/// Bounds of a stage; zero: nothing sleeps in it, nor in a soil that is held in several parts.
/// Equation: Z1.
struct SleepBounds {
  double lasting = 0.0;       ///< e g: mean |f + g| that calm soil may have, within 4/pi [m/s2]
  double speed = 0.0;         ///< below which soil is calm [m/s]
  double acceleration = 0.0;  ///< |f + g| below which it is calm [m/s2]
  double window = 0.0;        ///< time of calm before it falls asleep, and of means [s]

  /// Mean change of f at the edge of what sleeps that wakes it [m/s2], e g H/(4h). A stress that
  /// changes by e rho g H/2 on one side of a plane gives the row of particles beside it f of at
  /// least that: 1/2 to 0.7 of the stress over rho h, whatever the smoothing, at h = dx to 2 dx.
  /// What sleeps may be pushed the same way from two sides.
  double change_at_edge() const { return 0.125 * std::numbers::pi * acceleration; }
};

/// What sweeps read while some soil sleeps.
struct SleepReads {
  SlotRanges soil;
  SlotRanges packed;  ///< ... whose records are not those of the last sweep of forces any more
  RawVector<std::int32_t> wall_clusters;  ///< of dummies
  std::vector<std::size_t> wall_columns;
  MirrorImages::Generations images;
};

/// Of which soil records stand as the next sweep reads them.
enum class Reading : std::uint8_t { all, awake, edge };

struct Sleep {
  SleepBounds bounds;
  std::int64_t asleep = 0;    ///< particles
  double moved = 0.0;         ///< farthest that these had moved since the lists were built [m]
  double kinetic = 0.0;       ///< energy taken from soil that fell asleep in this stage [J]
  bool wake_due = false;      ///< everything wakes before the next step
  bool graph_valid = false;   ///< `graph` is of the lists and walls that stand
  bool records_stale = true;  ///< records of any soil may not be those of the last sweep of forces
  bool fell = false;          ///< ... of soil that has just fallen asleep, in `edge_reads`
  Reading reading = Reading::all;
  BlockGraph graph;
  std::vector<std::uint8_t> rim;     ///< by block: 1 where it is awake and a neighbour sleeps
  std::vector<Rest> rest;            ///< by block; empty: everything is awake
  std::vector<std::uint8_t> fallen;  ///< by block: 1 where it fell asleep at the last look
  SlotRanges awake, swept;           ///< swept: with the edge
  RawVector<std::int32_t> awake_clusters, swept_clusters;
  /// Of soil awake; of that and the edge, with what has just fallen asleep.
  SleepReads awake_reads, edge_reads;

  bool wanted() const { return bounds.lasting > 0.0; }
  bool any() const { return asleep > 0; }
  bool is_awake(std::int64_t slot) const {
    return !any() || rest[static_cast<std::size_t>(slot / block_size)] == Rest::awake;
  }
};

/// Steps between two looks at the edge of what sleeps. Sound goes on by cfl h, 0.8 h in `modern`,
/// in a step: between two looks by no more than a block is wide, 4 dx in 2D and 2 dx in 3D where it
/// is thinnest.
constexpr std::uint64_t steps_per_edge_look(int dimension) { return dimension == 2 ? 4 : 2; }

/// Clusters of soil that are awake, ... with the edge where its force is looked at next.
std::span<const std::int32_t> awake_clusters(const State& state);
std::span<const std::int32_t> swept_clusters(const State& state);
/// Decides what is packed for a sweep, of forces or not; `all` packs everything.
void choose_reading(State& state, bool for_forces, bool all);
/// By that: soil whose records are packed, soil whose records may be read, dummies that are summed
/// and images.
SlotRanges soil_packed(const State& state);
SlotRanges soil_read(const State& state);
Walls::Chosen walls_summed(const State& state);
const MirrorImages::Generations& images_packed(const State& state);
/// The slots of swept_clusters.
const SlotRanges& swept_slots(const State& state);

/// Bounds of a stage in which the tallest column of soil is `height` [m] and a wave needs `passage`
/// [s] through it. Soil that settles is a search for balance with all of it: there they are zero.
void set_sleep_bounds(State& state, double height, double passage);
/// Everything is awake from now on, and calm no earlier than from now on.
void wake_all(State& state);
/// What sleeps, from the field `asleep`, after the lists or that field have been made anew. Blocks
/// wake of which a particle is awake, and those that a wall drives.
void regroup_sleep(State& state);
/// Who is edge, read or deep, after blocks have fallen asleep or woken.
void classify_sleep(State& state);
void ensure_block_graph(State& state);
/// Wakes what is out of balance or has a fast neighbour; now and then looks for what rests.
void update_sleep(State& state);

namespace phases {

inline constexpr DataSet levels_of_rest{
    Field::velocity,     Field::previous_velocity, Field::previous_density,  Field::previous_stress,
    Field::diffusivity,  Field::strain_rate,       Field::approach_rate,     Field::asleep,
    Field::stirred_time, Field::stirred_history,   Field::rest_acceleration, Field::rest_change};
inline constexpr Phase update_sleep{
    "update_sleep",
    levels_of_rest | DataSet(Field::acceleration, Field::density, Field::stress, Part::history,
                             Part::lists, Part::walls),
    levels_of_rest, scarp::update_sleep};

}  // namespace phases

}  // namespace scarp
