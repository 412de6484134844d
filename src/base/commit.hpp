#pragma once

#include <string>

namespace vcrit {

/// Of the sources that the program is made of: "unknown" outside a repository; + where they differ
/// from it.
std::string commit();

}  // namespace vcrit
