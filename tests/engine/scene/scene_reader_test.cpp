// SPDX-License-Identifier: BSD-3-Clause
/// Scenes that read right: every section, shape, default and override.
#include "engine/scene/scene_reader.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "engine/check/warnings.hpp"
#include "engine/checkpoint/scene_text.hpp"
#include "engine/errors.hpp"
#include "tests/engine/scene/scene_texts.hpp"

namespace scarp {
namespace {

constexpr double degree = 3.14159265358979323846 / 180.0;

Scene read(const std::string& text, const SceneOverrides& overrides = {}) {
  return read_scene_text(text, "test.toml", overrides);
}

TEST(SceneReaderTest, ReadsTheSlope) {
  const Scene scene = read(slope_text);
  EXPECT_EQ(scene.title, "Cohesive slope");
  EXPECT_EQ(scene.file, "test.toml");
  EXPECT_EQ(scene.dimension, 2);
  EXPECT_EQ(scene.gravity, (Vec3{0.0, -9.81, 0.0}));
  EXPECT_EQ(scene.spacing, 0.25);
  EXPECT_EQ(scene.numerics.preset, "modern");

  ASSERT_EQ(scene.materials.size(), 1u);
  const auto p = scene.materials[0].model.as<DruckerPrager>();
  EXPECT_EQ(scene.materials[0].name, "clay");
  EXPECT_EQ(scene.materials[0].density, 2000.0);
  EXPECT_EQ(p.youngs_modulus, 100e6);
  EXPECT_EQ(p.poisson_ratio, 0.3);
  EXPECT_EQ(p.cohesion, 10e3);
  EXPECT_DOUBLE_EQ(p.friction_angle, 20.0 * degree);
  EXPECT_DOUBLE_EQ(p.dilation_angle, 9.0 * degree);
  EXPECT_EQ(p.cone, Cone::plane_strain);

  ASSERT_EQ(scene.bodies.size(), 1u);
  const auto& polygon = std::get<Polygon>(scene.bodies[0].shape);
  ASSERT_EQ(polygon.points.size(), 6u);
  EXPECT_EQ(polygon.points[4], (std::array<double, 2>{12.0, 15.0}));

  ASSERT_EQ(scene.walls.size(), 1u);
  ASSERT_EQ(scene.walls[0].facets.size(), 1u);
  EXPECT_EQ(scene.walls[0].facets[0].normal, (Vec3{0.0, 1.0, 0.0}));
  EXPECT_EQ(scene.walls[0].facets[0].length_u, 45.0);
  EXPECT_EQ(scene.initial_stress, InitialStress::geostatic);
  EXPECT_FALSE(scene.initial_k0);

  ASSERT_EQ(scene.stages.size(), 2u);
  EXPECT_EQ(scene.stages[0].until, StageEnd::rest);
  EXPECT_FALSE(scene.stages[0].duration);
  EXPECT_TRUE(scene.stages[0].reset_after);
  EXPECT_EQ(scene.stages[1].until, StageEnd::duration);
  EXPECT_EQ(scene.stages[1].duration, 10.0);
  EXPECT_EQ(scene.stages[1].strength_reduction, 1.4);
  EXPECT_FALSE(scene.stages[1].reset_after);
  ASSERT_EQ(scene.probes.size(), 1u);
  EXPECT_EQ(scene.probes[0].at, (Vec3{12.0, 15.0, 0.0}));
  EXPECT_EQ(scene.output.frame_interval, 0.1);
  EXPECT_EQ(scene.checkpoints.wall_interval, 600.0);
  EXPECT_EQ(scene.checkpoints.interval, 0.0);
  EXPECT_FALSE(scene.checkpoints.stop_on_error);
}

TEST(SceneReaderTest, ReadsEverySectionInThreeDimensions) {
  const Scene scene = read(everything_text);
  EXPECT_EQ(scene.gravity, (Vec3{0.0, 0.0, -9.81}));
  EXPECT_EQ(scene.materials[0].model.parameter("cone"), static_cast<double>(Cone::outer));
  EXPECT_EQ(scene.materials[0].model.parameter("dilation_angle"), 0.0);
  EXPECT_EQ(scene.materials[1].model.name(), "linear_elastic");
  EXPECT_EQ(scene.materials[1].model.parameters().size(), 2u);

  ASSERT_EQ(scene.bodies.size(), 6u);
  EXPECT_EQ(std::get<Polygon>(scene.bodies[0].shape).extrude, (std::array<double, 2>{0.0, 2.0}));
  EXPECT_EQ(std::get<Box>(scene.bodies[1].shape).maximum, (Vec3{0.2, 0.1, 0.3}));
  EXPECT_EQ(scene.bodies[1].velocity, (Vec3{0.0, 0.0, -3.0}));
  EXPECT_EQ(scene.bodies[1].material, scene.materials[1].name);
  EXPECT_EQ(std::get<Cylinder>(scene.bodies[2].shape).inner_radius, 0.5);
  EXPECT_EQ(std::get<Cylinder>(scene.bodies[2].shape).height, 2.0);
  EXPECT_EQ(std::get<HeightField>(scene.bodies[3].shape).kind, HeightField::Kind::x_profile);
  const auto& radial = std::get<HeightField>(scene.bodies[4].shape);
  EXPECT_EQ(radial.kind, HeightField::Kind::radial_profile);
  EXPECT_EQ(radial.centre, (std::array<double, 2>{40.0, 0.0}));
  EXPECT_EQ(radial.profile[1], (std::array<double, 2>{12.0, 16.0}));
  EXPECT_EQ(std::get<HeightField>(scene.bodies[5].shape).kind, HeightField::Kind::expression);

  ASSERT_EQ(scene.walls.size(), 3u);
  EXPECT_EQ(scene.walls[0].facets.size(), 5u);
  EXPECT_EQ(scene.walls[1].kind, WallKind::free_slip);
  EXPECT_EQ(scene.walls[1].facets[0].normal, (Vec3{0.0, -1.0, 0.0}));
  EXPECT_EQ(scene.walls[1].velocity, (Vec3{0.0, 0.0, 0.5}));
  EXPECT_EQ(scene.walls[1].moves_from, "run");
  EXPECT_EQ(scene.walls[2].removed_at, "run");
  EXPECT_EQ(scene.walls[2].facets[0].length_v, 10.0);

  EXPECT_EQ(scene.initial_k0, 0.5);
  EXPECT_EQ(scene.stages[0].duration, 2.0);
  EXPECT_EQ(scene.stages[0].rest_velocity, 0.002);
  EXPECT_EQ(scene.stages[0].damping, 12.5);
  EXPECT_FALSE(scene.stages[0].reset_after);
  EXPECT_EQ(scene.stages[1].material_strength_reduction.at("sand"), 1.3);
  EXPECT_FALSE(scene.stages[1].damping);
  EXPECT_EQ(scene.output.probe_interval, 0.005);
  EXPECT_FALSE(scene.output.frames);
  EXPECT_TRUE(scene.output.energy);
  EXPECT_EQ(scene.checkpoints.wall_interval, 120.0);
  EXPECT_EQ(scene.checkpoints.interval, 0.5);
  EXPECT_TRUE(scene.checkpoints.stop_on_error);
}

TEST(SceneReaderTest, K0IsTheMaterialsElseTheScenesElsePoissons) {
  const Scene own =
      read(replaced(everything_text, "density = \"1.8 t/m3\"", "density = \"1.8 t/m3\"\nk0 = 0.7"));
  EXPECT_EQ(k0_of(own, own.materials[0]), 0.7);
  EXPECT_EQ(k0_of(own, own.materials[1]), 0.5);
  const Scene none = read(slope_text);
  EXPECT_FALSE(none.materials[0].k0);
  EXPECT_DOUBLE_EQ(k0_of(none, none.materials[0]), 0.3 / 0.7);
}

TEST(SceneReaderTest, InertiaIsThatOfTheMassUnlessScaled) {
  EXPECT_EQ(read(slope_text).materials[0].mass_scaling, 1.0);
  EXPECT_FALSE(scales_mass(read(slope_text)));
  const Scene one = read(replaced(slope_text, "2000.0", "2000.0\nmass_scaling = 1"));
  EXPECT_FALSE(scales_mass(one));
  EXPECT_EQ(scene_text(one), scene_text(read(slope_text)));
  const Scene scaled = read(replaced(slope_text, "2000.0", "2000.0\nmass_scaling = 25"));
  EXPECT_TRUE(scales_mass(scaled));
  EXPECT_NE(scene_text(scaled), scene_text(one));
  EXPECT_DOUBLE_EQ(5.0 * scaled.materials[0].sound_speed(), one.materials[0].sound_speed());
}

TEST(SceneReaderTest, EveryRowOfThePresetsCanBeOverridden) {
  const Numerics n = read(everything_text).numerics;
  EXPECT_EQ(n.preset, "paper");
  EXPECT_EQ(n.smoothing, SmoothingFunction::cubic_spline);
  EXPECT_EQ(n.smoothing_ratio, 1.25);
  EXPECT_TRUE(n.lattice_normalisation);
  EXPECT_TRUE(n.gradient_correction);
  EXPECT_EQ(n.stress_rotation, StressRotation::hughes_winget);
  EXPECT_EQ(n.viscosity_alpha, 0.5);
  EXPECT_EQ(n.viscosity_beta, 2.0);
  EXPECT_EQ(n.artificial_stress, 0.5);
  EXPECT_FALSE(n.artificial_stress_exponent);
  EXPECT_EQ(n.stress_diffusion, 0.05);
  EXPECT_EQ(n.diffusion_shear_gate, 10.0);
  EXPECT_EQ(n.integrator, Integrator::kick_drift_kick);
  EXPECT_EQ(n.verlet_restart_interval, 20);
  EXPECT_EQ(n.cfl, 1.0);
  EXPECT_EQ(n.skin, 0.2);
  EXPECT_EQ(n.density_minimum, 0.6);
  EXPECT_EQ(n.density_maximum, 1.1);
}

TEST(SceneReaderTest, AutoIsTheSmoothingOfTheDimension) {
  for (const int dimension : {2, 3}) {
    Scene scene = read(dimension == 2 ? slope_text : everything_text);
    ASSERT_EQ(scene.dimension, dimension);
    Scene same = scene;
    scene.numerics.smoothing = SmoothingFunction::by_dimension;
    scene.numerics.smoothing_ratio.reset();
    same.numerics.smoothing =
        dimension == 2 ? SmoothingFunction::cubic_spline : SmoothingFunction::yang_liu;
    same.numerics.smoothing_ratio = dimension == 2 ? 1.2 : 1.3;
    EXPECT_EQ(scene_text(scene), scene_text(same)) << dimension;  // what a checkpoint goes by
  }
  std::string text =
      replaced(everything_text, "smoothing = \"cubic_spline\"", "smoothing = \"auto\"");
  text = replaced(text, "smoothing_ratio = 1.25", "smoothing_ratio = \"auto\"");
  const Numerics read_back = read(text).numerics;
  EXPECT_EQ(read_back.smoothing, SmoothingFunction::by_dimension);
  EXPECT_FALSE(read_back.smoothing_ratio);
  Scene scene = read(slope_text);
  scene.numerics.smoothing_ratio = 0.0;  // in code no word stands for it
  EXPECT_THROW(validate(scene), SceneError);
}

TEST(SceneReaderTest, PaperPresetIsThePapersAndModernTheDefaults) {
  const Numerics paper = preset("paper"), modern = preset("modern");
  EXPECT_EQ(paper.smoothing, SmoothingFunction::yang_liu);
  EXPECT_EQ(paper.smoothing_ratio, 1.2);
  EXPECT_FALSE(paper.lattice_normalisation);
  EXPECT_FALSE(paper.gradient_correction);
  EXPECT_EQ(paper.stress_rotation, StressRotation::jaumann);
  EXPECT_EQ(paper.artificial_stress, 0.3);
  EXPECT_EQ(paper.artificial_stress_exponent, 2.55);
  EXPECT_EQ(paper.stress_diffusion, 0.0);
  EXPECT_EQ(paper.integrator, Integrator::verlet);
  EXPECT_EQ(paper.verlet_restart_interval, 40);
  EXPECT_EQ(paper.cfl, 0.2);
  EXPECT_EQ(modern.cfl, Numerics{}.cfl);
  EXPECT_EQ(modern.preset, "modern");
  EXPECT_THROW(preset("papers"), SceneError);
}

TEST(SceneReaderTest, OverridesReplacePresetAndSpacingButKeepTheRows) {
  const Scene scene = read(everything_text, {.preset = "modern", .spacing = 0.5});
  EXPECT_EQ(scene.numerics.preset, "modern");
  EXPECT_EQ(scene.numerics.cfl, 1.0);  // the row of [numerics]
  EXPECT_EQ(scene.spacing, 0.5);
}

TEST(SceneReaderTest, NormalsOfABoxPointInwards) {
  for (const int dimension : {2, 3}) {
    const bool flat = dimension == 2;
    const std::string text = replaced(flat ? slope_text : everything_text,
                                      flat ? "line = [[0, 0], [45, 0]]" : ", open = [\"+z\"]",
                                      flat ? "box = {min = [0, 0], max = [4, 6]}" : "");
    const Wall wall = read(text).walls[0];
    ASSERT_EQ(wall.facets.size(), flat ? 4u : 6u);
    const Vec3 centre = flat ? Vec3{2.0, 3.0, 0.0} : Vec3{20.0, 20.0, 10.0};
    for (const Facet& f : wall.facets) {
      double height = 0.0, middle_u = 0.0, middle_v = 0.0;
      for (std::size_t d = 0; d < 3; ++d) {
        height += f.normal[d] * (centre[d] - f.origin[d]);
        middle_u += f.tangent_u[d] * (centre[d] - f.origin[d]);
        middle_v += f.tangent_v[d] * (centre[d] - f.origin[d]);
      }
      EXPECT_GT(height, 0.0);  // the centre is on the soil's side, over the middle of the face
      EXPECT_EQ(middle_u, 0.5 * f.length_u);
      EXPECT_EQ(middle_v, 0.5 * f.length_v);
    }
  }
}

TEST(SceneReaderTest, SoilIsOnTheLeftOfALine) {
  const std::string text =
      replaced(slope_text, "line = [[0, 0], [45, 0]]", "line = [[0, 5], [0, 0], [45, 0], [45, 5]]");
  const Wall wall = read(text).walls[0];
  ASSERT_EQ(wall.facets.size(), 3u);
  EXPECT_EQ(wall.facets[0].normal, (Vec3{1.0, 0.0, 0.0}));
  EXPECT_EQ(wall.facets[1].normal, (Vec3{0.0, 1.0, 0.0}));
  EXPECT_EQ(wall.facets[2].normal, (Vec3{-1.0, 0.0, 0.0}));
}

TEST(SceneReaderTest, PlanePatchIsCentredAtItsPoint) {
  for (const char* normal : {"[0, 2]", "[3, 4]", "[-1, 0]"}) {
    const std::string text =
        replaced(slope_text, "line = [[0, 0], [45, 0]]",
                 std::string("plane = {point = [1, 2], size = \"10 m\", normal = ") + normal + "}");
    const Facet f = read(text).walls[0].facets[0];
    // A few roundings of lengths near 10.
    EXPECT_NEAR(f.origin[0] + 5.0 * f.tangent_u[0], 1.0, 1e-14) << normal;
    EXPECT_NEAR(f.origin[1] + 5.0 * f.tangent_u[1], 2.0, 1e-14) << normal;
    EXPECT_EQ(f.length_v, 0.0);
  }
  const Facet patch = read(everything_text).walls[2].facets[0];
  EXPECT_NEAR(patch.origin[1] + 5.0 * (patch.tangent_u[1] + patch.tangent_v[1]), 2.0, 1e-14);
  EXPECT_NEAR(patch.normal[0], 0.6, 1e-15);
}

TEST(SceneReaderTest, TextMayHoldAnyLetterAndCommentsToo) {
  const std::string text = replaced(slope_text, "title = \"Cohesive slope\"",
                                    "title = \"\"\"B\xC3\xB6schung \"1\\\"\"\"\" # \xC3\xA4 'x");
  EXPECT_EQ(read(text).title, "B\xC3\xB6schung \"1\"");
}

TEST(SceneReaderTest, MadeInCodeNamesTheKeyWithoutALine) {
  Scene scene = read(slope_text);
  EXPECT_NO_THROW(validate(scene));
  scene.materials[0].model.set("dilation_angle", 1.0);
  try {
    validate(scene);
    ADD_FAILURE() << "dilation above friction was accepted";
  } catch (const SceneError& error) {
    EXPECT_EQ(std::string(error.what()).find("key 'material[0].dilation_angle' = 1: "), 0u)
        << error.what();
  }
  Scene tilted = read(slope_text);
  tilted.walls[0].facets[0].normal = {0.1, 1.0, 0.0};
  EXPECT_THROW(validate(tilted), SceneError);
  Scene lifted = read(slope_text);
  lifted.probes[0].at[2] = 1.0;
  EXPECT_THROW(validate(lifted), SceneError);
}

TEST(SceneReaderTest, ExamplesOfTheReferenceAreGoodScenes) {
  const auto page = std::filesystem::path(SCARP_SOURCE_DIR) / "engine/scene/SCENE.md";
  std::ifstream file(page);
  ASSERT_TRUE(file) << page;
  std::string line, scene;
  int examples = 0;
  bool inside = false;
  while (std::getline(file, line)) {
    if (line == "```" && inside) {
      EXPECT_NO_THROW(EXPECT_TRUE(warnings(read(scene)).empty())) << scene;
      ++examples;
      inside = false;
    }
    if (inside) scene += line + "\n";
    if (line == "```toml") {
      inside = true;
      scene.clear();
    }
  }
  EXPECT_EQ(examples, 3);
}

TEST(SceneReaderTest, EveryFileOfTheFuzzingCorpusIsAGoodScene) {
  int scenes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(
           std::filesystem::path(SCARP_SOURCE_DIR) / "tests/fuzz/corpus")) {
    EXPECT_NO_THROW(read_scene(entry.path())) << entry.path();
    ++scenes;
  }
  EXPECT_GE(scenes, 20);  // fewer leave whole sections to chance
}

TEST(SceneReaderTest, FilesAreNamedAndMissingOnesReported) {
  const auto path = std::filesystem::path(testing::TempDir()) / "scarp_scene_reader_test.toml";
  std::ofstream(path) << slope_text;
  EXPECT_EQ(read_scene(path).file, path.string());
  std::filesystem::remove(path);
  EXPECT_THROW(read_scene(path), FileError);
  EXPECT_THROW(read_scene(path.parent_path()), FileError);
}

TEST(SceneWarningsTest, SaySoilInTheWrongUnitAndConesThatNeverYield) {
  EXPECT_TRUE(warnings(read(slope_text)).empty());
  // gamma H / (2 M) = 19620 x 15 / (2 x 1.346 x 1e5) = 1.09
  const auto soft = warnings(read(replaced(slope_text, "\"100 MPa\"", "\"100 kPa\"")));
  ASSERT_EQ(soft.size(), 1u);
  EXPECT_NE(soft[0].find("109 % of its height"), std::string::npos) << soft[0];

  const auto cone = [](const char* phi) {
    return warnings(
        read(replaced(replaced(slope_text, "\"plane_strain\"", "\"outer\""), "\"20 deg\"", phi)));
  };
  EXPECT_TRUE(cone("\"42.1 deg\"").empty());
  ASSERT_EQ(cone("\"42.3 deg\"").size(), 1u);
  EXPECT_NE(cone("\"42.3 deg\"")[0].find("never yields"), std::string::npos);
}

}  // namespace
}  // namespace scarp
