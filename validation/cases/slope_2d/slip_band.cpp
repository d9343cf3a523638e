// SPDX-License-Identifier: BSD-3-Clause
/// Plastic strain along rays from a circle's centre.

#include "validation/cases/slope_2d/slip_band.hpp"

#include <algorithm>
#include <cmath>

namespace scarp::validation {
namespace {

/// Mean strain in bins of one spacing along a ray, by distance from the circle.
struct Profile {
  double first = 0.0, width = 0.0;
  std::vector<double> strain;
  double distance(std::size_t bin) const {
    return first + (static_cast<double>(bin) + 0.5) * width;
  }
};

/// Adds the band of one profile to `section`; false if the ray has none.
bool locate(const Profile& profile, BandSection& section) {
  const auto peak = std::max_element(profile.strain.begin(), profile.strain.end());
  double mean = 0.0;
  for (const double value : profile.strain) {
    mean += value / static_cast<double>(profile.strain.size());
  }
  if (peak == profile.strain.end() || !(*peak > 0.0) || *peak < 2.0 * mean) return false;
  auto from = peak, to = peak;
  while (from != profile.strain.begin() && *(from - 1) > 0.5 * *peak) --from;
  while (to + 1 != profile.strain.end() && *(to + 1) > 0.5 * *peak) ++to;
  double weight = 0.0, moment = 0.0;
  for (auto bin = from; bin <= to; ++bin) {
    weight += *bin;
    moment += *bin * profile.distance(static_cast<std::size_t>(bin - profile.strain.begin()));
  }
  section.offset = moment / weight;
  section.strain = *peak;
  return true;
}

}  // namespace

std::vector<BandSection> slip_band(const Simulation& simulation, const BishopResult& bishop,
                                   int rays, double share) {
  const std::vector<double> position = simulation.field("position");
  const std::vector<double> displacement = simulation.field("displacement");
  const std::vector<double> strain = simulation.field("accumulated_plastic_strain");
  const Circle& circle = bishop.circle;
  const double spacing = simulation.scene().spacing;
  const auto angle_of = [&](double x, double y) { return std::atan2(x - circle.x, circle.y - y); };
  const double start = angle_of(bishop.entry[0], bishop.entry[1]);
  const double end = angle_of(bishop.exit[0], bishop.exit[1]);
  const double half_width = 1.5 * spacing / circle.radius;

  std::vector<BandSection> found;
  for (int ray = 0; ray < rays; ++ray) {
    const double part = 0.5 + share * ((ray + 0.5) / rays - 0.5);
    BandSection section;
    section.angle = start + part * (end - start);
    std::vector<std::pair<double, double>> samples;
    for (std::size_t i = 0; i < strain.size(); ++i) {
      const double x = position[3 * i] - displacement[3 * i];
      const double y = position[3 * i + 1] - displacement[3 * i + 1];
      if (std::fabs(angle_of(x, y) - section.angle) > half_width) continue;
      samples.emplace_back(std::hypot(x - circle.x, y - circle.y) - circle.radius, strain[i]);
    }
    if (samples.empty()) continue;
    Profile profile;
    profile.width = spacing;
    profile.first = std::min_element(samples.begin(), samples.end())->first;
    const double last = std::max_element(samples.begin(), samples.end())->first;
    std::vector<double> sums(static_cast<std::size_t>((last - profile.first) / spacing) + 1);
    std::vector<int> counts(sums.size());
    for (const auto& [distance, value] : samples) {
      const auto bin = static_cast<std::size_t>((distance - profile.first) / spacing);
      sums[bin] += value;
      ++counts[bin];
    }
    for (std::size_t bin = 0; bin < sums.size(); ++bin) {
      profile.strain.push_back(counts[bin] > 0 ? sums[bin] / counts[bin] : 0.0);
    }
    if (!locate(profile, section)) continue;
    section.x = circle.x + (circle.radius + section.offset) * std::sin(section.angle);
    section.y = circle.y - (circle.radius + section.offset) * std::cos(section.angle);
    found.push_back(section);
  }
  return found;
}

}  // namespace scarp::validation
