#include "report/explore_page.hpp"

#include "report/document.hpp"
#include "report/explorer_record.hpp"
#include "rules/rulebook.hpp"

namespace vcrit::validation::report {

std::string explore_page(const Problem& problem) {
  rules::require(rules::Question::report_explorer, problem, "no explorer: ");
  const Source& source = *problem->source;
  const std::string heading = source.title.empty() ? source.file : source.title;
  record::Json page{{"version", VCRIT_VERSION},
                    {"heading", heading},
                    {"file", source.file},
                    {"text", source.text},
                    {"explorer", explorer_record(problem)}};
  return document("explore", page, {heading, false, explorer_scripts(problem), true});
}

}  // namespace vcrit::validation::report
