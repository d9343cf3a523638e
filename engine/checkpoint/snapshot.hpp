// SPDX-License-Identifier: BSD-3-Clause
/// The complete state of a run as plain named arrays.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace scarp {

/// One array with its name ("fields/position"), unit ("m"; empty: a count or a word) and extent.
struct SnapshotItem {
  using Values = std::variant<std::vector<double>, std::vector<std::int64_t>, std::string>;

  std::string name;
  std::string unit;
  std::vector<std::size_t> shape;  ///< the last index runs fastest; of a text its length
  Values values;
};

/// What `Simulation::snapshot()` leaves and a Simulation can be made from; writers of outputs add
/// how far they have come. `engine/output/FORMATS.md` lists the items.
class Snapshot {
 public:
  void add(SnapshotItem item) { items_.push_back(std::move(item)); }
  void add(std::string name, std::string unit, std::vector<double> values);
  void add(std::string name, std::vector<std::int64_t> values);
  void add(std::string name, std::string text);

  const std::vector<SnapshotItem>& items() const { return items_; }
  /// All items, of which nothing stays behind: who writes them can let go of one after the other.
  std::vector<SnapshotItem> release() { return std::exchange(items_, {}); }
  bool has(std::string_view name) const { return find(name) != nullptr; }
  /// Errors, of all below: CheckpointError if the item is missing or of another type or size.
  const std::vector<double>& numbers(std::string_view name, std::size_t count) const;
  const std::vector<double>& numbers(std::string_view name) const;
  const std::vector<std::int64_t>& integers(std::string_view name, std::size_t count) const;
  const std::vector<std::int64_t>& integers(std::string_view name) const;
  const std::string& text(std::string_view name) const;

 private:
  const SnapshotItem* find(std::string_view name) const;
  template <class Values>
  const Values& get(std::string_view name) const;

  std::vector<SnapshotItem> items_;
};

}  // namespace scarp
