// The tables of tests/data. A test over the rows of a table passes on none, so each says how many
// there are.
#pragma once

#include <string>
#include <vector>

namespace vcrit::test {

std::vector<std::string> split(const std::string& line, char separator);

/// Throws where the number of rows read is another one.
void require_rows(std::size_t found, std::size_t expected, const std::string& table);

/// The cells of each line but the first.
std::vector<std::vector<std::string>> rows_of(const std::string& table, std::size_t expected);

}  // namespace vcrit::test
