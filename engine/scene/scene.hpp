// SPDX-License-Identifier: BSD-3-Clause
/// A scene as plain data: what `scene_reader` fills from TOML and what an embedding program may
/// fill itself. SI units, angles in radians, tension positive.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "engine/scene/soil_model.hpp"

namespace scarp {

using Vec3 = std::array<double, 3>;

enum class SmoothingFunction { yang_liu, cubic_spline, wendland_c2, by_dimension };
enum class StressRotation { jaumann, hughes_winget };
enum class Integrator { verlet, kick_drift_kick };
enum class WallKind { no_slip, free_slip };
enum class StageEnd { duration, rest };
enum class InitialStress { zero, geostatic, uniform };

enum class Precision { real64, mixed };

/// Words of a choice in scenes and results, in the order of its enum.
template <class Choice>
inline constexpr std::string_view words{};
template <>
inline constexpr std::string_view words<SmoothingFunction> =
    "yang_liu|cubic_spline|wendland_c2|auto";
template <>
inline constexpr std::string_view words<StressRotation> = "jaumann|hughes_winget";
template <>
inline constexpr std::string_view words<Integrator> = "verlet|kick_drift_kick";
template <>
inline constexpr std::string_view words<Precision> = "double|mixed";

/// The word of one choice.
template <class Choice>
requires(!words<Choice>.empty()) constexpr std::string_view word(Choice choice) {
  std::string_view rest = words<Choice>;
  for (auto before = static_cast<int>(choice); before != 0; --before) {
    const std::size_t bar = rest.find('|');
    if (bar == std::string_view::npos) return "unknown";
    rest.remove_prefix(bar + 1);
  }
  return rest.substr(0, rest.find('|'));
}

/// `engine/scene/numerics_list.hpp` has one row for each member; the defaults are the preset
/// "modern".
struct Numerics {
  std::string preset = "modern";
  SmoothingFunction smoothing = SmoothingFunction::by_dimension;  ///< `smoothing_function_of`
  std::optional<double> smoothing_ratio{};  ///< h/dx [-]; empty: `smoothing_ratio_of`
  bool lattice_normalisation = true;        ///< divide grad W by the lattice moment
  bool gradient_correction = true;          ///< correct the velocity gradient; density rate from it
  bool force_correction = true;  ///< ... and the force, conjugate to it; walls by their average
  bool relaxed_packing = true;   ///< soil beside walls off the lattice is packed anew
  StressRotation stress_rotation = StressRotation::hughes_winget;
  double viscosity_alpha = 0.1;      ///< Eq. 26 [-]
  double viscosity_beta = 0.0;       ///< Eq. 26 [-]
  double hourglass_viscosity = 0.0;  ///< V1 [-]; 0 leaves it out; acts with `force_correction`
  double artificial_stress = 0.0;    ///< epsilon of Eq. 27 [-]; 0 leaves the term out
  std::optional<double> artificial_stress_exponent{};  ///< n of Eq. 20 [-]; empty: W(0)/W(dx)
  double stress_diffusion = 0.15;       ///< cap of the diffusivity in h c [-]; 0 leaves it out
  double diffusion_shear_gate = 150.0;  ///< diffusivity per h^2 |shear rate| [-]
  Integrator integrator = Integrator::kick_drift_kick;
  int verlet_restart_interval = 40;  ///< M of Eq. 29 [steps]
  double cfl = 0.8;                  ///< N_CFL of Eq. 30 [-]
  double skin = 0.15;                ///< margin of the neighbour lists in h [-]
  double density_minimum = 0.5;      ///< bound on density over reference density [-]
  double density_maximum = 1.2;      ///< bound on density over reference density [-]
  double sleep = 0.0;  ///< error of stress that soil asleep may make, over overburden [-]
  Precision precision = Precision::real64;  ///< of the pair sweep; the state is always double

