// SPDX-License-Identifier: BSD-3-Clause
/// Neighbour lists of clusters.
#include "engine/neighbours/neighbour_lists.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <tuple>
#include <utility>

#include "engine/parallel.hpp"

namespace scarp {
namespace {

using kernels::entry_block;

/// Particles that share one gathering of candidates.
constexpr std::int64_t supercluster = 32;

/// Of members begin .. end of `input` to what is not fast.
double reach_of(const NeighbourLists::Input& input, std::int64_t begin, std::int64_t end) {
  const auto first = std::lower_bound(input.fast.begin(), input.fast.end(), begin);
  return first != input.fast.end() && *first < end ? input.reach + input.more : input.reach;
}

/// Candidates around one supercluster, gathered once for all its clusters.
struct Candidates {
  std::vector<std::int32_t> slots;
  std::vector<double> x, y, z;

  /// The points of `source` in the cells that members begin .. end of `input` reach.
  void gather(const ParticleSource& source, const NeighbourLists::Input& input, std::int64_t begin,
              std::int64_t end) {
    slots.clear();
    const double reach = reach_of(input, begin, end);
    const CellBox box = reached(*source.grid, input, begin, end, reach);
    if (box.count() <= static_cast<double>(std::max(source.grid->occupied(), few_cells))) {
      source.grid->collect(box, slots);
    } else {
      collect_around_each(*source.grid, input, begin, end, reach);
    }
    take_points(source);
  }

  /// The fast points of `source`, wherever they are.
  void gather_fast(const ParticleSource& source) {
    slots.assign(source.fast.begin(), source.fast.end());
    if (!slots.empty()) take_points(source);
  }

 private:
  void take_points(const ParticleSource& source) {
    put_pages_together(source.first_record);
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

  /// A box of so many cells is looked through whatever is in it.
  static constexpr std::size_t few_cells = 4096;

  static CellBox reached(const CellGrid& grid, const NeighbourLists::Input& input,
                         std::int64_t begin, std::int64_t end, double reach) {
    const double* axes[3] = {input.points.x, input.points.y, input.points.z};
    std::array<double, 3> low{}, high{};
    for (std::size_t a = 0; a < static_cast<std::size_t>(input.dimension); ++a) {
      const auto [least, most] = std::minmax_element(axes[a] + begin, axes[a] + end);
      low[a] = *least - reach;
      high[a] = *most + reach;
    }
    return grid.box_of(low, high);
  }

  /// Members that lie far apart would have a box of mostly empty cells between them: the cells
  /// around each are as many as are needed, in the order in which the box would give them.
  void collect_around_each(const CellGrid& grid, const NeighbourLists::Input& input,
                           std::int64_t begin, std::int64_t end, double reach) {
    cells_.clear();
    for (std::int64_t k = begin; k < end; ++k) {
      const CellBox box = reached(grid, input, k, k + 1, reach);
      CellIndex at{};
      for (at[2] = box.low[2]; at[2] <= box.high[2]; ++at[2]) {
        for (at[1] = box.low[1]; at[1] <= box.high[1]; ++at[1]) {
          for (at[0] = box.low[0]; at[0] <= box.high[0]; ++at[0])
            cells_.push_back({at[0] & cell_mask, at[1] & cell_mask, at[2] & cell_mask});
        }
      }
    }
    std::sort(cells_.begin(), cells_.end(), [](const CellIndex& a, const CellIndex& b) {
      return std::tie(a[2], a[1], a[0]) < std::tie(b[2], b[1], b[0]);
    });
    cells_.erase(std::unique(cells_.begin(), cells_.end()), cells_.end());
    grid.collect(cells_, slots);
  }

  /// Blocks of a list hold records of one page, and most superclusters see but one.
  void put_pages_together(std::int64_t first_record) {
    if (slots.empty()) return;
    const auto [lowest, highest] = std::minmax_element(slots.begin(), slots.end());
    if (page_of(first_record + *lowest) == page_of(first_record + *highest)) return;
    std::size_t used = 0, page = 0;
    for (const std::int32_t slot : slots) {
      const auto record = static_cast<std::int32_t>(first_record + slot);
      if (used == 0 || !in_page(record, pages_[page].begin)) {
        page = 0;
        while (page < used && !in_page(record, pages_[page].begin)) ++page;
        if (page == used) {
          if (used == pages_.size()) pages_.emplace_back();
          pages_[used++] = {page_of(record), std::move(pages_[page].slots)};
          pages_[page].slots.clear();
        }
      }
      pages_[page].slots.push_back(slot);
    }
    slots.clear();
    for (std::size_t k = 0; k < used; ++k)
      slots.insert(slots.end(), pages_[k].slots.begin(), pages_[k].slots.end());
  }

  struct Page {
    std::int32_t begin = 0;
    std::vector<std::int32_t> slots;
  };
  std::vector<Page> pages_;       ///< scratch
  std::vector<CellIndex> cells_;  ///< scratch
};

/// Where the parts of each cluster's list end, in blocks.
struct PartEnds {
  std::int64_t *soil, *dummies, *inner;
};

/// Makes the lists of one chunk of superclusters, before they are put behind each other.
class ChunkBuilder {
 public:
  ChunkBuilder(const kernels::KernelTable& kernels, const NeighbourLists::Input& input,
               const PartEnds& ends, NeighbourBlocks& out)
      : kernels_(kernels),
        input_(input),
        ends_(ends),
        out_(out),
        candidates_(input.sources.size()),
        fast_(input.sources.size()) {
    for (std::size_t s = 0; s < fast_.size(); ++s) fast_[s].gather_fast(input.sources[s]);
  }

