#include "base/csv.hpp"

#include <fmt/core.h>

#include <cmath>
#include <string_view>

#include "base/joined.hpp"
#include "base/numbers.hpp"
#include "base/trimmed.hpp"

namespace vcrit {

namespace {

constexpr const char* byte_order_mark = "\xEF\xBB\xBF";
constexpr const char* blanks_of_csv = " \t\r";

std::string without_quotes(std::string_view cell) {
  const bool quoted = cell.size() >= 2 && cell.front() == '"' && cell.back() == '"';
  return std::string(quoted ? cell.substr(1, cell.size() - 2) : cell);
}

}  // namespace

CsvLines::CsvLines(const std::string& text, const std::string& file)
    : in_(text.starts_with(byte_order_mark) ? text.substr(3) : text), place_{file} {
  // As spreadsheets write "Unicode text".
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
    throw InputError(place_, "a table in UTF-16", "one in UTF-8",
                     "save it as CSV in UTF-8, with commas between the columns");
}

bool CsvLines::next() {
  while (std::getline(in_, line_)) {
    ++place_.line;
    line_ = std::string(trimmed(line_, blanks_of_csv));
    if (!line_.empty()) return true;
  }
  return false;
}

void CsvLines::take_header(const char* header, const char* advice) {
  const bool any = next();
  if (!any || joined(cells(), ",") != header)
    throw InputError(place_, any ? fmt::format("\"{}\"", line_) : "an empty table",
                     fmt::format("the header {}", header), advice);
}

std::vector<std::string> CsvLines::cells() const {
  std::vector<std::string> result;
  for (std::size_t begin = 0;;) {
    const auto comma = line_.find(',', begin);
    const auto length = comma == line_.npos ? comma : comma - begin;
    result.push_back(
        without_quotes(trimmed(std::string_view(line_).substr(begin, length), blanks_of_csv)));
    if (comma == line_.npos) return result;
    begin = comma + 1;
  }
}

std::vector<double> CsvLines::numbers(std::size_t count, const std::string& expected) const {
  const std::vector<std::string> words = cells();
  if (words.size() != count) {
    // Each number, or each but a whole first one, has a comma within.
    const bool commas = words.size() == 2 * count || (count > 2 && words.size() == 2 * count - 1);
    const bool other_marks = commas || line_.find(';') != line_.npos;
    throw InputError(place_, fmt::format("\"{}\"", line_), expected,
                     other_marks ? "commas separate numbers, which have decimal points: 2.5" : "");
  }
  std::vector<double> result;
  for (const std::string& word : words) {
    const auto number = to_double(word);
    if (!number || !std::isfinite(*number))
      throw InputError(place_, fmt::format("\"{}\"", word), "a finite number");
    result.push_back(*number);
  }
  return result;
}

}  // namespace vcrit