  /// The corrected force is the conjugate of the corrected gradient, so there is none without it.
  bool corrects_force() const { return gradient_correction && force_correction; }
};

struct Material {
  std::string name{};
  SoilModel model{};           ///< as in `DruckerPrager{.youngs_modulus = 10e6, ...}`
  double density = 0.0;        ///< reference density [kg/m3]
  std::optional<double> k0{};  ///< horizontal over vertical stress; empty: `Scene::initial_k0`
  double mass_scaling = 1.0;   ///< inertia over mass, 1 or more [-]; weight stays. Equation: I2

  /// Of pressure waves, with the scaled inertia [m/s]. Pre: the material is valid
  double sound_speed() const;
};

struct Polygon {  ///< 2D outline, or in 3D its extrusion along y
  std::vector<std::array<double, 2>> points{};
  /// 3D only: outline lies in the x-z plane (z up) and is extruded along y over this range.
  std::array<double, 2> extrude{0.0, 0.0};
};
struct Box {
  Vec3 minimum{};
  Vec3 maximum{};
};
struct Cylinder {  ///< disc in 2D, upright (z) cylinder in 3D
  Vec3 centre{};   ///< of the disc, or of the cylinder's base
  double radius = 0.0;
  double inner_radius = 0.0;  ///< greater than 0 makes a ring or tube
  double height = 0.0;        ///< 3D only
};
/// 3D: soil between `base` and a height over a plan rectangle, the height given by a profile table
/// over x, y or the horizontal distance from `centre`, or by an expression in x and y.
struct HeightField {
  std::array<double, 2> plan_minimum{};
  std::array<double, 2> plan_maximum{};
  double base = 0.0;
  enum class Kind { x_profile, y_profile, radial_profile, expression } kind = Kind::x_profile;
  std::array<double, 2> centre{};
  std::vector<std::array<double, 2>> profile{};  ///< (distance, height), linear in between
  std::string expression{};                      ///< of x and y, evaluated by muParser
};

struct Body {
  /// `engine/scene/shape_list.hpp` has one row for each.
  using Shape = std::variant<Polygon, Box, Cylinder, HeightField>;

