// SPDX-License-Identifier: BSD-3-Clause
/// Who stands where among the records that pair sweeps read.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "kernels/particle_view.hpp"

namespace scarp {

/// What a particle is to a sweep: `owned` soil sums over its neighbours; `dummy` particles of walls
/// and `ghost` soil, which somebody else owns, are only neighbours, and so are mirror images and
/// the `inner` points of walls, which have no volume: only gradients are summed over them.
enum class Role : std::size_t { owned, dummy, inner, ghost, image };
inline constexpr std::size_t role_count = 5;

/// One value for each role.
template <class T>
class ByRole {
 public:
  T& operator[](Role role) { return values_[static_cast<std::size_t>(role)]; }
  const T& operator[](Role role) const { return values_[static_cast<std::size_t>(role)]; }
  auto begin() const { return values_.begin(); }
  auto end() const { return values_.end(); }

 private:
  std::array<T, role_count> values_{};
};

/// Consecutive records.
struct RecordRange {
  std::int64_t first = 0;
  std::int64_t slots = 0;  ///< with padding
  std::int64_t end() const { return first + slots; }
};

/// The records in the order of the roles, then the far record, which stands for no neighbour. Roles
/// whose number changes with every rebuild of the lists come last, so that the others stay.
class RecordLayout {
 public:
  const RecordRange& operator[](Role role) const { return ranges_[role]; }
  /// Makes room for so many; what stands behind moves.
  void resize(Role role, std::int64_t slots) {
    ranges_[role].slots = slots;
    for (std::size_t r = 1; r < role_count; ++r)
      ranges_[Role{r}].first = ranges_[Role{r - 1}].end();
  }
  std::int64_t far_record() const { return ranges_[Role::image].end(); }
  /// All records, the far one included.
  std::int64_t records() const { return far_record() + 1; }

 private:
  ByRole<RecordRange> ranges_;
};

/// First record of the page a record lies in: the blocks of neighbour lists hold records of one
/// page (kernels::NeighbourView).
inline std::int32_t page_of(std::int64_t record) {
  return static_cast<std::int32_t>(record / kernels::page_size * kernels::page_size);
}
/// Whether a record lies in the page that begins with record `page_begin`.
inline bool in_page(std::int32_t record, std::int32_t page_begin) {
  return record >= page_begin && record - page_begin < kernels::page_size;
}

}  // namespace scarp
