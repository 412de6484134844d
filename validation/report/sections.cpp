#include "report/sections.hpp"

#include <fmt/core.h>

#include "report/comparison_table.hpp"
#include "report/html.hpp"

namespace vcrit::validation::report {

namespace {

bool all_passed(const std::vector<Comparison>& comparisons) {
  return count(comparisons, Comparison::Outcome::failed) == 0;
}

const char* state_of(const std::vector<Comparison>& comparisons) {
  return all_passed(comparisons) ? "passed" : "failed";
}

/// Open where something failed.
std::string agreement(const std::vector<Comparison>& comparisons) {
  return fmt::format("<details class=\"agreement\"{}><summary>{}</summary>\n{}</details>\n",
                     all_passed(comparisons) ? "" : " open", escape(count_words(comparisons)),
                     comparison_table(comparisons));
}

}  // namespace

std::string verdict(const std::vector<Comparison>& comparisons) {
  return fmt::format(
      "<div class=\"verdict {}\"><p class=\"state\">{}</p><p class=\"worst\">{}</p></div>\n",
      state_of(comparisons), escape(count_words(comparisons)), escape(tightest_words(comparisons)));
}

std::string section(const std::string& id, const std::string& title, const std::string& content,
                    const std::vector<Comparison>& comparisons) {
  return fmt::format("<section class=\"scene\" id=\"{}\">\n<h2>{}</h2>\n{}{}</section>\n", id,
                     title, content, agreement(comparisons));
}

}  // namespace vcrit::validation::report
