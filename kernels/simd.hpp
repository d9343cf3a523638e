// SPDX-License-Identifier: BSD-3-Clause
/// The few vector operations the kernels need beyond arithmetic.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <xsimd/xsimd.hpp>

#include "kernels/particle_view.hpp"

#define SCARP_INLINE inline __attribute__((always_inline))
#define SCARP_LAMBDA __attribute__((always_inline))

namespace scarp::kernels {

/// Calls f(0), f(1), ... f(Count - 1) with compile-time indices: arrays of vectors indexed this way
/// stay in registers, which the compiler's own unrolling comes too late for.
template <int Count, class F>
SCARP_INLINE void unrolled(F&& f) {
  [&]<int... I>(std::integer_sequence<int, I...>) SCARP_LAMBDA {
    (f(std::integral_constant<int, I>{}), ...);
  }
  (std::make_integer_sequence<int, Count>{});
}

template <class Real, class Arch>
using Batch = xsimd::batch<Real, Arch>;

/// Lanes of a vector, and the particles of a cluster: half as many, so that one vector holds a
/// whole cluster against two list entries.
template <class Real, class Arch>
inline constexpr int lanes = static_cast<int>(Batch<Real, Arch>::size);
template <class Real, class Arch>
inline constexpr int cluster_size = lanes<Real, Arch> / 2;

/// Puts one value in the lower and another in the upper half of the lanes.
template <class Real, class Arch>
struct HalfSelect {
  typename Batch<Real, Arch>::batch_bool_type upper;

  SCARP_INLINE HalfSelect() {
    alignas(64) Real index[lanes<Real, Arch>];
    for (int l = 0; l < lanes<Real, Arch>; ++l) index[l] = static_cast<Real>(l);
    upper = Batch<Real, Arch>::load_aligned(index) >= Batch<Real, Arch>(cluster_size<Real, Arch>);
  }
  SCARP_INLINE Batch<Real, Arch> operator()(const Real* low, const Real* high) const {
    return xsimd::select(upper, Batch<Real, Arch>(*high), Batch<Real, Arch>(*low));
  }
};

#ifdef __AVX512F__
/// AVX-512 merges a broadcast load under a mask: one instruction less a value than the general
/// form.
template <>
struct HalfSelect<double, xsimd::avx512bw> {
  SCARP_INLINE Batch<double, xsimd::avx512bw> operator()(const double* low,
                                                         const double* high) const {
    return _mm512_mask_broadcastsd_pd(_mm512_set1_pd(*low), 0xF0, _mm_load_sd(high));
  }
};
template <>
struct HalfSelect<float, xsimd::avx512bw> {
  SCARP_INLINE Batch<float, xsimd::avx512bw> operator()(const float* low, const float* high) const {
    return _mm512_mask_broadcastss_ps(_mm512_set1_ps(*low), 0xFF00, _mm_load_ss(high));
  }
};
#endif

/// Difference of two record positions in units of h. Accuracy: exact for the positions stored.
template <class Arch>
SCARP_INLINE Batch<double, Arch> position_difference(const Batch<double, Arch>& a,
                                                     const Batch<double, Arch>& b) {
  return a - b;
}
template <class Arch>
SCARP_INLINE Batch<float, Arch> position_difference(const Batch<float, Arch>& a,
                                                    const Batch<float, Arch>& b) {
  using Integers = Batch<std::int32_t, Arch>;
  const Integers steps = xsimd::bitwise_cast<Integers>(a) - xsimd::bitwise_cast<Integers>(b);
  return xsimd::to_float(steps) * Batch<float, Arch>(static_cast<float>(position_step));
}

/// 1/sqrt(x), accurate to a few ulp. Pre: x is finite and normal.
template <class Real, class Arch>
SCARP_INLINE Batch<Real, Arch> inverse_sqrt(const Batch<Real, Arch>& x) {
  return Batch<Real, Arch>(Real(1)) / xsimd::sqrt(x);
}
/// 1/x, accurate to a few ulp. Pre: x is finite and normal.
template <class Real, class Arch>
SCARP_INLINE Batch<Real, Arch> inverse(const Batch<Real, Arch>& x) {
  return Batch<Real, Arch>(Real(1)) / x;
}

#ifdef __AVX512F__
/// One step of fourth order from the 14-bit estimate: y (1 + e/2 + 3 e^2/8 + 5 e^3/16), e = 1 - x
/// y^2, leaves 2^-54. On cores whose 512-bit square root and division take 40 cycles together, the
/// sweep would wait for the divider; the division that is left keeps it busy while the multipliers
/// work.
SCARP_INLINE Batch<double, xsimd::avx512bw> inverse_sqrt(const Batch<double, xsimd::avx512bw>& x) {
  const __m512d y = _mm512_rsqrt14_pd(x);
  const __m512d e = _mm512_fnmadd_pd(_mm512_mul_pd(x, y), y, _mm512_set1_pd(1.0));
  const __m512d inner = _mm512_fmadd_pd(e, _mm512_set1_pd(0.3125), _mm512_set1_pd(0.375));
  return _mm512_fmadd_pd(_mm512_mul_pd(y, e), _mm512_fmadd_pd(e, inner, _mm512_set1_pd(0.5)), y);
}
/// One step of second order from the 14-bit estimate leaves 2^-27.
SCARP_INLINE Batch<float, xsimd::avx512bw> inverse_sqrt(const Batch<float, xsimd::avx512bw>& x) {
  const __m512 y = _mm512_rsqrt14_ps(x);
  const __m512 e = _mm512_fnmadd_ps(_mm512_mul_ps(x, y), y, _mm512_set1_ps(1.0f));
  return _mm512_fmadd_ps(_mm512_mul_ps(y, e), _mm512_set1_ps(0.5f), y);
}
#endif

}  // namespace scarp::kernels
