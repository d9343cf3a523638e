// SPDX-License-Identifier: BSD-3-Clause
/// Records in single precision.
#include "engine/sweep/narrow_records.hpp"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <iterator>
#include <limits>

#include "engine/particles/each_slot.hpp"

namespace scarp {

using namespace kernels;

namespace {

SmoothingView<float> narrowed(const SmoothingView<double>& wide) {
  SmoothingView<float> out{};
  for (int k = 0; k < 3; ++k) {
    out.derivative[k] = static_cast<float>(wide.derivative[k]);
    out.value[k] = static_cast<float>(wide.value[k]);
  }
  out.derivative_inner = static_cast<float>(wide.derivative_inner);
  out.value_inner = static_cast<float>(wide.value_inner);
  return out;
}

PairConstants<float> narrowed(const PairConstants<double>& wide) {
  PairConstants<float> out{};
  out.smoothing = narrowed(wide.smoothing);
  out.viscosity_alpha = static_cast<float>(wide.viscosity_alpha);
  out.viscosity_beta = static_cast<float>(wide.viscosity_beta);
  out.hourglass_viscosity = static_cast<float>(wide.hourglass_viscosity);
  for (int a = 0; a < 3; ++a) out.gravity[a] = static_cast<float>(wide.gravity[a]);
  const auto narrow = [](double value) { return static_cast<float>(value); };
  std::ranges::transform(wide.tension_factor.outer, out.tension_factor.outer, narrow);
  std::ranges::transform(wide.tension_factor.inner, out.tension_factor.inner, narrow);
  return out;
}

float position_bits(double steps) {
  return std::bit_cast<float>(static_cast<std::int32_t>(std::lrint(steps)));
}

/// Above every record.
constexpr std::int64_t none = std::numeric_limits<std::int64_t>::max();

/// Where padding is put: further from any particle than the support, and so that no difference
/// overflows.
constexpr double far_steps = 2.0 * position_reach / position_step;

}  // namespace

PairSweepView<float> NarrowRecords::narrow(int threads, const PairSweepView<double>& view,
                                           std::int64_t far_record, const RecordsRead& read) {
  const std::int64_t count = far_record + 1, others = read.owned + read.dummies,
                     cluster = read.dummy_cluster_size;
  const auto each_range = [&](auto&& convert) {
    each_slot(threads, read.soil, read.owned, convert);
    parallel_chunks(threads, std::ssize(read.dummy_clusters), particle_chunk / cluster,
                    [&](std::int64_t begin, std::int64_t end) {
                      for (std::int64_t n = begin; n < end; ++n) {
                        const std::int64_t first =
                            read.owned + read.dummy_clusters[static_cast<std::size_t>(n)] * cluster;
                        convert(first, first + cluster);
                      }
                    });
    parallel_chunks(
        threads, count - others, particle_chunk,
        [&](std::int64_t begin, std::int64_t end) { convert(others + begin, others + end); });
  };
  records_.resize(static_cast<std::size_t>(count * record_size));
  const double far_x = view.records[far_record * record_size + record_x];
  // The first record is never padding, and any soil particle serves as origin.
  const double* origin = view.records + record_x;
  std::atomic<std::int64_t> first_out = none;
  each_range([&](std::int64_t begin, std::int64_t end) {
    std::int64_t first = none;
    for (std::int64_t k = begin; k < end; ++k) {
      const double* from = view.records + k * record_size;
      float* to = records_.data() + k * record_size;
      const bool padding = from[record_x] == far_x;
      for (int a = 0; a < 3; ++a) {
        const double offset = from[record_x + a] - origin[a];
        const bool fits = std::fabs(offset) < position_reach;
        if (!fits && !padding) first = std::min(first, k);
        to[record_x + a] = position_bits(padding ? far_steps : fits ? offset / position_step : 0.0);
      }
      for (int slot = record_volume; slot < record_size; ++slot)
        to[slot] = static_cast<float>(from[slot]);
    }
    std::int64_t before = first_out.load();
    while (first < before && !first_out.compare_exchange_weak(before, first)) {
    }
  });
  out_of_reach_ = first_out < none ? std::optional(first_out.load()) : std::nullopt;
  PairSweepView<float> out{};
  const auto narrow_lines = [&](const double* from, int size,
                                AlignedVector<float>& to) -> const float* {
    if (from == nullptr) return nullptr;
    to.resize(static_cast<std::size_t>(count * size));
    each_range([&](std::int64_t begin, std::int64_t end) {
      for (std::int64_t k = begin * size; k < end * size; ++k)
        to[static_cast<std::size_t>(k)] = static_cast<float>(from[k]);
    });
    return to.data();
  };
  out.second = narrow_lines(view.second, second_record_size, second_);
  out.extra = narrow_lines(view.extra, extra_record_size, extra_);
  out.records = records_.data();
  out.marked = view.marked;
  out.material = view.material;
  out.clusters = view.clusters;
  out.neighbours = view.neighbours;
  out.constants = narrowed(view.constants);
  out.smoothing_length = view.smoothing_length;
  std::copy(std::begin(view.output), std::end(view.output), out.output);
  return out;
}

std::size_t NarrowRecords::bytes() const {
  return (records_.size() + second_.size() + extra_.size()) * sizeof(float);
}

}  // namespace scarp
