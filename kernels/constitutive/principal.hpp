// SPDX-License-Identifier: BSD-3-Clause
/// Principal stresses and directions of a point, in order.
#pragma once

#include "kernels/point_math.hpp"
#include "kernels/tensor.hpp"

namespace scarp::kernels {

/// value[0] >= value[1] >= value[2]; axis[k] is the unit vector of value[k].
template <class T>
struct Principal {
  T value[3];
  T axis[3][3];
};

/// Rotates the plane of axes p and q so that the entry m[p][q] becomes 0. Where it is 0 nothing
/// changes.
template <class T>
SCARP_INLINE void rotate_plane(T (&m)[3][3], T (&axis)[3][3], int p, int q) {
  const T zero(0.0), one(1.0), two(2.0), tiny(1e-300);
  const int r = 3 - p - q;
  const T off = m[p][q], gap = m[q][q] - m[p][p];
  const T reach = root(gap * gap + two * off * (two * off));
  const T below = choose(gap < zero, gap - reach, gap + reach);
  const T tangent = two * off / choose(magnitude(below) > tiny, below, one);
  const T cosine = one / root(one + tangent * tangent), sine = tangent * cosine;
  m[p][p] = m[p][p] - tangent * off;
  m[q][q] = m[q][q] + tangent * off;
  m[p][q] = m[q][p] = zero;
  const T rp = m[r][p], rq = m[r][q];
  m[r][p] = m[p][r] = cosine * rp - sine * rq;
  m[r][q] = m[q][r] = sine * rp + cosine * rq;
  for (int a = 0; a < 3; ++a) {
    const T ap = axis[p][a], aq = axis[q][a];
    axis[p][a] = cosine * ap - sine * aq;
    axis[q][a] = sine * ap + cosine * aq;
  }
}

/// Puts the greater of two neighbours first.
template <class T>
SCARP_INLINE void put_in_order(Principal<T>& s, int first) {
  const auto wrong = s.value[first] < s.value[first + 1];
  const auto exchange = [&](T& a, T& b) SCARP_LAMBDA {
    const T kept = a;
    a = choose(wrong, b, a);
    b = choose(wrong, kept, b);
  };
  exchange(s.value[first], s.value[first + 1]);
  for (int a = 0; a < 3; ++a) exchange(s.axis[first][a], s.axis[first + 1][a]);
}

/// By Jacobi's rotations, which stay exact where values are equal; in plane strain one is enough.
/// Accuracy: a few ulp of the largest entry.
template <class T>
SCARP_INLINE Principal<T> principal(const SymTensor<T>& s) {
  const T zero(0.0), one(1.0);
  T m[3][3] = {{s.xx, s.xy, s.zx}, {s.xy, s.yy, s.yz}, {s.zx, s.yz, s.zz}};
  Principal<T> out{{zero, zero, zero}, {{one, zero, zero}, {zero, one, zero}, {zero, zero, one}}};
  // Sweeps converge quadratically; after the fifth nothing is left beyond rounding.
  constexpr int most_sweeps = 8;
  const T small = T(1e-34) * contract(s, s);
  for (int sweep = 0; sweep < most_sweeps; ++sweep) {
    rotate_plane(m, out.axis, 0, 1);
    const T left = m[0][2] * m[0][2] + m[1][2] * m[1][2];
    if (none_of(left > small)) break;
    rotate_plane(m, out.axis, 0, 2);
    rotate_plane(m, out.axis, 1, 2);
  }
  for (int k = 0; k < 3; ++k) out.value[k] = m[k][k];
  put_in_order(out, 0);
  put_in_order(out, 1);
  put_in_order(out, 0);
  return out;
}

/// The tensor with these values along the axes of `s`.
template <class T>
SCARP_INLINE SymTensor<T> along_axes(const Principal<T>& s, const T (&value)[3]) {
  SymTensor<T> sum = isotropic(T(0.0));
  for (int k = 0; k < 3; ++k) {
    const T(&n)[3] = s.axis[k];
    sum = sum + value[k] * SymTensor<T>{n[0] * n[0], n[1] * n[1], n[2] * n[2],
                                        n[0] * n[1], n[1] * n[2], n[2] * n[0]};
  }
  return sum;
}

}  // namespace scarp::kernels
