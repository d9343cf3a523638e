// SPDX-License-Identifier: BSD-3-Clause
/// Square root, selection and bounds under one name for double and for vectors, so that a point
/// function written once serves the passes, the reference and the tests.
#pragma once

#include <type_traits>

#include "kernels/always_inline.hpp"

namespace scarp::kernels {

/// The same functions of a vector type and of its conditions; whoever makes a vector type
/// specialises them (`kernels/simd_math.hpp`, `kernels/lanes.hpp`).
template <class T>
struct VectorMath;
template <class Condition>
struct ConditionMath;

template <class T>
concept Vector = !std::is_arithmetic_v<T>;

SCARP_INLINE double root(double x) { return __builtin_sqrt(x); }
SCARP_INLINE double exponential(double x) { return __builtin_exp(x); }
SCARP_INLINE double choose(bool condition, double yes, double no) { return condition ? yes : no; }
SCARP_INLINE double larger(double a, double b) { return a > b ? a : b; }
SCARP_INLINE double smaller(double a, double b) { return a < b ? a : b; }
SCARP_INLINE double magnitude(double a) { return __builtin_fabs(a); }
SCARP_INLINE bool none_of(bool condition) { return !condition; }

template <Vector T>
SCARP_INLINE T root(const T& x) {
  return VectorMath<T>::root(x);
}
template <Vector T>
SCARP_INLINE T exponential(const T& x) {
  return VectorMath<T>::exponential(x);
}
template <class Condition, Vector T>
SCARP_INLINE T choose(const Condition& condition, const T& yes, const T& no) {
  return VectorMath<T>::choose(condition, yes, no);
}
template <Vector T>
SCARP_INLINE T choose(bool condition, const T& yes, const T& no) {
  return condition ? yes : no;
}
template <Vector T>
SCARP_INLINE T larger(const T& a, const T& b) {
  return VectorMath<T>::larger(a, b);
}
template <Vector T>
SCARP_INLINE T smaller(const T& a, const T& b) {
  return VectorMath<T>::smaller(a, b);
}
template <Vector T>
SCARP_INLINE T magnitude(const T& a) {
  return VectorMath<T>::magnitude(a);
}
template <Vector Condition>
SCARP_INLINE bool none_of(const Condition& condition) {
  return ConditionMath<Condition>::none_of(condition);
}

}  // namespace scarp::kernels
