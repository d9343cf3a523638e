// SPDX-License-Identifier: BSD-3-Clause
/// How the stress turns with the material: the Jaumann rate of the paper, or an exact rotation.
#pragma once

#include "kernels/tensor.hpp"

namespace scarp::kernels {

/// Equation: E15, E17; the two first terms of E18, w sigma + sigma w^T = w sigma - sigma w. Grows
/// the stress by O((w dt)^2) a step.
template <class T>
SCARP_TENSOR SymTensor<T> jaumann_rate(const SymTensor<T>& s, const Spin<T>& w) {
  const T two(2.0);
  return {two * (w.xy * s.xy - w.zx * s.zx),
          two * (w.yz * s.yz - w.xy * s.xy),
          two * (w.zx * s.zx - w.yz * s.yz),
          w.xy * (s.yy - s.xx) + w.yz * s.zx - w.zx * s.yz,
          w.yz * (s.zz - s.yy) + w.zx * s.xy - w.xy * s.zx,
          w.zx * (s.xx - s.zz) + w.xy * s.yz - w.yz * s.xy};
}

/// Equation: R1; Hughes & Winget (1980): Q = (I - w dt/2)^-1 (I + w dt/2), exactly orthogonal.
template <class T>
SCARP_TENSOR Tensor<T> hughes_winget_rotation(const Spin<T>& w, const T& dt) {
  // With half-angle vector a (axial vector of w dt/2): Q = I + 2/(1 + a.a) (A + A A), A = w dt/2.
  const T half = T(0.5) * dt;
  const T xy = half * w.xy, yz = half * w.yz, zx = half * w.zx;
  const T scale = T(2.0) / (T(1.0) + xy * xy + yz * yz + zx * zx);
  const T one(1.0);
  Tensor<T> q;
  q.m[0][0] = one - scale * (xy * xy + zx * zx);
  q.m[1][1] = one - scale * (xy * xy + yz * yz);
  q.m[2][2] = one - scale * (yz * yz + zx * zx);
  q.m[0][1] = scale * (xy + yz * zx);
  q.m[1][0] = scale * (yz * zx - xy);
  q.m[1][2] = scale * (yz + xy * zx);
  q.m[2][1] = scale * (xy * zx - yz);
  q.m[2][0] = scale * (zx + xy * yz);
  q.m[0][2] = scale * (xy * yz - zx);
  return q;
}

}  // namespace scarp::kernels
