// SPDX-License-Identifier: BSD-3-Clause
/// The functions of `kernels/point_math.hpp` for the vectors of an instruction set.
#pragma once

#include "kernels/point_math.hpp"
#include "kernels/simd.hpp"

namespace scarp::kernels {

template <class A>
struct VectorMath<Batch<double, A>> {
  using T = Batch<double, A>;
  static SCARP_INLINE T root(const T& x) { return xsimd::sqrt(x); }
  static SCARP_INLINE T exponential(const T& x) { return xsimd::exp(x); }
  static SCARP_INLINE T choose(const xsimd::batch_bool<double, A>& condition, const T& yes,
                               const T& no) {
    return xsimd::select(condition, yes, no);
  }
  static SCARP_INLINE T larger(const T& a, const T& b) { return xsimd::max(a, b); }
  static SCARP_INLINE T smaller(const T& a, const T& b) { return xsimd::min(a, b); }
  static SCARP_INLINE T magnitude(const T& a) { return xsimd::abs(a); }
};

template <class A>
struct ConditionMath<xsimd::batch_bool<double, A>> {
  static SCARP_INLINE bool none_of(const xsimd::batch_bool<double, A>& condition) {
    return !xsimd::any(condition);
  }
};

}  // namespace scarp::kernels
