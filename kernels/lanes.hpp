// SPDX-License-Identifier: BSD-3-Clause
/// Eight doubles side by side in plain C++, with which a program outside the library compiles the
/// stress pass of a model of its own: no vector library, whatever instructions it is compiled for.
#pragma once

#include <cstddef>
#include <cstdint>

#include "kernels/point_math.hpp"

namespace scarp::kernels {

struct LaneMask {
  using Native [[gnu::vector_size(64)]] = std::int64_t;
  Native bits;
  friend SCARP_INLINE LaneMask operator&(const LaneMask& a, const LaneMask& b) {
    return {a.bits & b.bits};
  }
  friend SCARP_INLINE LaneMask operator|(const LaneMask& a, const LaneMask& b) {
    return {a.bits | b.bits};
  }
  friend SCARP_INLINE LaneMask operator!(const LaneMask& a) { return {~a.bits}; }
};

struct Lanes {
  using Native [[gnu::vector_size(64)]] = double;
  static constexpr std::size_t size = 8;

  Native value;

  Lanes() = default;
  SCARP_INLINE Lanes(const Native& v) : value(v) {}
  SCARP_INLINE Lanes(double x) : value{x, x, x, x, x, x, x, x} {}
  static SCARP_INLINE Lanes load_aligned(const double* from) {
    return *reinterpret_cast<const Aliasing*>(from);
  }
  SCARP_INLINE void store_aligned(double* to) const { *reinterpret_cast<Aliasing*>(to) = value; }

  friend SCARP_INLINE Lanes operator+(const Lanes& a, const Lanes& b) { return a.value + b.value; }
  friend SCARP_INLINE Lanes operator-(const Lanes& a, const Lanes& b) { return a.value - b.value; }
  friend SCARP_INLINE Lanes operator*(const Lanes& a, const Lanes& b) { return a.value * b.value; }
  friend SCARP_INLINE Lanes operator/(const Lanes& a, const Lanes& b) { return a.value / b.value; }
  friend SCARP_INLINE Lanes operator-(const Lanes& a) { return -a.value; }
  friend SCARP_INLINE LaneMask operator>(const Lanes& a, const Lanes& b) {
    return {a.value > b.value};
  }
  friend SCARP_INLINE LaneMask operator>=(const Lanes& a, const Lanes& b) {
    return {a.value >= b.value};
  }
  friend SCARP_INLINE LaneMask operator<(const Lanes& a, const Lanes& b) {
    return {a.value < b.value};
  }
  friend SCARP_INLINE LaneMask operator<=(const Lanes& a, const Lanes& b) {
    return {a.value <= b.value};
  }
  friend SCARP_INLINE LaneMask operator!=(const Lanes& a, const Lanes& b) {
    return {a.value != b.value};
  }

 private:
  using Aliasing [[gnu::vector_size(64), gnu::may_alias]] = double;
};

template <>
struct VectorMath<Lanes> {
  template <class F>
  static SCARP_INLINE Lanes each(const Lanes& x, F&& f) {
    Lanes result;
    for (std::size_t k = 0; k < Lanes::size; ++k) result.value[k] = f(double(x.value[k]));
    return result;
  }
  static SCARP_INLINE Lanes choose(const LaneMask& condition, const Lanes& yes, const Lanes& no) {
    return condition.bits ? yes.value : no.value;
  }
  static SCARP_INLINE Lanes larger(const Lanes& a, const Lanes& b) { return choose(a > b, a, b); }
  static SCARP_INLINE Lanes smaller(const Lanes& a, const Lanes& b) { return choose(a < b, a, b); }
  static SCARP_INLINE Lanes magnitude(const Lanes& a) { return larger(a, -a); }
  static SCARP_INLINE Lanes root(const Lanes& x) {
    return each(x, [](double one) { return __builtin_sqrt(one); });
  }
  static SCARP_INLINE Lanes exponential(const Lanes& x) {
    return each(x, [](double one) { return __builtin_exp(one); });
  }
};

template <>
struct ConditionMath<LaneMask> {
  static SCARP_INLINE bool none_of(const LaneMask& condition) {
    std::int64_t any = 0;
    for (std::size_t k = 0; k < Lanes::size; ++k) any |= condition.bits[k];
    return any == 0;
  }
};

}  // namespace scarp::kernels
