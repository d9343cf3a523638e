// SPDX-License-Identifier: BSD-3-Clause
/// Vectors whose storage starts on a cache line, with and without a value for each new element.
#pragma once

#include <cstddef>
#include <new>
#include <utility>
#include <vector>

namespace scarp {

template <class T>
struct CacheLineAllocator {
  using value_type = T;
  static constexpr std::align_val_t alignment{64};

  CacheLineAllocator() = default;
  template <class U>
  CacheLineAllocator(const CacheLineAllocator<U>&) {}
  T* allocate(std::size_t count) {
    return static_cast<T*>(::operator new(count * sizeof(T), alignment));
  }
  void deallocate(T* p, std::size_t) { ::operator delete(p, alignment); }
  template <class U>
  bool operator==(const CacheLineAllocator<U>&) const {
    return true;
  }
};

template <class T>
using AlignedVector = std::vector<T, CacheLineAllocator<T>>;

/// Leaves what has no value of its own without one.
template <class T>
struct RawAllocator : CacheLineAllocator<T> {
  RawAllocator() = default;
  template <class U>
  RawAllocator(const RawAllocator<U>&) {}
  template <class U>
  void construct(U* p) {
    ::new (static_cast<void*>(p)) U;
  }
  template <class U, class... Values>
  void construct(U* p, Values&&... values) {
    ::new (static_cast<void*>(p)) U(std::forward<Values>(values)...);
  }
};

/// For what threads fill in together: `resize` does not go over the memory, which one thread would
/// have to.
template <class T>
using RawVector = std::vector<T, RawAllocator<T>>;

}  // namespace scarp