  Shape shape{};
  std::string material{};  ///< its name; empty: the scene's only one
  Vec3 velocity{};         ///< initial velocity [m/s]
  /// Initial velocity by place instead: one muParser expression of x, y, z [m] for each direction
  /// [m/s]; empty: `velocity`.
  std::vector<std::string> velocity_field{};
  int line = 0;  ///< where it begins in `Scene::file`; 0: made in code
};

/// A flat piece of wall: `origin` + s `tangent_u` + t `tangent_v`, 0 <= s <= `length_u`, 0 <= t <=
/// `length_v`; soil lies on the side `normal` points to. 2D facets have `length_v` 0.
struct Facet {
  Vec3 origin{};
  Vec3 tangent_u{};
  Vec3 tangent_v{};
  double length_u = 0.0;
  double length_v = 0.0;
  Vec3 normal{};
};

/// A flat piece of one of the walls of a scene.
struct WallFace {
  Facet facet{};
  std::size_t wall = 0;  ///< index into `Scene::walls`
};

struct Wall {
  std::string name{};
  WallKind kind = WallKind::no_slip;
  std::vector<Facet> facets{};
  Vec3 velocity{};           ///< rigid translation [m/s]
  std::string moves_from{};  ///< stage at whose start it begins to move; empty: from the start
  std::string removed_at{};  ///< stage at whose start it is removed; empty: never
  int line = 0;              ///< where it begins in `Scene::file`; 0: made in code
};

struct Stage {
  std::string name{};
  StageEnd until = StageEnd::duration;
  std::optional<double> duration{};  ///< [s]; for `rest` the longest time allowed, empty: no limit
  double rest_velocity = 1e-3;       ///< fastest particle at rest [m/s]
  double strength_reduction = 1.0;   ///< factor SRF of Eq. 31 on every material [-]
  std::map<std::string, double> material_strength_reduction{};  ///< overrides by material name
  /// c_d of F = -c_d v [1/s]; empty: pi c_p/(2H) where a `rest` stage resets after, else 0.
  std::optional<double> damping{};
  bool reset_after = false;  ///< zero velocity, displacement, plastic strain when it ends
};

struct Probe {
  std::string name{};
  Vec3 at{};     ///< follows the particle nearest to this point at the start
  int line = 0;  ///< where it begins in `Scene::file`; 0: made in code
};

struct Output {
  /// [s] of simulated time; empty: first and last frame of a stage.
  std::optional<double> frame_interval{};
  std::optional<double> probe_interval{};  ///< [s]; empty: a hundredth of the stage
  bool frames = true;
  bool energy = false;  ///< sum dissipation (costs 5 to 20 %)
};

/// When `scarp run` keeps the state of a run in a file.
struct Checkpoints {
  double wall_interval = 600.0;  ///< [s] by the clock; 0: never
  double interval = 0.0;         ///< [s] of simulated time; 0: never
  bool stop_on_error = false;    ///< end the run if one cannot be written
};

struct Scene {
  std::string title{};
  std::string file{};  ///< where it was read from; empty if built in code
  std::string text{};  ///< ... and its words, before any override
  int dimension = 2;
  Vec3 gravity{0.0, -9.81, 0.0};
  double spacing = 0.0;  ///< particle spacing dx [m]
  Numerics numerics{};
  std::vector<Material> materials{};
  std::vector<Body> bodies{};
  std::vector<Wall> walls{};
  InitialStress initial_stress = InitialStress::zero;
  std::optional<double> initial_k0{};      ///< horizontal over vertical stress; empty: nu/(1-nu)
  std::array<double, 6> uniform_stress{};  ///< xx, yy, zz, xy, yz, zx for `uniform` [Pa]
  std::vector<Stage> stages{};
  std::vector<Probe> probes{};
  Output output{};
  Checkpoints checkpoints{};
  int retries = 0;  ///< how often `scarp run` may go back and halve the time step
};

/// How a message about a body, wall or probe begins: "slope.toml:19: key 'body[0]' = "; without
/// file and line if it was made in code.
std::string message_start(const Scene& scene, const Body& body);
std::string message_start(const Scene& scene, const Wall& wall);
std::string message_start(const Scene& scene, const Probe& probe);

/// Index into `materials` of what one of the scene's bodies is made of. Errors: SceneError for a
/// name that no material has.
std::size_t material_of(const Scene& scene, const Body& body);

/// Index into `materials` of the one with this name; of the only one for an empty name. Errors:
/// SceneError for a name that no material has, and for none where there are several.
std::size_t material_named(const Scene& scene, std::string_view name);

/// Whether a body is made of the material with this index.
bool is_used(const Scene& scene, std::size_t material);

/// "(1, 2)" in 2D, "(1, 2, 3)" in 3D.
std::string point_text(const Vec3& point, int dimension);

/// Horizontal over vertical stress of a material at rest: its own, else that of the scene, else
/// nu/(1 - nu). Geostatic stress, stress diffusion and mirror images take it.
double k0_of(const Scene& scene, const Material& material);
/// Whether any material's inertia is not its mass.
bool scales_mass(const Scene& scene);

/// History variables of the models of a scene, each name once: the fields that they add. Errors:
/// SceneError for more than a run can hold.
std::vector<kernels::StateField> history_of(const Scene& scene);

/// Whether soil may fall asleep: asked for, and with gravity, which the bounds are shares of.
bool soil_may_sleep(const Scene& scene);

/// What a stage divides the strength of a material by.
double reduction_of(const Stage& stage, const Material& material);

/// The rows of the named preset ("paper" or "modern"); throws SceneError for another name.
Numerics preset(const std::string& name);

/// Checks everything that can be checked without particles; throws SceneError. Called by
/// Simulation.
/// `needs_bodies`: the soil is not supplied as particles.
void validate(const Scene& scene, bool needs_bodies = true);

}  // namespace scarp
