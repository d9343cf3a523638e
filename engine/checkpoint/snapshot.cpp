// SPDX-License-Identifier: BSD-3-Clause
/// Named arrays, looked up with their type and size.
#include "engine/checkpoint/snapshot.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "engine/errors.hpp"

namespace scarp {
namespace {

template <class Values>
const Values& of_size(const Values& values, std::string_view name, std::size_t count) {
  if (values.size() != count) {
    throw CheckpointError(fmt::format(
        "'{}' has {} values where the scene needs {}. Try the scene and the program that wrote it.",
        name, values.size(), count));
  }
  return values;
}

}  // namespace

void Snapshot::add(std::string name, std::string unit, std::vector<double> values) {
  const std::size_t count = values.size();
  items_.push_back({std::move(name), std::move(unit), {count}, std::move(values)});
}
void Snapshot::add(std::string name, std::vector<std::int64_t> values) {
  const std::size_t count = values.size();
  items_.push_back({std::move(name), "", {count}, std::move(values)});
}
void Snapshot::add(std::string name, std::string text) {
  const std::size_t count = text.size();
  items_.push_back({std::move(name), "", {count}, std::move(text)});
}

const SnapshotItem* Snapshot::find(std::string_view name) const {
  const auto found = std::find_if(items_.begin(), items_.end(),
                                  [&](const SnapshotItem& item) { return item.name == name; });
  return found == items_.end() ? nullptr : &*found;
}

template <class Values>
const Values& Snapshot::get(std::string_view name) const {
  const SnapshotItem* item = find(name);
  const Values* values = item != nullptr ? std::get_if<Values>(&item->values) : nullptr;
  if (values == nullptr) {
    throw CheckpointError(
        fmt::format("'{}' {}. Try the scene and the program that wrote it.", name,
                    item == nullptr ? "is not there" : "is not of the type expected"));
  }
  return *values;
}

const std::vector<double>& Snapshot::numbers(std::string_view name) const {
  return get<std::vector<double>>(name);
}
const std::vector<double>& Snapshot::numbers(std::string_view name, std::size_t count) const {
  return of_size(numbers(name), name, count);
}
const std::vector<std::int64_t>& Snapshot::integers(std::string_view name) const {
  return get<std::vector<std::int64_t>>(name);
}
const std::vector<std::int64_t>& Snapshot::integers(std::string_view name,
                                                    std::size_t count) const {
  return of_size(integers(name), name, count);
}
const std::string& Snapshot::text(std::string_view name) const { return get<std::string>(name); }

}  // namespace scarp