  void add_supercluster(std::int64_t begin, std::int64_t padded_end) {
    std::int64_t valid_end = begin;
    for (const SlotRange& range : input_.ranges) {
      if (begin >= range.begin && begin < range.end) valid_end = std::min(range.end, padded_end);
    }
    if (valid_end > begin) gather(begin, valid_end);
    const std::int64_t size = input_.cluster_size;
    for (std::int64_t first = begin; first < padded_end; first += size) {
      const auto members = static_cast<int>(std::clamp<std::int64_t>(valid_end - first, 0, size));
      const auto end_of = [&](Part part) {
        if (members > 0) add_list(first, members, part);
        return out_.size();
      };
      const std::int64_t cluster = first / size;
      ends_.soil[cluster] = end_of(Part::soil);
      ends_.dummies[cluster] = end_of(Part::dummies);
      ends_.inner[cluster] = end_of(Part::inner);
    }
  }

 private:
  /// Of a list.
  enum class Part { soil, dummies, inner };
  static Part part_of(Role role) {
    if (role == Role::inner) return Part::inner;
    return role == Role::dummy ? Part::dummies : Part::soil;
  }

  void gather(std::int64_t begin, std::int64_t end) {
    for (std::size_t s = 0; s < candidates_.size(); ++s)
      candidates_[s].gather(input_.sources[s], input_, begin, end);
  }

  /// One part of the list of a cluster.
  void add_list(std::int64_t first, int members, Part part) {
    for (std::size_t s = 0; s < candidates_.size(); ++s) {
      if (part_of(input_.sources[s].role) == part) add(s, first, members);
    }
    out_.end_list();
  }

  /// Those of a source that a cluster reaches; fast ones it reaches from further away.
  void add(std::size_t s, std::int64_t first, int members) {
    const double reach = reach_of(input_, first, first + members);
    filter(candidates_[s], first, members, reach, found_);
    for (const std::int32_t slot : found_) add_record(s, slot);
    if (fast_[s].slots.empty()) return;
    filter(fast_[s], first, members, reach + input_.more, found_);
    if (found_.empty()) return;
    filter(fast_[s], first, members, reach, near_);
    for (const std::int32_t slot : found_) {
      if (std::find(near_.begin(), near_.end(), slot) == near_.end()) add_record(s, slot);
    }
  }

  void add_record(std::size_t s, std::int32_t slot) {
    out_.add(static_cast<std::int32_t>(input_.sources[s].first_record + slot));
  }

