#include "harness/text_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace vcrit::bench {

namespace {

std::string in_columns(const std::vector<TextRow>& rows) {
  std::vector<std::size_t> widths(rows.front().size());
  for (const TextRow& row : rows)
    for (std::size_t j = 0; j < row.size(); ++j) widths[j] = std::max(widths[j], row[j].size());
  std::string out;
  for (const TextRow& row : rows) {
    out += fmt::format("{:<{}}", row[0], widths[0]);
    for (std::size_t j = 1; j < row.size(); ++j) out += fmt::format("  {:>{}}", row[j], widths[j]);
    out += "\n";
  }
  return out;
}

std::string as_markdown(const std::vector<TextRow>& rows) {
  std::string out;
  for (const TextRow& row : rows) {
    out += fmt::format("| {} |\n", fmt::join(row, " | "));
    if (&row != &rows.front()) continue;
    out += "|---|";
    for (std::size_t j = 1; j < row.size(); ++j) out += "---:|";
    out += "\n";
  }
  return out;
}

}  // namespace

std::string text_table(const std::vector<TextRow>& rows, TableStyle style) {
  return style == TableStyle::text ? in_columns(rows) : as_markdown(rows);
}

}  // namespace vcrit::bench
