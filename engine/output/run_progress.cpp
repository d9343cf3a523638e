// SPDX-License-Identifier: BSD-3-Clause
/// Stages and retries of a run as named arrays.
#include "engine/output/run_progress.hpp"

#include <sstream>

#include "engine/checkpoint/finite_numbers.hpp"

namespace scarp {

void add_results(Snapshot& snapshot, const RunResults& results) {
  std::string names;
  std::vector<std::int64_t> steps, rest;
  std::vector<double> times;
  for (const StageResult& stage : results.stages) {
    names += stage.name + '\n';
    steps.push_back(static_cast<std::int64_t>(stage.end_step));
    rest.push_back(stage.reached_rest);
    times.push_back(stage.end_time);
  }
  snapshot.add("outputs/ended_stages", std::move(names));
  snapshot.add("outputs/end_steps", std::move(steps));
  snapshot.add("outputs/reached_rest", std::move(rest));
  snapshot.add("outputs/end_times", "s", std::move(times));
  std::string reasons;
  std::vector<std::int64_t> retry_steps;
  std::vector<double> factors;
  for (const Retry& retry : results.retries) {
    reasons += retry.reason + '\n';
    retry_steps.push_back(static_cast<std::int64_t>(retry.step));
    retry_steps.push_back(static_cast<std::int64_t>(retry.back_to));
    factors.push_back(retry.step_factor);
  }
  snapshot.add("outputs/retry_reasons", std::move(reasons));
  snapshot.add("outputs/retry_steps", std::move(retry_steps));
  snapshot.add("outputs/retry_factors", "", std::move(factors));
}

RunResults results_in(const Snapshot& snapshot) {
  RunResults results;
  std::istringstream names(snapshot.text("outputs/ended_stages"));
  const std::size_t ended = snapshot.numbers("outputs/end_times").size();
  const std::vector<double>& times = finite_numbers(snapshot, "outputs/end_times", ended);
  const std::vector<std::int64_t>& steps = snapshot.integers("outputs/end_steps", times.size());
  const std::vector<std::int64_t>& rest = snapshot.integers("outputs/reached_rest", times.size());
  for (std::size_t k = 0; k < times.size(); ++k) {
    std::string name;
    std::getline(names, name);
    results.stages.push_back({name, times[k], static_cast<std::uint64_t>(steps[k]), rest[k] != 0});
  }
  std::istringstream reasons(snapshot.text("outputs/retry_reasons"));
  const std::vector<double>& factors = snapshot.numbers("outputs/retry_factors");
  const std::vector<std::int64_t>& retried =
      snapshot.integers("outputs/retry_steps", 2 * factors.size());
  for (std::size_t k = 0; k < factors.size(); ++k) {
    std::string reason;
    std::getline(reasons, reason);
    results.retries.push_back({static_cast<std::uint64_t>(retried[2 * k]),
                               static_cast<std::uint64_t>(retried[2 * k + 1]), factors[k], reason});
  }
  return results;
}

}  // namespace scarp
