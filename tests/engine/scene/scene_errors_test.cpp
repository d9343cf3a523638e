// SPDX-License-Identifier: BSD-3-Clause
/// Scenes that must be refused: each names its line and what is wrong, whatever the bytes.
#include <gtest/gtest.h>

#include <random>

#include "engine/errors.hpp"
#include "engine/scene/scene_reader.hpp"
#include "tests/engine/scene/scene_texts.hpp"

namespace scarp {
namespace {

struct Bad {
  bool three_d;      // which good scene is spoilt
  const char* from;  // first occurrence ...
  const char* to;    // ... becomes this
  int line;
  const char* words;
};

constexpr bool in_2d = false, in_3d = true;

const Bad table[] = {
    // syntax
    {in_2d, "dimension = 2", "dimension = ", 2, "not TOML"},
    {in_2d, "dimension = 2", "dimension = 2\ndimension = 2", 3, "not TOML"},
    {in_2d, "[[material]]", "[[material", 7, "not TOML"},
    {in_2d, "\"clay\"", "\"clay", 8, "not TOML"},
    {in_2d, "dimension", "dimensi\xC3\xB6n", 2, "outside ASCII"},
    // unknown keys
    {in_2d, "spacing =", "spaceing =", 4,
     "key 'spaceing' = '0.25 m': unknown key. Did you mean 'spacing'?"},
    {in_2d, "title", "qqqqqq", 1, "unknown key. Try one of title, dimension"},
    {in_2d, "cohesion", "cohesoin", 13,
     "key 'material[0].cohesoin' = '10 kPa': unknown key. Did you mean 'cohesion'?"},
    {in_2d, "kind =", "kinds =", 24, "Did you mean 'kind'?"},
    {in_2d, "stress =", "stres =", 28, "Did you mean 'stress'?"},
    {in_2d, "strength_reduction", "strength_reducton", 36, "Did you mean 'strength_reduction'?"},
    {in_2d, "every", "evry", 44, "Did you mean 'every'?"},
    {in_3d, "cfl = 1", "clf = 1", 20, "key 'numerics.clf' = 1: unknown key. Did you mean 'cfl'?"},
    {in_3d, "from = \"run\"", "form = \"run\"", 76, "key 'wall[1].motion.form'"},
    // missing keys
    {in_2d, "dimension = 2", "", 1, "key 'dimension' is missing. Try dimension = 2"},
    {in_2d, "spacing = \"0.25 m\"", "", 1, "key 'spacing' is missing"},
    {in_2d, "density = 2000.0", "", 7, "key 'material[0].density' is missing"},
    {in_2d, "youngs_modulus = \"100 MPa\"", "", 7, "key 'material[0].youngs_modulus' is missing"},
    {in_2d, "polygon = [[0, 0], [45, 0], [45, 5], [32, 5], [12, 15], [0, 15]]", "", 18,
     "'body[0]' has no shape. Try one of polygon, box"},
    {in_2d, "kind = \"no_slip\"", "", 22, "key 'wall[0].kind' is missing"},
    {in_2d, "until = \"rest\"", "", 30, "key 'stage[0].duration' is missing"},
    {in_2d, "at = [12, 15]", "", 39, "key 'probe[0].at' is missing"},
    {in_3d, "extrude = [0, 2]", "", 41, "key 'body[0].extrude' is missing"},
    {in_3d, "along = \"x\", ", "", 57, "key 'body[3].height_field.along' is missing"},
    // wrong types
    {in_2d, "dimension = 2", "dimension = \"2\"", 2, "this is text, but an integer is needed"},
    {in_2d, "dimension = 2", "dimension = 4", 2, "Try 2 or 3"},
    {in_2d, "dimension = 2", "dimension = 9223372036854775807", 2, "too large"},
    {in_2d, "\"Cohesive slope\"", "1979-05-27", 1, "a date or time, but text is needed"},
    {in_2d, "[0.0, -9.81]", "[0.0, -9.81, 0.0]", 3, "has 3 item(s), but 2 are needed"},
    {in_2d, "[0.0, -9.81]", "-9.81", 3, "a number, but an array of 2 numbers is needed"},
    {in_2d, "[0.0, -9.81]", "[]", 3, "has 0 item(s)"},
    {in_2d, "[[material]]", "[material]", 7, "Try [[material]] with double brackets"},
    {in_2d, "[[0, 0], [45, 0], [45, 5], [32, 5], [12, 15], [0, 15]]",
     "[[0, 0], [45, [0]], [45, 5]]", 20,
     "key 'body[0].polygon[1][1]' = [ 0 ]: this is an array, but a length is needed"},
    {in_2d, "[[0, 0], [45, 0], [45, 5], [32, 5], [12, 15], [0, 15]]", "[[0, 0], [45, 0]]", 20,
     "2 point(s) are too few. Try at least 3"},
    {in_2d, "[[0, 0], [45, 0], [45, 5], [32, 5], [12, 15], [0, 15]]", "[]", 20,
     "the array is empty"},
    {in_2d, "\"clay\"", "\"\"", 8, "the text is empty"},
    {in_3d, "cfl = 1", "cfl = true", 20, "this is true or false, but a plain number is needed"},
    {in_3d, "lattice_normalisation = true", "lattice_normalisation = 1", 8,
     "an integer, but true or false is needed"},
    {in_3d, "{min = [0, 0, 0], max = [\"20 cm\", 0.1, 0.3]}", "3", 48,
     "this is an integer, but a table is needed"},
    // values and units
    {in_2d, "\"0.25 m\"", "0", 4, "not positive"},
    {in_2d, "\"0.25 m\"", "-0.25", 4, "not positive"},
    {in_2d, "\"0.25 m\"", "nan", 4, "not a finite number"},
    {in_2d, "\"0.25 m\"", "\"0.25 s\"", 4,
     "'s' is the unit of a time, but a length is needed. Try one of m, mm"},
    {in_2d, "\"100 MPa\"", "\"100 MPA\"", 11,
     "unknown unit 'MPA' for a pressure. Try one of Pa, kPa, MPa, GPa"},
    {in_2d, "\"20 deg\"", "20", 14, "an angle needs its unit. Try \"20 deg\""},
    {in_2d, "\"20 deg\"", "\"85 deg\"", 14, "outside 0 to 80 deg"},
    {in_2d, "\"9 deg\"", "\"25 deg\"", 15, "dilation above the friction angle"},
    {in_2d, "poisson_ratio = 0.3", "poisson_ratio = 0.5", 12, "outside 0 to 0.4999"},
    {in_2d, "2000.0", "-1", 10, "key 'material[0].density' = -1: it is outside"},
    {in_2d, "2000.0", "inf", 10, "not a finite number"},
    {in_2d, "\"plane_strain\"", "\"plane_stran\"", 16, "Did you mean 'plane_strain'?"},
    {in_2d, "\"modern\"", "\"papper\"", 5, "Did you mean 'paper'?"},
    {in_2d, "\"drucker_prager\"", "\"druker_prager\"", 9,
     "there is no such model. Did you mean 'drucker_prager'?"},
    {in_2d, "\"no_slip\"", "\"noslip\"", 24, "Did you mean 'no_slip'?"},
    {in_2d, "\"rest\"", "\"never\"", 32, "it is none of rest"},
    {in_2d, "\"10 s\"", "0", 37, "the stage would take no time"},
    {in_2d, "\"10 s\"", "-1", 37, "outside 0 to"},
    {in_2d, "strength_reduction = 1.4", "strength_reduction = 0", 36, "outside 0.001 to 1000"},
    {in_2d, "strength_reduction = 1.4", "strength_reduction = {cly = 1.4}", 36,
     "no material has this name. Did you mean 'clay'?"},
    {in_2d, "strength_reduction = 1.4", "damping = -2", 36, "it is negative"},
    {in_2d, "strength_reduction = 1.4", "rest_velocity = 1", 36, "needs until = \"rest\""},
    {in_3d, "cfl = 1", "cfl = 2.5", 20, "key 'numerics.cfl' = 2.5: it is outside 1e-06 to 2"},
    {in_3d, "smoothing_ratio = 1.25", "smoothing_ratio = 0.5", 7, "outside 0.8 to 3"},
    {in_3d, "verlet_restart_interval = 20", "verlet_restart_interval = 0", 19, "outside 1 to"},
    {in_3d, "plasticity = \"rate\"", "plasticity = \"return\"", 21, "would clamp the step"},
    {in_3d, "artificial_stress_exponent = \"auto\"", "artificial_stress_exponent = \"automatic\"",
     15, "it is none of auto"},
    {in_3d, "k0 = 0.5", "k0 = -0.5", 86, "it is negative"},
    {in_3d, "stress = \"geostatic\"", "stress = \"zero\"", 86, "needs stress = \"geostatic\""},
    {in_2d, "stress = \"geostatic\"", "stress = \"uniform\"", 27,
     "key 'initial.uniform' is missing"},
    {in_2d, "stress = \"geostatic\"", "stress = \"geostatic\"\nuniform = [1, 2, 3, 4]", 29,
     "needs stress = \"uniform\""},
    {in_2d, "stress = \"geostatic\"", "stress = \"uniform\"\nuniform = [1, 2, 3]", 29,
     "has 3 item(s), but 4 are needed"},
    // velocity by place
    {in_3d, "velocity = [0, 0, \"-3 m/s\"]", "velocity_field = [\"x\", \"y\"]", 49,
     "each direction needs one"},
    {in_3d, "velocity = [0, 0, \"-3 m/s\"]", "velocity_field = [\"x\", \"w\", \"0\"]", 49,
     "key 'body[1].velocity_field[1]' = 'w': at letter 1"},
    {in_3d, "velocity = [0, 0, \"-3 m/s\"]",
     "velocity = [0, 0, 1]\nvelocity_field = [\"x\", \"0\", \"0\"]", 50, "also has a velocity"},
    {in_2d, "[0.0, -9.81]", "[1.0, -9.81]", 28, "gravity does not point along one axis"},
    // references and names
    {in_2d, "material = \"clay\"", "material = \"cley\"", 19,
     "no [[material]] has this name. Did you mean 'clay'?"},
    {in_2d, "\"fail\"", "\"settle\"", 35, "another stage has the same name"},
    {in_2d, "\"crest\"", "\"a/b\"", 40, "it holds one of /"},
    {in_3d, "from = \"run\"", "from = \"rum\"", 76, "no stage has this name. Did you mean 'run'?"},
    {in_3d, "until = \"run\"", "until = \"end\"", 82,
     "no stage has this name. Try one of settle, run."},
    // shapes
    {in_2d, "[[0, 0], [45, 0], [45, 5], [32, 5], [12, 15], [0, 15]]", "[[0, 0], [1, 1], [2, 2]]",
     20, "encloses no area"},
    {in_2d, "material = \"clay\"", "material = \"clay\"\nbox = {min = [0, 0], max = [1, 1]}", 20,
     "'polygon' is given as well"},
    {in_2d, "material = \"clay\"", "material = \"clay\"\nextrude = [0, 1]", 20,
     "belongs to a polygon with dimension = 3"},
    {in_2d, "line = [[0, 0], [45, 0]]", "line = [[0, 0], [0, 0]]", 25, "a segment has no length"},
    {in_2d, "line = [[0, 0], [45, 0]]", "line = [[0, 0]]", 25, "too few"},
    {in_2d, "line = [[0, 0], [45, 0]]", "box = {min = [0, 0], max = [1, 1], open = [\"+z\"]}", 25,
     "there is no face '+z'. Try -x, +x, -y, +y"},
    {in_2d, "line = [[0, 0], [45, 0]]", "box = {min = [0, 0], max = [1, 0]}", 25,
     "max is not above min"},
    {in_2d, "line = [[0, 0], [45, 0]]", "rectangle = {}", 25, "needs dimension = 3"},
    {in_3d, "v = [0, 0, 2]", "v = [1, 0, 2]", 75, "not at right angles"},
    {in_3d, "normal = [3, 0, 4]", "normal = [0, 0, 0]", 81, "the normal has no length"},
    {in_3d, "max = [\"20 cm\", 0.1, 0.3]", "max = [\"20 cm\", 0.1, 0]", 48, "not above min"},
    {in_3d, "inner_radius = \"50 cm\"", "inner_radius = 1", 53, "nothing is left of the ring"},
    {in_3d, "[24, 4], [40, 4]", "[11, 4], [40, 4]", 57, "the distance is below the one before"},
    {in_3d, "28 - max(x, y)", "28 - max(x, q)", 65, "Try an expression of x and y"},
    {in_3d, "min(16, max(4, 28 - max(x, y)))", "1 / x", 65, "is not finite"},
    {in_3d, "[[0, 0], [40, 40]]", "[[0, 0], [40, 0]]", 65, "the second is not above the first"},
    {in_3d, "wall_every = \"2 min\"", "wall_every = \"2 m\"", 113, "checkpoint.wall_every"},
    {in_3d, "wall_every", "wal_every", 113, "Did you mean 'wall_every'?"},
    {in_3d, "every = 0.5", "every = -1", 114, "checkpoint.every"},
    {in_3d, "on_error = \"stop\"", "on_error = \"halt\"", 115, "Try one of continue, stop"},
};

TEST(SceneErrorsTest, EachBadSceneNamesItsLineAndReason) {
  for (const Bad& bad : table) {
    const std::string text = replaced(bad.three_d ? everything_text : slope_text, bad.from, bad.to);
    try {
      read_scene_text(text, "bad.toml");
      ADD_FAILURE() << "accepted: " << bad.to;
    } catch (const SceneError& error) {
      const std::string what = error.what(), at = "bad.toml:" + std::to_string(bad.line) + ": ";
      EXPECT_EQ(what.find(at), 0u) << "wanted line " << bad.line << ": " << what;
      EXPECT_NE(what.find(bad.words), std::string::npos) << "wanted " << bad.words << ": " << what;
      EXPECT_NE(what.find("Try ") == std::string::npos,
                what.find("Did you mean") == std::string::npos)
          << "no single advice: " << what;
    }
  }
}

TEST(SceneErrorsTest, EmptySectionsAreNamed) {
  for (const char* section : {"material", "body", "stage"}) {
    std::string text = "dimension = 2\nspacing = 1\n";
    if (section != std::string("material")) {
      text +=
          "[[material]]\nname = \"a\"\nmodel = \"linear_elastic\"\ndensity = 1\n"
          "youngs_modulus = 1\npoisson_ratio = 0\n";
    }
    if (section == std::string("stage")) {
      text += "[[body]]\nmaterial = \"a\"\nbox = {min = [0, 0], max = [1, 1]}\n";
    }
    try {
      read_scene_text(text, "bad.toml");
      ADD_FAILURE() << "accepted without " << section;
    } catch (const SceneError& error) {
      EXPECT_NE(std::string(error.what()).find(std::string("bad.toml:1: key '") + section + "'"),
                std::string::npos)
          << error.what();
    }
  }
}

/// Reads bytes that may or may not be a scene; anything but success or SceneError fails the test.
void survive(const std::string& text) {
  try {
    read_scene_text(text, "bytes");
  } catch (const SceneError& error) {
    const std::string what = error.what();
    EXPECT_EQ(what.find("bytes:"), 0u) << what;
    EXPECT_LT(what.size(), 2000u);  // a message is for reading
    for (const char letter : what) EXPECT_GE(static_cast<unsigned char>(letter), 0x20u) << what;
  }
}

TEST(SceneErrorsTest, GarbageEndsInSceneError) {
  const std::string zero(1, '\0');
  const std::string garbage[] = {
      "[[\n",
      "[[=",
      "[[[",
      "[",
      "]",
      "=",
      "\"",
      "'''",
      "\"\"\"",
      "\"\\",
      "\xEF\xBB\xBF",
      "\xEF\xBB",
      "dp\xC6\xAC = 1",
      "\xC6\xAC",
      "\xFF\xFE",
      zero,
      "a = \"" + zero + "\"",
      "a.b.c.d = {}",
      "a = \"\xFF\"",
      "# \xFF",
      "dimension = 2\r",
      std::string(400, '['),
      "a = " + std::string(400, '['),
      "a = " + std::string(100000, '['),
      "material = [[]]",
      "material = [1]",
      "material = [{}]",
      "[material]\n[[material]]",
      "stage.stage = 1",
      "[[body]]\n[[body.box]]",
      "dimension = 2\nspacing = 1\nnumerics = []",
      "dimension = 2\nspacing = 1\nwall = {}",
      "dimension = 2\nspacing = 1\nstage = [{name = 'a', strength_reduction = {a = {}}}]",
      "dimension = 2\nspacing = 1\n[[material]]\nmodel = 3",
      std::string(100000, 'a') + " = 1",
      "\"a\\u0000\\n\" = 1",
      "dimension = 1e400",
      "spacing = 0x",
      "dimension = 2\nspacing = 2024-13-45"};
  for (const std::string& text : garbage) {
    EXPECT_THROW(read_scene_text(text, "bytes"), SceneError) << text.substr(0, 40);
    survive(text);
  }
}

TEST(SceneErrorsTest, ScenesCutOrSpoiltAnywhereNeverCrash) {
  for (const std::string* text : {&slope_text, &everything_text}) {
    for (std::size_t length = 0; length < text->size(); ++length) survive(text->substr(0, length));
    std::mt19937 random(1);
    const std::string likely = "[]{}=\"'.,#\n\\ 0-ex\xC3\xFF";
    for (int i = 0; i < 4000; ++i) {
      std::string spoilt = *text;
      for (int k = 0; k < 1 + i % 3; ++k) {
        spoilt[random() % spoilt.size()] = likely[random() % likely.size()];
      }
      survive(spoilt);
    }
  }
}

}  // namespace
}  // namespace scarp
