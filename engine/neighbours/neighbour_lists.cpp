// SPDX-License-Identifier: BSD-3-Clause
/// Neighbour lists of clusters.
#include "engine/neighbours/neighbour_lists.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "engine/parallel.hpp"

namespace scarp {
namespace {

using kernels::entry_block;

/// Particles that share one gathering of candidates.
constexpr std::int64_t supercluster = 32;

/// Candidates around one supercluster, gathered once for all its clusters.
struct Candidates {
  std::vector<std::int32_t> slots;
  std::vector<double> x, y, z;

  void gather(const NeighbourSource& source, const std::array<double, 3>& low,
              const std::array<double, 3>& high) {
    slots.clear();
    if (source.grid != nullptr) {
      source.grid->collect(source.grid->cell_of(low[0], low[1], low[2]),
                           source.grid->cell_of(high[0], high[1], high[2]), slots);
    }
    const std::size_t count = slots.size();
    x.assign(count + entry_block, 1e150);
    y.assign(count + entry_block, 0.0);
    z.assign(count + entry_block, 0.0);
    for (std::size_t k = 0; k < count; ++k) {
      const auto slot = static_cast<std::size_t>(slots[k]);
      x[k] = source.points.x[slot];
      y[k] = source.points.y[slot];
      if (source.points.z != nullptr) z[k] = source.points.z[slot];
    }
  }
};

/// Lists of one chunk of superclusters, before they are put behind each other.
struct ChunkLists {
  std::vector<std::int32_t> entries;
  std::vector<std::int64_t> soil_size, wall_size;  ///< per cluster, padded
};

class ChunkBuilder {
 public:
  ChunkBuilder(const kernels::KernelTable& kernels, const NeighbourLists::Input& input,
               ChunkLists& out)
      : kernels_(kernels), input_(input), out_(out) {}

  void add_supercluster(std::int64_t begin, std::int64_t padded_end) {
    std::int64_t valid_end = begin;
    for (const SlotRange& range : input_.ranges) {
      if (begin >= range.begin && begin < range.end) valid_end = std::min(range.end, padded_end);
    }
    if (valid_end > begin) gather(begin, valid_end);
    const std::int64_t size = input_.cluster_size;
    for (std::int64_t first = begin; first < padded_end; first += size) {
      const auto members = static_cast<int>(std::clamp<std::int64_t>(valid_end - first, 0, size));
      std::int64_t soil = 0, walls = 0;
      if (members > 0) {
        soil = append(soil_, input_.soil, first, members);
        soil = pad(soil + append(images_, input_.images, first, members));
        walls = pad(append(walls_, input_.walls, first, members));
      }
      out_.soil_size.push_back(soil);
      out_.wall_size.push_back(walls);
    }
  }

 private:
  void gather(std::int64_t begin, std::int64_t end) {
    const double* axes[3] = {input_.points.x, input_.points.y, input_.points.z};
    std::array<double, 3> low{}, high{};
    for (int a = 0; a < input_.dimension; ++a) {
      const auto [least, most] = std::minmax_element(axes[a] + begin, axes[a] + end);
      low[a] = *least - input_.reach;
      high[a] = *most + input_.reach;
    }
    soil_.gather(input_.soil, low, high);
    images_.gather(input_.images, low, high);
    walls_.gather(input_.walls, low, high);
  }

  std::int64_t pad(std::int64_t kept) {
    const std::int64_t full = (kept + entry_block - 1) / entry_block * entry_block;
    out_.entries.insert(out_.entries.end(), static_cast<std::size_t>(full - kept),
                        static_cast<std::int32_t>(input_.far_record));
    return full;
  }

  std::int64_t append(const Candidates& candidates, const NeighbourSource& source,
                      std::int64_t first, int members) {
    const std::size_t count = candidates.slots.size();
    if (count == 0) return 0;
    found_.resize(count + entry_block);
    const kernels::CandidateView view{
        candidates.x.data(),
        candidates.y.data(),
        candidates.z.data(),
        static_cast<int>(count),
        input_.points.x + first,
        input_.points.y + first,
        input_.points.z != nullptr ? input_.points.z + first : zeros_.data(),
        members,
        input_.reach * input_.reach};
    const int kept = kernels_.filter_candidates(view, found_.data());
    for (int k = 0; k < kept; ++k) {
      const std::int32_t slot =
          candidates.slots[static_cast<std::size_t>(found_[static_cast<std::size_t>(k)])];
      out_.entries.push_back(static_cast<std::int32_t>(source.first_record + slot));
    }
    return kept;
  }

  const kernels::KernelTable& kernels_;
  const NeighbourLists::Input& input_;
  ChunkLists& out_;
  Candidates soil_, images_, walls_;
  std::vector<std::int32_t> found_;
  std::array<double, 16> zeros_{};
};

}  // namespace

void NeighbourLists::build(int threads, const kernels::KernelTable& kernels, const Input& input) {
  static_assert(particle_chunk % supercluster == 0);
  const std::int64_t size = input.cluster_size, clusters = input.slots / size;
  std::vector<ChunkLists> chunks(
      static_cast<std::size_t>((input.slots + particle_chunk - 1) / particle_chunk));
  parallel_chunks(threads, input.slots, particle_chunk, [&](std::int64_t begin, std::int64_t end) {
    ChunkBuilder builder(kernels, input, chunks[static_cast<std::size_t>(begin / particle_chunk)]);
    // A supercluster ends with its range, so that no candidate box spans two materials' far
    // corners.
    for (std::int64_t slot = begin; slot < end;) {
      std::int64_t next = std::min(slot + supercluster, end);
      for (const SlotRange& range : input.ranges) {
        if (range.begin > slot) next = std::min(next, range.begin);
      }
      builder.add_supercluster(slot, next);
      slot = next;
    }
  });
  soil_begin_.resize(static_cast<std::size_t>(clusters));
  wall_begin_.resize(static_cast<std::size_t>(clusters));
  end_.resize(static_cast<std::size_t>(clusters));
  active_.clear();
  std::vector<std::int64_t> chunk_start;
  std::int64_t total = 0;
  std::size_t cluster = 0;
  for (const ChunkLists& chunk : chunks) {
    chunk_start.push_back(total);
    for (std::size_t k = 0; k < chunk.soil_size.size(); ++k, ++cluster) {
      soil_begin_[cluster] = total;
      wall_begin_[cluster] = total + chunk.soil_size[k];
      total = end_[cluster] = wall_begin_[cluster] + chunk.wall_size[k];
      if (end_[cluster] > soil_begin_[cluster])
        active_.push_back(static_cast<std::int32_t>(cluster));
    }
  }
  entries_.resize(static_cast<std::size_t>(total + 3 * entry_block));
  parallel_chunks(threads, static_cast<std::int64_t>(chunks.size()), 1,
                  [&](std::int64_t c, std::int64_t) {
                    const auto& from = chunks[static_cast<std::size_t>(c)].entries;
                    std::copy(from.begin(), from.end(),
                              entries_.begin() + chunk_start[static_cast<std::size_t>(c)]);
                  });
  std::fill(entries_.begin() + total, entries_.end(), static_cast<std::int32_t>(input.far_record));
}

std::size_t NeighbourLists::bytes() const {
  return entries_.size() * sizeof(std::int32_t) + 3 * end_.size() * sizeof(std::int64_t);
}

}  // namespace scarp
