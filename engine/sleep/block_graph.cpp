// SPDX-License-Identifier: BSD-3-Clause
/// Neighbourhoods of particles become neighbourhoods of blocks.
#include "engine/sleep/block_graph.hpp"

#include <algorithm>
#include <utility>

#include "engine/parallel.hpp"
#include "engine/particles/slot_ranges.hpp"
#include "engine/state.hpp"

namespace scarp {
namespace {

/// What one item's lists name.
class Collector {
 public:
  explicit Collector(const State& state)
      : state_(state), layout_(state.sweep.records.layout()), far_(layout_.far_record()) {}

  void begin() {
    blocks_.clear();
    driven_ = false;
  }
  void add(const kernels::NeighbourView& lists, std::int64_t cluster) {
    for (std::int64_t block = lists.soil_begin[cluster]; block < lists.soil_begin[cluster + 1];
         ++block) {
      for (std::int64_t k = 0; k < kernels::entry_block; ++k) {
        const std::uint16_t place = lists.place[block * kernels::entry_block + k];
        if (place != kernels::no_neighbour) add_record(lists.page[block] + std::int64_t{place});
      }
    }
  }
  std::span<const std::int32_t> blocks() {
    std::sort(blocks_.begin(), blocks_.end());
    return blocks_;
  }
  bool driven() const { return driven_; }

 private:
  void add_record(std::int64_t record) {
    const Boundary& boundary = state_.boundary;
    if (record < layout_[Role::owned].end()) {
      add_slot(record);
    } else if (record < layout_[Role::inner].end()) {
      note_wall(boundary.walls.wall_of(record - layout_[Role::dummy].first));
    } else if (record < far_) {
      const std::int64_t image = record - layout_[Role::image].first;
      note_wall(boundary.images.wall_of(image));
      add_slot(boundary.images.soil_of(image));
    }
  }
  void note_wall(std::size_t wall) {
    driven_ = driven_ || state_.boundary.velocity[wall] != Vec3{};
  }
  /// Neighbours in the lists mostly belong to the block before.
  void add_slot(std::int64_t slot) {
    const auto block = static_cast<std::int32_t>(slot / block_size);
    if (std::find(blocks_.rbegin(), blocks_.rend(), block) == blocks_.rend())
      blocks_.push_back(block);
  }

  const State& state_;
  const RecordLayout& layout_;
  std::int64_t far_;
  std::vector<std::int32_t> blocks_;
  bool driven_ = false;
};

/// Lists of items [0, count); collect(collector, item) adds what an item's lists name.
template <class Collect>
BlockLists collect_lists(const State& state, std::int64_t count, std::vector<std::uint8_t>& driven,
                         const Collect& collect) {
  constexpr std::int64_t chunk = 64;
  driven.assign(static_cast<std::size_t>(count), 0);
  std::vector<std::size_t> sizes(static_cast<std::size_t>(count));
  RawVector<std::int32_t> all;
  const auto append_items = [&](std::int64_t begin, std::int64_t end, auto& out) {
    Collector collector(state);
    for (std::int64_t item = begin; item < end; ++item) {
      collector.begin();
      collect(collector, item);
      const std::span<const std::int32_t> blocks = collector.blocks();
      out.insert(out.end(), blocks.begin(), blocks.end());
      sizes[static_cast<std::size_t>(item)] = blocks.size();
      driven[static_cast<std::size_t>(item)] = collector.driven() ? 1 : 0;
    }
  };
  parallel_gather(state.threads, count, chunk, all, append_items);
  return {std::move(sizes), std::move(all)};
}

}  // namespace

BlockLists::BlockLists(std::vector<std::size_t> sizes, RawVector<std::int32_t> blocks)
    : begin_(std::move(sizes)), blocks_(std::move(blocks)) {
  begin_.push_back(0);
  put_behind_each_other(begin_);
}

BlockGraph make_block_graph(const State& state) {
  BlockGraph graph;
  const std::int64_t clusters = block_size / state.kernels.cluster_size;
  const kernels::NeighbourView lists = state.neighbours.lists.view();
  graph.soil = collect_lists(state, state.particles.slots() / block_size, graph.driven,
                             [&](Collector& collector, std::int64_t block) {
                               for (std::int64_t c = 0; c < clusters; ++c)
                                 collector.add(lists, block * clusters + c);
                             });
  if (state.boundary.walls.count() == 0) return graph;
  const kernels::NeighbourView wall_lists = state.neighbours.wall_lists.view();
  const auto active = state.neighbours.wall_lists.active_clusters();
  std::vector<std::uint8_t> unused;
  graph.walls =
      collect_lists(state, std::ssize(active), unused, [&](Collector& collector, std::int64_t k) {
        collector.add(wall_lists, active[static_cast<std::size_t>(k)]);
      });
  return graph;
}

}  // namespace scarp
