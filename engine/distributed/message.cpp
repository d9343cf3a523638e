// SPDX-License-Identifier: GPL-2.0-only
/// Snapshots as bytes.
#include "engine/distributed/message.hpp"

#include <variant>

namespace scarp::distributed {

void put_snapshot(Message& message, const Snapshot& snapshot) {
  message.put(snapshot.items().size());
  for (const SnapshotItem& item : snapshot.items()) {
    message.put(std::string_view(item.name));
    message.put(std::string_view(item.unit));
    message.put(std::span<const std::size_t>(item.shape));
    message.put(item.values.index());
    std::visit(
        [&message](const auto& values) {
          using Value = typename std::decay_t<decltype(values)>::value_type;
          message.put(std::span<const Value>(values));
        },
        item.values);
  }
}

Snapshot take_snapshot_from(Message& message) {
  Snapshot snapshot;
  const auto items = message.take<std::size_t>();
  for (std::size_t k = 0; k < items; ++k) {
    SnapshotItem item;
    item.name = message.take_text();
    item.unit = message.take_text();
    item.shape = message.take_all<std::size_t>();
    switch (message.take<std::size_t>()) {
      case 0:
        item.values = message.take_all<double>();
        break;
      case 1:
        item.values = message.take_all<std::int64_t>();
        break;
      default:
        item.values = message.take_text();
    }
    snapshot.add(std::move(item));
  }
  return snapshot;
}

}  // namespace scarp::distributed
