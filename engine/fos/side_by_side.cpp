// SPDX-License-Identifier: BSD-3-Clause
/// The trial that runs ahead, and how it becomes the one that is waited for.
#include "engine/fos/side_by_side.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <future>
#include <new>
#include <system_error>

#include "engine/parallel.hpp"
#include "engine/stop.hpp"

namespace scarp {
namespace {

/// How often a trial that is waited for is asked whether it is still wanted.
constexpr std::chrono::milliseconds look_interval{20};

/// Chunks that no second thread helps with count, and threads that did not pay while it settled.
std::optional<int> half_team(const Simulation& settled) {
  const auto chunks = static_cast<int>(
      (static_cast<std::int64_t>(settled.soil_count()) + particle_chunk - 1) / particle_chunk);
  const int pay = std::max(1, std::min(settled.threads_in_use(), chunks));
  const bool alone = settled.options().reduction == nullptr;
  return alone && 2 * pay <= settled.threads() ? std::optional(pay) : std::nullopt;
}

RunOptions with_threads(RunOptions options, int threads) {
  options.threads = threads;
  return options;
}

}  // namespace

/// Given up at its end, where nobody waits for it.
struct SideBySide::Ahead {
  explicit Ahead(double factor) : reduction(factor) {}
  ~Ahead() {
    wanted = false;
    if (response.valid()) response.wait();
  }
  Ahead(const Ahead&) = delete;
  Ahead& operator=(const Ahead&) = delete;

  bool goes_on(const Simulation& now) const {
    const Proceed* const told = listener;
    return wanted && (told == nullptr || !*told || (*told)(now));
  }

  double reduction;
  std::atomic<bool> wanted{true};
  std::atomic<const Proceed*> listener{nullptr};  ///< set once it is waited for
  std::future<std::optional<TrialResponse>> response;
};

SideBySide::SideBySide(StrengthReduction& slope)
    : slope_(slope), half_team_(half_team(slope.settled())) {}
SideBySide::~SideBySide() = default;

/// Null where there is no memory or no thread for it: then trials run one by one.
std::unique_ptr<SideBySide::Ahead> SideBySide::begin(double reduction) const try {
  RunOptions options = with_threads(slope_.settled().options(), *half_team_);
  options.stop = {};  // it is given up by whoever waits for it, in the thread that may ask
  auto ahead = std::make_unique<Ahead>(reduction);
  ahead->response = std::async(
      std::launch::async,
      [&slope = slope_, &self = *ahead, begun = slope_.begin(reduction, options)]() mutable {
        return slope.run(std::move(begun),
                         [&self](const Simulation& now) { return self.goes_on(now); });
      });
  return ahead;
} catch (const std::bad_alloc&) {
  return nullptr;
} catch (const std::system_error&) {
  return nullptr;
}

std::optional<Trial> SideBySide::respond(double reduction, std::optional<double> next,
                                         const Proceed& proceed) {
  const std::unique_ptr<Ahead> running = std::move(ahead_);
  const bool runs = running && running->reduction == reduction;
  if (running && !runs) running->wanted = false;
  if (half_team_ && next && !slope_.is_elastic(*next)) ahead_ = begin(*next);
  if (slope_.is_elastic(reduction)) return slope_.respond(reduction, proceed);
  const RunOptions& options = slope_.settled().options();
  std::optional<TrialResponse> response;
  if (runs) {
    running->listener = &proceed;
    while (running->response.wait_for(look_interval) != std::future_status::ready)
      stop_if_asked(options.stop);
    response = running->response.get();
  } else {
    response = slope_.run(
        slope_.begin(reduction, ahead_ ? with_threads(options, *half_team_) : options), proceed);
  }
  if (!response) return {};
  return slope_.take(std::move(*response));
}

}  // namespace scarp
