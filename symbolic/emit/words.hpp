// Prose in generated files.
#pragma once

#include <string>

namespace vcrit::symbolic {

/// `text` as // comment lines of at most 120 characters where it has spaces to break at. Characters
/// that could change how the compiler reads the lines (control characters, backslashes, marks that
/// turn the writing direction) are left out.
std::string comment(const std::string& text);

}  // namespace vcrit::symbolic
