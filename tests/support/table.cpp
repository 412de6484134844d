#include "support/table.hpp"

#include <fstream>
#include <stdexcept>

namespace vcrit::test {

std::vector<std::string> split(const std::string& line, char separator) {
  std::vector<std::string> cells(1);
  for (const char c : line) {
    if (c == separator)
      cells.emplace_back();
    else if (c != '\r')
      cells.back() += c;
  }
  return cells;
}

void require_rows(std::size_t found, std::size_t expected, const std::string& table) {
  if (found != expected)
    throw std::runtime_error("tests/data/" + table + ": found " + std::to_string(found) +
                             " rows; expected " + std::to_string(expected));
}

std::vector<std::vector<std::string>> rows_of(const std::string& table, std::size_t expected) {
  std::ifstream file(VCRIT_TEST_DATA "/" + table);
  std::vector<std::vector<std::string>> rows;
  std::string line;
  for (std::getline(file, line); std::getline(file, line);) rows.push_back(split(line, ','));
  require_rows(rows.size(), expected, table);
  return rows;
}

}  // namespace vcrit::test
