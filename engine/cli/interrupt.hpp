// SPDX-License-Identifier: BSD-3-Clause
/// An interrupt from the keyboard or a job system ends a run with its outputs complete.
#pragma once

namespace scarp::cli {

/// From here on the first SIGINT or SIGTERM asks to stop; the second one kills, as usual.
void catch_interrupts();
bool stop_requested();

}  // namespace scarp::cli
