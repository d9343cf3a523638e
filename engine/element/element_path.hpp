// SPDX-License-Identifier: BSD-3-Clause
/// Element tests: one material point driven along the path of a laboratory test.
#pragma once

#include <array>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/scene/scene.hpp"
#include "engine/simulation.hpp"

namespace scarp {

/// The tests; all begin under an isotropic pressure. Axial is y, lateral x.
enum class ElementPath {
  triaxial,      ///< strain along y, stress held along x and z
  plane_strain,  ///< strain along y, stress held along x, no strain along z
  simple_shear,  ///< v_x = gamma' y, stress held along y, no strain along x and z
  isotropic      ///< equal strain along x, y, z
};

/// Their names, in the order of the enumerators.
inline constexpr std::array<std::string_view, 4> element_path_names{"triaxial", "plane_strain",
                                                                    "simple_shear", "isotropic"};

struct ElementTest {
  ElementPath path = ElementPath::triaxial;
  std::string material{};             ///< its name; empty: the scene's only one
  double confining_pressure = 100e3;  ///< at the start, and of the stress held [Pa]
  /// At the end: axial (triaxial, plane_strain) or volumetric (isotropic), positive in
  /// compression; simple_shear: the engineering shear strain gamma. Logarithmic [-].
  double strain = 0.05;
  int steps = 1000;  ///< equal increments of strain
};

/// The point after one increment; tensors xx, yy, zz, xy, yz, zx, tension positive.
struct ElementSample {
  std::array<double, 6> strain{};  ///< tensor components [-]
  std::array<double, 6> stress{};  ///< [Pa]
  double first_invariant = 0.0;    ///< I1 [Pa]
  double root_j2 = 0.0;            ///< sqrt(J2) [Pa]
  double yield_function = 0.0;     ///< of the model [Pa]; NaN if it has none
  std::array<double, kernels::most_state_fields> history{};  ///< variables of the model
  double volumetric_strain = 0.0;
  double plastic_volumetric_strain = 0.0;
};

/// Largest less least principal stress [Pa].
double deviator(const ElementSample& sample);

struct ElementResult {
  std::vector<ElementSample> samples;  ///< the start, then one for each step
  int dimension = 3;                   ///< of the stress pass
  std::string isa;
  bool plastic = true;
  std::span<const kernels::StateField> history;    ///< what `ElementSample::history` holds
  std::map<std::string, double> constants;         ///< that the model shows, by name
  double bulk_modulus = 0.0, shear_modulus = 0.0;  ///< [Pa]
  std::size_t first_yield =
      0;  ///< first sample whose history differs from the start; 0: there is none
  double control_error = 0.0;  ///< largest departure of a held stress [Pa]
};

/// Drives the material with the scene's numerics: `MaterialPoint`, in 2D where scene and path are
/// plane. Held stresses are met by Newton's method on the strain increments of their directions,
/// to 1e-9 of the stresses at hand. Errors: SceneError; Error for a test that makes no sense and
/// where no increment holds the stress.
ElementResult run_element(const Scene& scene, const ElementTest& test,
                          const RunOptions& options = {});

}  // namespace scarp
