// SPDX-License-Identifier: BSD-3-Clause
/// Functions that sources of different instruction sets share must leave no symbol behind: the
/// linker would keep the copy of one of them for all.
#pragma once

#define SCARP_INLINE inline __attribute__((always_inline))
#define SCARP_LAMBDA __attribute__((always_inline))
