// Names that the C library has already.
#pragma once

#include <string_view>

namespace vcrit::symbolic {

/// Whether the C library puts the name into the global namespace through the headers that generated
/// code includes: math.h and what comes with C++'s headers.
bool is_taken_in_c(std::string_view name);

/// Whether other headers that C++'s bring along declare it: no namespace can be called so.
bool is_declared_by_c(std::string_view name);

}  // namespace vcrit::symbolic
