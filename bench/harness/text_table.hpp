// Rows of words as a table, for people or for a document.
#pragma once

#include <string>
#include <vector>

namespace vcrit::bench {

using TextRow = std::vector<std::string>;

enum class TableStyle { text, markdown };

/// The first row is the head; the first column stands to the left, the others to the right.
std::string text_table(const std::vector<TextRow>& rows, TableStyle style);

}  // namespace vcrit::bench
