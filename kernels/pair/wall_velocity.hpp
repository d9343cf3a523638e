// SPDX-License-Identifier: BSD-3-Clause
/// Relative velocity of a soil particle and a dummy particle of a wall.
#pragma once

#include "kernels/pair/pair_geometry.hpp"

namespace scarp::kernels {

/// Equation: B1; v_i - v_j becomes beta (v_i - v_wall), beta = min(1.5, 1 + d_wall/d_i): the
/// velocity a dummy would have if it fell linearly to the wall's at its face, limited because more
/// throws single grains near the face. Source: Bui et al. (2008); the limit is from
/// kernels/EQUATIONS.md.
template <class B, int Dim, class Real>
SCARP_INLINE void wall_velocity(const B (&normal)[Dim], const B& distance,
                                const PairGeometry<B, Dim>& pair, PairMotion<B, Dim>& motion) {
  B along(Real(0));
  unrolled<Dim>([&](auto a) SCARP_LAMBDA { along = xsimd::fma(pair.offset[a], normal[a], along); });
  // d_i = along - distance; below 2 d_wall the limit rules, so this bound only keeps the division
  // finite.
  const B distance_i = xsimd::max(along - distance, distance);
  const B beta = xsimd::min(B(Real(1.5)), xsimd::fma(distance, inverse(distance_i), B(Real(1))));
  unrolled<Dim>([&](auto a) SCARP_LAMBDA { motion.velocity[a] = beta * motion.velocity[a]; });
}

}  // namespace scarp::kernels
