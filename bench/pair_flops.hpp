// SPDX-License-Identifier: BSD-3-Clause
/// Work of a pair sweep per true pair, counted from the pair terms in `kernels/pair/`.
#pragma once

#include "kernels/isa/kernel_table.hpp"

namespace scarp::bench {

/// Flops of one pair: a multiply-add counts 2, square root and division 1 each, maximum, minimum
/// and selection 0. The artificial stress counts where it is at work, which depends on the state.
/// 97 for all terms in 3D without correction and diffusion, 143 with the artificial stress.
inline int pair_flops(const kernels::SweepVariant& variant) {
  const int d = variant.dimension, components = d == 2 ? 4 : 6;
  const bool gradient = variant.terms != kernels::Terms::force;
  const bool force = variant.terms != kernels::Terms::gradient;
  const bool viscosity = force && variant.viscosity;
  const bool diffusion = gradient && variant.diffusion;
  int flops = 3 * d + 16;     // offset, 1/r, slope of W, V_j grad W / r
  if (viscosity) flops += 4;  // regularised denominator and densities
  if (diffusion) flops += 2;  // regularised denominator, or with viscosity its densities
  flops += 2 * d;             // relative velocity, V_j grad W
  const bool continuity = gradient && variant.continuity;
  if (continuity || viscosity) flops += 2 * d - 1;           // approach
  if (continuity) flops += 3;                                // density rate
  if (gradient) flops += 2 * d * d;                          // velocity gradient
  if (gradient && variant.correction) flops += d * (d + 1);  // moment
  if (diffusion) flops += 7 + 2 * components + 2 * d;        // stress diffusion
  if (force) flops += d + 2 * d * d;                         // momentum
  if (viscosity) flops += 9 + 2 * d;
  if (force && variant.artificial_stress) flops += 28 + 2 * d + d * (d + 1);
  return flops;
}

}  // namespace scarp::bench
