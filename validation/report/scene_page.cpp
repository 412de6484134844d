#include "report/scene_page.hpp"

#include "report/document.hpp"
#include "report/explorer_record.hpp"
#include "report/records.hpp"
#include "report/verdict.hpp"

namespace vcrit::validation::report {

std::string scene_page(const SceneContents& contents, const Origin& origin, bool in_suite) {
  record::Json record = record::page_of(contents);
  record["in_suite"] = in_suite;
  add_origin(origin, record);
  return document("scene", record,
                  {title_of(contents.report), true, explorer_scripts(contents.report)});
}

}  // namespace vcrit::validation::report
