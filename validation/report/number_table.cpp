#include "report/number_table.hpp"

#include <fmt/core.h>

namespace vcrit::validation::report {

namespace {

std::string row_of(const Cells& cells, bool heading) {
  std::string html;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const char* tag = heading || i == 0 ? "th" : "td";
    const char* scope = heading ? " scope=\"col\"" : i == 0 ? " scope=\"row\"" : "";
    html += fmt::format("<{0}{1}>{2}</{0}>", tag, scope, cells[i]);
  }
  return "<tr>" + html + "</tr>\n";
}

}  // namespace

std::string number_table(const Cells& headings, const std::vector<Cells>& rows,
                         const char* caption) {
  std::string body;
  for (const Cells& cells : rows) body += row_of(cells, false);
  return fmt::format(
      "<figure><div class=\"scroll\" tabindex=\"0\"><table class=\"numbers "
      "tight\"><thead>{}</thead>"
      "<tbody>\n{}</tbody></table></div><figcaption>{}</figcaption></figure>\n",
      row_of(headings, true), body, caption);
}

}  // namespace vcrit::validation::report
