// SPDX-License-Identifier: GPL-2.0-only
/// Texts, numbers and snapshots as bytes, from one process to others.
#pragma once

#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "engine/checkpoint/snapshot.hpp"

namespace scarp::distributed {

class Message {
 public:
  Message() = default;
  explicit Message(std::vector<char> bytes) : bytes_(std::move(bytes)) {}
  const std::vector<char>& bytes() const { return bytes_; }

  template <class T>
  void put(std::span<const T> values) {
    static_assert(std::is_trivially_copyable_v<T>);
    const std::size_t count = values.size();
    add(&count, sizeof count);
    add(values.data(), values.size_bytes());
  }
  template <class T>
  void put(const T& value) {
    put(std::span<const T>(&value, 1));
  }
  void put(std::string_view text) { put(std::span<const char>(text)); }

  /// In the order of `put`.
  template <class T>
  std::vector<T> take_all() {
    std::size_t count = 0;
    get(&count, sizeof count);
    std::vector<T> values(count);
    get(values.data(), count * sizeof(T));
    return values;
  }
  template <class T>
  T take() {
    return take_all<T>().at(0);
  }
  std::string take_text() {
    const std::vector<char> text = take_all<char>();
    return {text.begin(), text.end()};
  }

 private:
  void add(const void* from, std::size_t size) {
    if (size == 0) return;
    const std::size_t end = bytes_.size();
    bytes_.resize(end + size);
    std::memcpy(bytes_.data() + end, from, size);
  }
  void get(void* to, std::size_t size) {
    if (size > 0) std::memcpy(to, bytes_.data() + next_, size);
    next_ += size;
  }

  std::vector<char> bytes_;
  std::size_t next_ = 0;
};

void put_snapshot(Message& message, const Snapshot& snapshot);
Snapshot take_snapshot_from(Message& message);

}  // namespace scarp::distributed
