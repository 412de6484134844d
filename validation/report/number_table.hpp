// Tables of numbers.
#pragma once

#include <string>
#include <vector>

namespace vcrit::validation::report {

/// As HTML; the first cell of a row is its head.
using Cells = std::vector<std::string>;

/// Headings, cells and caption are HTML: what comes from a scene must be escaped.
std::string number_table(const Cells& headings, const std::vector<Cells>& rows,
                         const char* caption);

}  // namespace vcrit::validation::report
