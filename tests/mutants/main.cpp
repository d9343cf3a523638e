// SPDX-License-Identifier: BSD-3-Clause
/// Mutants of the scenes in a folder, through the whole of `scarp check`, or into files.
#include <fmt/format.h>

#include <sys/time.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "engine/errors.hpp"
#include "tests/mutants/mutate.hpp"
#include "tests/mutants/whole_check.hpp"

namespace {

namespace fs = std::filesystem;

constexpr double most_particles = 3000;

std::vector<std::string> scenes_in(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::vector<std::string> scenes;
  for (const fs::path& file : files) {
    std::ifstream stream(file, std::ios::binary);
    scenes.emplace_back(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
  }
  return scenes;
}

/// Processor time after which one scene counts as one that never ends [s]; ends the process.
void start_clock() {
  constexpr int seconds = 60;
  const itimerval limit{{0, 0}, {seconds, 0}};
  setitimer(ITIMER_PROF, &limit, nullptr);
}

int run(const std::string& mode, const fs::path& seeds, const fs::path& work, std::size_t first,
        std::size_t count) {
  const std::vector<std::string> scenes = scenes_in(seeds);
  fs::create_directories(work);
  std::size_t accepted = 0, faults = 0, written = 0;
  for (std::size_t k = first; written < count && k < first + 100 * count; ++k) {
    scarp::Random random(k);  // each mutant can be made again alone
    const std::string text = scarp::mutate(scenes[random() % scenes.size()], scenes, random);
    start_clock();
    const scarp::CheckedText checked = scarp::check_whole(text, work, most_particles);
    accepted += checked.accepted;
    if (mode == "check") ++written;
    if (mode == "write" && checked.accepted)
      std::ofstream(work / fmt::format("mutant_{:05}.toml", written++), std::ios::binary)
          << fmt::format("# time_step {:.17g}\n", checked.time_step) << checked.scene;
    if (checked.fault.empty()) continue;
    ++faults;
    std::ofstream(work / fmt::format("fault_{}.toml", k), std::ios::binary) << checked.scene;
    fmt::print("mutant {}: {}: {}\n", k, checked.fault, checked.message);
  }
  fmt::print("{} mutants, {} accepted, {} faults\n", written, accepted, faults);
  return faults == 0 && written == count ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 6) {
    fmt::print("usage: mutants check|write FOLDER_OF_SCENES WORK_FOLDER FIRST COUNT\n");
    return 2;
  }
  return run(argv[1], argv[2], argv[3], std::stoul(argv[4]), std::stoul(argv[5]));
}
