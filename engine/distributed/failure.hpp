// SPDX-License-Identifier: GPL-2.0-only
/// What one process has thrown, for the others.
#pragma once

#include <exception>

#include "engine/distributed/message.hpp"

namespace scarp::distributed {

/// Nothing is in the message where `thrown` is empty.
Message failure_message(const std::exception_ptr& thrown);
/// The same exception as far as its kind has a meaning to the commands of scarp.
[[noreturn]] void throw_failure(Message message);

}  // namespace scarp::distributed
