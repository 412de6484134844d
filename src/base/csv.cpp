#include "base/csv.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

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

void CsvLines::take_header(const char* header) {
  const bool any = next();
  if (!any || fmt::format("{}", fmt::join(cells(), ",")) != header)
    throw InputError(place_, any ? fmt::format("\"{}\"", line_) : "an empty table",
                     fmt::format("the header {}", header));
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
  if (words.size() != count) throw InputError(place_, fmt::format("\"{}\"", line_), expected);
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
