// SPDX-License-Identifier: BSD-3-Clause
/// Tables of `scarp check`.
#include "engine/cli/check_output.hpp"

#include <fmt/format.h>

#include <string>

namespace scarp::cli {

using Json = nlohmann::ordered_json;

void print_costs(const Json& costs) {
  fmt::print("\n{:<30} {:>10} {:>10}\n", "cost at the start", "of a step", "bytes");
  for (const Json& cost : costs) {
    const Json &share = cost["share_of_step"], &bytes = cost["bytes_per_particle"];
    fmt::print("{:<30} {:>10} {:>10}\n", cost["feature"].get<std::string>(),
               share.is_null() ? "?" : fmt::format("{:.0f} %", 100.0 * share.get<double>()),
               bytes.is_null() ? "?" : fmt::format("{:.0f}", bytes.get<double>()));
  }
}

void print_probe(const Json& probed) {
  fmt::print("\nprobe of {} steps, {:.3g} s each on average, at a spacing of {:.3g} m\n",
             probed["steps"].get<std::uint64_t>(), probed["time_step"].get<double>(),
             probed["spacing"].get<double>());
  for (const auto& [limit, count] : probed["step_limits"].items()) {
    if (count.get<std::uint64_t>() > 0)
      fmt::print("  set by {:<12} {:>5} steps\n", limit, count.get<std::uint64_t>());
  }
  fmt::print("  sound is fastest in '{}'\n", probed["signal_material"].get<std::string>());
  if (probed["materials"].size() > 1) {
    for (const Json& material : probed["materials"]) {
      fmt::print("    {:<20} {:.4g} m/s, alone {:.3g} s a step\n",
                 material["name"].get<std::string>(), material["sound_speed"].get<double>(),
                 material["time_step"].get<double>());
    }
  }
  const double cfl = probed["cfl"].get<double>(), stable = probed["margin"]["stable"].get<double>();
  const Json& unstable = probed["margin"]["unstable"];
  if (stable < 1.0) {
    fmt::print("  UNSTABLE at cfl = {:g}; {}\n", cfl,
               stable > 0.0 ? fmt::format("stable at {:.3g}", cfl * stable)
                            : std::string("and at a sixteenth of it"));
  } else if (unstable.is_null()) {
    fmt::print("  margin: stable up to cfl = {:.3g} at least, {:.2g} times that of the scene\n",
               cfl * stable, stable);
  } else {
    fmt::print("  margin: unstable from cfl = {:.3g} on, {:.2g} times that of the scene\n",
               cfl * unstable.get<double>(), unstable.get<double>());
  }
  fmt::print("  closed form for sound on the undisturbed lattice: cfl = {:.3g}\n",
             probed["acoustic_cfl_limit"].get<double>());
  if (!probed["failure"].is_null())
    fmt::print("  The probe became unstable: {}\n", probed["failure"].get<std::string>());
}

}  // namespace scarp::cli
