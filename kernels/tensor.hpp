// SPDX-License-Identifier: BSD-3-Clause
/// Small tensors of scalars or vectors (`T` is double or a batch), for the per-particle passes.
#pragma once

namespace scarp::kernels {

#define SCARP_TENSOR inline __attribute__((always_inline))

template <class T>
struct SymTensor {
  T xx, yy, zz, xy, yz, zx;
};
template <class T>
struct Tensor {
  T m[3][3];
};

template <class T>
SCARP_TENSOR SymTensor<T> operator+(const SymTensor<T>& a, const SymTensor<T>& b) {
  return {a.xx + b.xx, a.yy + b.yy, a.zz + b.zz, a.xy + b.xy, a.yz + b.yz, a.zx + b.zx};
}
template <class T>
SCARP_TENSOR SymTensor<T> operator-(const SymTensor<T>& a, const SymTensor<T>& b) {
  return {a.xx - b.xx, a.yy - b.yy, a.zz - b.zz, a.xy - b.xy, a.yz - b.yz, a.zx - b.zx};
}
template <class T>
SCARP_TENSOR SymTensor<T> operator*(const T& f, const SymTensor<T>& a) {
  return {f * a.xx, f * a.yy, f * a.zz, f * a.xy, f * a.yz, f * a.zx};
}
template <class T>
SCARP_TENSOR T trace(const SymTensor<T>& a) {
  return a.xx + a.yy + a.zz;
}
template <class T>
SCARP_TENSOR T contract(const SymTensor<T>& a, const SymTensor<T>& b) {
  return a.xx * b.xx + a.yy * b.yy + a.zz * b.zz +
         T(2.0) * (a.xy * b.xy + a.yz * b.yz + a.zx * b.zx);
}
template <class T>
SCARP_TENSOR SymTensor<T> deviator(const SymTensor<T>& a) {
  const T mean = trace(a) * T(1.0 / 3.0);
  return {a.xx - mean, a.yy - mean, a.zz - mean, a.xy, a.yz, a.zx};
}
/// Inverse of a symmetric tensor; 2D sets the third row and column to (0, 0, 1). That of zero,
/// which padding has, is zero. Pre: every other one has an inverse.
template <class T>
SCARP_TENSOR SymTensor<T> inverse_of(const SymTensor<T>& m) {
  const T cxx = m.yy * m.zz - m.yz * m.yz, cxy = m.zx * m.yz - m.xy * m.zz,
          czx = m.xy * m.yz - m.zx * m.yy;
  const T scale = T(1.0) / (m.xx * cxx + m.xy * cxy + m.zx * czx + T(1e-300));
  return scale * SymTensor<T>{cxx, m.xx * m.zz - m.zx * m.zx, m.xx * m.yy - m.xy * m.xy,
                              cxy, m.xy * m.zx - m.xx * m.yz, czx};
}
template <class T>
SCARP_TENSOR SymTensor<T> isotropic(const T& value) {
  return {value, value, value, T(0.0), T(0.0), T(0.0)};
}
template <class T>
SCARP_TENSOR SymTensor<T> symmetric_part(const Tensor<T>& a) {
  const T half(0.5);
  return {a.m[0][0],
          a.m[1][1],
          a.m[2][2],
          half * (a.m[0][1] + a.m[1][0]),
          half * (a.m[1][2] + a.m[2][1]),
          half * (a.m[2][0] + a.m[0][2])};
}
/// Axial components of the antisymmetric part: w = {w_yz, w_zx, w_xy}, w_ab = (a_ab - a_ba)/2.
template <class T>
struct Spin {
  T yz, zx, xy;
};
template <class T>
SCARP_TENSOR Spin<T> antisymmetric_part(const Tensor<T>& a) {
  const T half(0.5);
  return {half * (a.m[1][2] - a.m[2][1]), half * (a.m[2][0] - a.m[0][2]),
          half * (a.m[0][1] - a.m[1][0])};
}
/// Q t Q^T.
template <class T>
SCARP_TENSOR Tensor<T> rotated(const Tensor<T>& t, const Tensor<T>& q) {
  Tensor<T> product, out;
  for (int a = 0; a < 3; ++a) {
    for (int b = 0; b < 3; ++b) {
      product.m[a][b] = q.m[a][0] * t.m[0][b] + q.m[a][1] * t.m[1][b] + q.m[a][2] * t.m[2][b];
    }
  }
  for (int a = 0; a < 3; ++a) {
    for (int b = 0; b < 3; ++b) {
      out.m[a][b] =
          product.m[a][0] * q.m[b][0] + product.m[a][1] * q.m[b][1] + product.m[a][2] * q.m[b][2];
    }
  }
  return out;
}
/// Q s Q^T.
template <class T>
SCARP_TENSOR SymTensor<T> rotated(const SymTensor<T>& s, const Tensor<T>& q) {
  const T full[3][3] = {{s.xx, s.xy, s.zx}, {s.xy, s.yy, s.yz}, {s.zx, s.yz, s.zz}};
  T product[3][3];
  for (int a = 0; a < 3; ++a) {
    for (int b = 0; b < 3; ++b) {
      product[a][b] = q.m[a][0] * full[0][b] + q.m[a][1] * full[1][b] + q.m[a][2] * full[2][b];
    }
  }
  const auto entry = [&](int a, int b) {
    return product[a][0] * q.m[b][0] + product[a][1] * q.m[b][1] + product[a][2] * q.m[b][2];
  };
  return {entry(0, 0), entry(1, 1), entry(2, 2), entry(0, 1), entry(1, 2), entry(2, 0)};
}

}  // namespace scarp::kernels
