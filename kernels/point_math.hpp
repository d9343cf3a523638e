// SPDX-License-Identifier: BSD-3-Clause
/// Square root, selection and bounds under one name for double and for vectors, so that a point
/// function written once serves the passes, the reference and the tests.
#pragma once

#include <cmath>

#include "kernels/simd.hpp"

namespace scarp::kernels {

SCARP_INLINE double root(double x) { return __builtin_sqrt(x); }
SCARP_INLINE double choose(bool condition, double yes, double no) { return condition ? yes : no; }
SCARP_INLINE double larger(double a, double b) { return a > b ? a : b; }
SCARP_INLINE double smaller(double a, double b) { return a < b ? a : b; }
SCARP_INLINE double magnitude(double a) { return __builtin_fabs(a); }
SCARP_INLINE bool none_of(bool condition) { return !condition; }

template <class A>
SCARP_INLINE Batch<double, A> root(const Batch<double, A>& x) {
  return xsimd::sqrt(x);
}
template <class A>
SCARP_INLINE Batch<double, A> choose(const xsimd::batch_bool<double, A>& condition,
                                     const Batch<double, A>& yes, const Batch<double, A>& no) {
  return xsimd::select(condition, yes, no);
}
template <class A>
SCARP_INLINE Batch<double, A> larger(const Batch<double, A>& a, const Batch<double, A>& b) {
  return xsimd::max(a, b);
}
template <class A>
SCARP_INLINE Batch<double, A> smaller(const Batch<double, A>& a, const Batch<double, A>& b) {
  return xsimd::min(a, b);
}
template <class A>
SCARP_INLINE Batch<double, A> magnitude(const Batch<double, A>& a) {
  return xsimd::abs(a);
}
template <class A>
SCARP_INLINE bool none_of(const xsimd::batch_bool<double, A>& condition) {
  return !xsimd::any(condition);
}

}  // namespace scarp::kernels
