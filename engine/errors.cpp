// SPDX-License-Identifier: BSD-3-Clause
/// Words for what was thrown.
#include "engine/errors.hpp"

#include <new>

namespace scarp {

std::string reason_of(const std::exception_ptr& thrown) {
  constexpr const char* no_memory = "not enough memory. Try a larger spacing.";
  try {
    std::rethrow_exception(thrown);
  } catch (const std::bad_alloc&) {
    return no_memory;
  } catch (const std::length_error&) {  // a size that no memory could have
    return no_memory;
  } catch (const std::exception& error) {
    return error.what();
  } catch (...) {
    return "an error without a name";
  }
}

}  // namespace scarp
