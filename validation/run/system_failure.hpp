// What the operating system refuses.
#pragma once

#include <string>
#include <system_error>

namespace vcrit::validation {

/// Throws std::system_error; `error` as in errno, `what` was asked for.
[[noreturn]] inline void system_failure(int error, const std::string& what) {
  throw std::system_error(error, std::generic_category(), what);
}

}  // namespace vcrit::validation
