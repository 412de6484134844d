#include "base/csv.hpp"

#include <fmt/core.h>

#include <cmath>

#include "base/joined.hpp"
#include "base/numbers.hpp"
#include "base/trimmed.hpp"

namespace vcrit {

namespace {

constexpr const char* byte_order_mark = "\xEF\xBB\xBF";
constexpr const char* blanks_of_csv = " \t\r";

}  // namespace

CsvLines::CsvLines(const std::string& text, const std::string& file)
    : in_(text.starts_with(byte_order_mark) ? text.substr(3) : text), place_{file} {}

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
    result.emplace_back(trimmed(line_.substr(begin, comma - begin), blanks_of_csv));
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
