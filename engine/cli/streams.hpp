// SPDX-License-Identifier: BSD-3-Clause
/// The standard streams of a program whose work matters more than what it says meanwhile.
#pragma once

#include <string>

namespace scarp::cli {

/// From here on no write to stdout or stderr fails or throws: what standard error does not take is
/// dropped, and what standard output does not take is remembered for `output_problem`. Closed
/// standard descriptors are opened on the null device, lest the next file get their number and what
/// is printed with it. Call it first in main.
void take_standard_streams();

/// Flushes standard output. Why some of it was lost, in words; empty: all of it went through.
std::string output_problem();

}  // namespace scarp::cli
