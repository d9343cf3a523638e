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

/// Threads that pay for a trial: they did while it settled, and each has a chunk of its own.
int useful_threads(const Simulation& settled) {
  const auto soil = static_cast<std::int64_t>(settled.soil_count());
  const auto chunks = static_cast<int>((soil + particle_chunk - 1) / particle_chunk);
  return std::max(1, std::min(settled.threads_in_use(), chunks));
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
    : slope_(slope), team_(useful_threads(slope.settled())) {
  const Simulation& settled = slope.settled();
  const bool alone = settled.options().reduction == nullptr;
  if (alone && settled.threads() >= 3 * team_) beside_ = 2;
}
SideBySide::~SideBySide() = default;

/// Null where there is no memory or no thread for it: then trials run one by one.
std::unique_ptr<SideBySide::Ahead> SideBySide::begin(double reduction) const try {
  RunOptions options = with_threads(slope_.settled().options(), team_);
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

/// Gives up what is not among `next`, and begins what is, as far as there are threads.
void SideBySide::look_ahead(const std::vector<double>& next) {
  const auto is_next = [&next](const std::unique_ptr<Ahead>& one) {
    return std::find(next.begin(), next.end(), one->reduction) != next.end();
  };
  for (const std::unique_ptr<Ahead>& one : ahead_) one->wanted = is_next(one);
  std::erase_if(ahead_, [](const std::unique_ptr<Ahead>& one) { return !one->wanted; });
  for (const double factor : next) {
    const auto is_it = [factor](const auto& one) { return one->reduction == factor; };
    if (std::ssize(ahead_) >= beside_ || slope_.is_elastic(factor) ||
        std::any_of(ahead_.begin(), ahead_.end(), is_it))
      continue;
    if (auto one = begin(factor)) ahead_.push_back(std::move(one));
  }
}

std::optional<Trial> SideBySide::respond(double reduction, const std::vector<double>& next,
                                         const Proceed& proceed) {
  const auto found = std::find_if(ahead_.begin(), ahead_.end(),
                                  [=](const auto& one) { return one->reduction == reduction; });
  std::unique_ptr<Ahead> running;
  if (found != ahead_.end()) {
    running = std::move(*found);
    ahead_.erase(found);
  }
  look_ahead(next);
  if (slope_.is_elastic(reduction)) return slope_.respond(reduction, proceed);
  const RunOptions& options = slope_.settled().options();
  std::optional<TrialResponse> response;
  if (running) {
    running->listener = &proceed;
    while (running->response.wait_for(look_interval) != std::future_status::ready)
      stop_if_asked(options.stop);
    response = running->response.get();
  } else {
    response = slope_.run(
        slope_.begin(reduction, ahead_.empty() ? options : with_threads(options, team_)), proceed);
  }
  if (!response) return {};
  return slope_.take(std::move(*response));
}

}  // namespace scarp
