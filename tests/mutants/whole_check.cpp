// SPDX-License-Identifier: BSD-3-Clause
/// The reader first, for the size of the scene; then the command itself with its output caught.
#include "tests/mutants/whole_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>

#include "engine/cli/commands.hpp"
#include "engine/errors.hpp"
#include "engine/scene/scene_reader.hpp"
#include "engine/scene/smoothing_choice.hpp"
#include "tests/support/scene_message.hpp"

namespace scarp {
namespace {

using Json = nlohmann::json;

/// Standard output into a text while it lives.
class Caught {
 public:
  Caught() : before_(stdout) { stdout = open_memstream(&text_, &size_); }
  Caught(const Caught&) = delete;
  Caught& operator=(const Caught&) = delete;
  ~Caught() {
    std::fclose(stdout);
    stdout = before_;
    std::free(text_);
  }
  std::string text() {
    std::fflush(stdout);
    return {text_, size_};
  }

 private:
  FILE* before_;
  char* text_ = nullptr;
  std::size_t size_ = 0;
};

struct Box3 {
  Vec3 low{}, high{};
};

Box3 box_of(const Polygon& polygon, int dimension) {
  Box3 box{{1e300, 1e300, 1e300}, {-1e300, -1e300, -1e300}};
  const std::size_t up = dimension == 2 ? 1 : 2;
  for (const auto& p : polygon.points) {
    box.low = {std::fmin(box.low[0], p[0]), box.low[1], box.low[2]};
    box.high = {std::fmax(box.high[0], p[0]), box.high[1], box.high[2]};
    box.low[up] = std::fmin(box.low[up], p[1]);
    box.high[up] = std::fmax(box.high[up], p[1]);
  }
  const std::size_t other = 3 - up;
  box.low[other] = polygon.extrude[0];
  box.high[other] = polygon.extrude[1];
  return box;
}
Box3 box_of(const Box& box, int) { return {box.minimum, box.maximum}; }
Box3 box_of(const Cylinder& c, int dimension) {
  Box3 box{{c.centre[0] - c.radius, c.centre[1] - c.radius, c.centre[2]},
           {c.centre[0] + c.radius, c.centre[1] + c.radius, c.centre[2] + c.height}};
  if (dimension == 2) box.low[2] = box.high[2] = 0.0;
  return box;
}
Box3 box_of(const HeightField& field, int) {
  double high = field.base + 50.0;  // an expression's height is not known here
  for (const auto& p : field.profile) high = std::fmax(high, p[1]);
  return {{field.plan_minimum[0], field.plan_minimum[1], field.base},
          {field.plan_maximum[0], field.plan_maximum[1], high}};
}

/// Sites of soil and walls at most, with a layer more on each side.
double most_sites(const Scene& scene, double spacing) {
  const auto sites = [spacing](double length) { return std::fmax(length, 0.0) / spacing + 2.0; };
  double total = 0.0;
  for (const Body& body : scene.bodies) {
    const Box3 box =
        std::visit([&](const auto& shape) { return box_of(shape, scene.dimension); }, body.shape);
    double count = 1.0;
    for (std::size_t a = 0; a < static_cast<std::size_t>(scene.dimension); ++a)
      count *= sites(box.high[a] - box.low[a]);
    total += count;
  }
  const double layers = 2.0 * smoothing_ratio_of(scene) + 2.0;
  for (const Wall& wall : scene.walls) {
    for (const Facet& facet : wall.facets) {
      const double across = scene.dimension == 3 ? sites(facet.length_v) + 2.0 * layers : 1.0;
      total += layers * (sites(facet.length_u) + 2.0 * layers) * across;
    }
  }
  return total;
}

/// The spacing at which a scene has about `most` particles; its own if that is larger, or so small
/// that the scene must be refused.
double bearable_spacing(const Scene& scene, double most) {
  constexpr double hopeless = 1e13;  // no machine has memory for as many
  const double own = most_sites(scene, scene.spacing);
  if (own <= most || own > hopeless) return scene.spacing;
  double spacing = scene.spacing;
  while (most_sites(scene, spacing) > most && spacing < 1e6 * scene.spacing) spacing *= 1.3;
  return spacing;
}

/// Numbers that are none in what people read, as words of their own.
std::string odd_word(const std::string& text) {
  static constexpr std::array<std::string_view, 6> odd{"nan", "-nan", "inf", "-inf", "NaN", "Inf"};
  std::string word;
  for (const char letter : text + " ") {
    const auto byte = static_cast<unsigned char>(letter);
    if (std::isalnum(byte) != 0 || letter == '-' || byte >= 0x80) {
      word += letter;
      continue;
    }
    if (std::find(odd.begin(), odd.end(), word) != odd.end()) return word;
    if ((byte < 0x20 && letter != '\n') || byte == 0x7f) return "a control character";
    word.clear();
  }
  return {};
}

/// The path of a null that says nothing: the dump of a number that is not finite.
std::string odd_null(const Json& json, const std::string& path) {
  // Null where nothing is to be told, or the end of a run cannot be known.
  static constexpr std::array<std::string_view, 8> allowed{
      "/trial_failure",      "/expected_time_s",      "/expected_steps", "/expected_wall_s",
      "/rehearsal_complete", "/particle_steps_per_s", "/costs",          "/expected_frames"};
  if (json.is_null())
    return std::find(allowed.begin(), allowed.end(), path) == allowed.end() ? path : std::string();
  if (!json.is_structured()) return {};
  for (const auto& [key, value] : json.items()) {
    const std::string found = odd_null(value, path + "/" + key);
    if (!found.empty()) return found;
  }
  return {};
}

std::string fault_of_output(const std::string& text, const Json& json, const Scene& scene) {
  std::string rest = text;  // a title may hold any word
  if (const auto at = rest.find(scene.title); !scene.title.empty() && at != std::string::npos)
    rest.erase(at, scene.title.size());
  if (const std::string word = odd_word(rest); !word.empty()) return "prints " + word;
  if (json.is_discarded()) return "writes JSON that is none";
  if (const std::string path = odd_null(json, ""); !path.empty())
    return "writes a number that is none: " + path;
  return {};
}

void write(const std::filesystem::path& path, std::string_view text) {
  std::ofstream stream(path, std::ios::binary | std::ios::trunc);
  stream.write(text.data(), static_cast<std::streamsize>(text.size()));
}

}  // namespace

CheckedText check_whole(std::string_view text, const std::filesystem::path& folder,
                        double particles) {
  CheckedText result;
  result.scene = text;
  const std::filesystem::path file = folder / "mutant.toml", json_file = folder / "check.json";
  write(file, text);  // what a crash leaves to look at
  try {
    cli::CheckArguments check;
    check.scene.file = file.string();
    check.scene.json = json_file.string();
    check.scene.options.threads = 1;
    check.patience = 0.002;
    const Scene scene = read_scene(file);
    const double spacing = bearable_spacing(scene, particles);
    if (spacing != scene.spacing) {
      check.scene.spacing = fmt::format("{:.17g}", spacing);
      result.scene.insert(0, fmt::format("# --spacing {}\n", check.scene.spacing));
      write(file, result.scene);
    }
    Caught output;
    const int code = cli::check_command(check);
    result.accepted = true;
    if (code != cli::ok && code != cli::unstable) result.fault = fmt::format("ends with {}", code);
    std::ifstream stream(json_file, std::ios::binary);
    const Json json = Json::parse(stream, nullptr, false);
    if (result.fault.empty()) result.fault = fault_of_output(output.text(), json, scene);
    if (json.is_object()) result.time_step = json.value("time_step", 0.0);
  } catch (const SceneError& error) {
    result.message = error.what();
    result.fault = fault_of_message(result.message, file.string());
    if (!result.fault.empty()) result.fault = "a message that is wrong: " + result.fault;
  } catch (const SimulationInstability& error) {
    result.message = error.what();
  } catch (const std::exception& error) {
    result.message = error.what();
    result.fault = "throws what is no complaint about the scene";
  }
  return result;
}

}  // namespace scarp