  /// Slots of the candidates within `reach` of a member.
  void filter(const Candidates& candidates, std::int64_t first, int members, double reach,
              std::vector<std::int32_t>& found) {
    const std::size_t count = candidates.slots.size();
    found.resize(count + entry_block);
    const kernels::CandidateView view{
        candidates.x.data(),
        candidates.y.data(),
        candidates.z.data(),
        static_cast<int>(count),
        input_.points.x + first,
        input_.points.y + first,
        input_.points.z != nullptr ? input_.points.z + first : zeros_.data(),
        members,
        reach * reach};
    const int kept = count == 0 ? 0 : kernels_.filter_candidates(view, found.data());
    found.resize(static_cast<std::size_t>(kept));
    for (std::int32_t& k : found) k = candidates.slots[static_cast<std::size_t>(k)];
  }

  const kernels::KernelTable& kernels_;
  const NeighbourLists::Input& input_;
  const PartEnds& ends_;
  NeighbourBlocks& out_;
  std::vector<Candidates> candidates_, fast_;  ///< by source
  std::vector<std::int32_t> found_, near_;
  std::array<double, 16> zeros_{};
};

}  // namespace

void NeighbourLists::build(int threads, const kernels::KernelTable& kernels, const Input& input) {
  static_assert(particle_chunk % supercluster == 0);
  const std::int64_t size = input.cluster_size, clusters = input.slots / size;
  std::vector<NeighbourBlocks> chunks(
      static_cast<std::size_t>((input.slots + particle_chunk - 1) / particle_chunk));
  std::vector<std::int64_t> first_block(chunks.size());
  soil_begin_.resize(static_cast<std::size_t>(clusters + 1));
  wall_begin_.resize(static_cast<std::size_t>(clusters));
  inner_begin_.resize(static_cast<std::size_t>(clusters));
  // Each part begins where the one before ends.
  const PartEnds ends{wall_begin_.data(), inner_begin_.data(), soil_begin_.data() + 1};
  far_record_ = static_cast<std::int32_t>(input.far_record);
  // Lists of a chunk are mostly as long as the last ones.
  const std::int64_t expected =
      9 * blocks_.size() / (8 * std::max<std::int64_t>(1, std::ssize(chunks)));
  const auto each_chunk = [&](const auto& visit) {
    parallel_chunks(threads, input.slots, particle_chunk,
                    [&](std::int64_t begin, std::int64_t end) {
                      visit(static_cast<std::size_t>(begin / particle_chunk), begin, end);
                    });
  };
  each_chunk([&](std::size_t c, std::int64_t begin, std::int64_t end) {
    chunks[c].reserve(expected);
    ChunkBuilder builder(kernels, input, ends, chunks[c]);
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
    first_block[c] = chunks[c].size();
  });
  blocks_.resize(put_behind_each_other(first_block));
  each_chunk([&](std::size_t c, std::int64_t begin, std::int64_t end) {
    const NeighbourBlocks chunk = std::move(chunks[c]);  // given back here, by many threads
    blocks_.copy(chunk, first_block[c]);
    for (std::int64_t* of_part : {ends.soil, ends.dummies, ends.inner}) {
      for (std::int64_t cluster = begin / size; cluster < end / size; ++cluster)
        of_part[cluster] += first_block[c];
    }
  });
  blocks_.append_empty(2);
  parallel_gather(threads, clusters, particle_chunk / size, active_,
                  [&](std::int64_t begin, std::int64_t end, auto& active) {
                    for (auto c = static_cast<std::size_t>(begin);
                         c < static_cast<std::size_t>(end); ++c) {
                      if (soil_begin_[c + 1] > soil_begin_[c])
                        active.push_back(static_cast<std::int32_t>(c));
                    }
                  });
}

std::size_t NeighbourLists::bytes() const {
  return blocks_.bytes() +
         (soil_begin_.size() + wall_begin_.size() + inner_begin_.size()) * sizeof(std::int64_t);
}

}  // namespace scarp
