// SPDX-License-Identifier: BSD-3-Clause
/// The few vector operations the kernels need beyond arithmetic.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <xsimd/xsimd.hpp>

#include "kernels/always_inline.hpp"
#include "kernels/particle_view.hpp"

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

template <int Index>
inline constexpr std::integral_constant<int, Index> constant{};

/// Four consecutive values of two records, taken one at a time: that of the first record in the
/// lower, that of the second in the upper half of the lanes. Vectors of 512 and 256 bits load all
/// four and permute, for loads are scarcer than permutations.
template <class Real, class Arch>
class RecordQuad {
 public:
  SCARP_INLINE RecordQuad(const Real* low, const Real* high) : low_(low), high_(high) {}
  template <int K>
  SCARP_INLINE Batch<Real, Arch> operator()(std::integral_constant<int, K>) const {
    return [this]<int... Lane>(std::integer_sequence<int, Lane...>) SCARP_LAMBDA {
      return Batch<Real, Arch>({(Lane < cluster_size<Real, Arch> ? low_ : high_)[K]...});
    }
    (std::make_integer_sequence<int, lanes<Real, Arch>>{});
  }

 private:
  const Real *low_, *high_;
};

#ifdef __AVX2__
template <>
class RecordQuad<double, xsimd::fma3<xsimd::avx2>> {
 public:
  SCARP_INLINE RecordQuad(const double* low, const double* high)
      : first_(
            _mm256_insertf128_pd(_mm256_castpd128_pd256(_mm_load_pd(low)), _mm_load_pd(high), 1)),
        second_(_mm256_insertf128_pd(_mm256_castpd128_pd256(_mm_load_pd(low + 2)),
                                     _mm_load_pd(high + 2), 1)) {}
  template <int K>
  SCARP_INLINE Batch<double, xsimd::fma3<xsimd::avx2>> operator()(
      std::integral_constant<int, K>) const {
    return _mm256_permute_pd(K < 2 ? first_ : second_, K % 2 == 0 ? 0b0000 : 0b1111);
  }

 private:
  __m256d first_, second_;
};
template <>
class RecordQuad<float, xsimd::fma3<xsimd::avx2>> {
 public:
  SCARP_INLINE RecordQuad(const float* low, const float* high)
      : both_(
            _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_load_ps(low)), _mm_load_ps(high), 1)) {}
  template <int K>
  SCARP_INLINE Batch<float, xsimd::fma3<xsimd::avx2>> operator()(
      std::integral_constant<int, K>) const {
    return _mm256_permute_ps(both_, K * 0b01010101);
  }

 private:
  __m256 both_;
};
#endif
#ifdef __AVX512F__
template <>
class RecordQuad<double, xsimd::avx512bw> {
 public:
  SCARP_INLINE RecordQuad(const double* low, const double* high)
      : both_(_mm512_insertf64x4(_mm512_castpd256_pd512(_mm256_load_pd(low)), _mm256_load_pd(high),
                                 1)) {}
  template <int K>
  SCARP_INLINE Batch<double, xsimd::avx512bw> operator()(std::integral_constant<int, K>) const {
    return _mm512_permutex_pd(both_, K * 0b01010101);
  }

 private:
  __m512d both_;
};
template <>
class RecordQuad<float, xsimd::avx512bw> {
 public:
  SCARP_INLINE RecordQuad(const float* low, const float* high)
      : both_(_mm512_mask_broadcast_f32x4(_mm512_broadcast_f32x4(_mm_load_ps(low)), 0xFF00,
                                          _mm_load_ps(high))) {}
  template <int K>
  SCARP_INLINE Batch<float, xsimd::avx512bw> operator()(std::integral_constant<int, K>) const {
    return _mm512_permute_ps(both_, K * 0b01010101);
  }

 private:
  __m512 both_;
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
