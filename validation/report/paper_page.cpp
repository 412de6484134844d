#include "report/paper_page.hpp"

#include "report/document.hpp"
#include "report/records.hpp"

namespace vcrit::validation::report {

std::string paper_page(const PaperContents& contents) {
  record::Json record = record::page_of(contents.paper);
  add_verdict(all_comparisons(contents.paper), record);
  add_origin(contents.origin, record);
  return document("paper", record, {"The paper, checked", true, {}});
}

}  // namespace vcrit::validation::report
