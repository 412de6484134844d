#include "report/scene_page.hpp"

#include "report/document.hpp"
#include "report/explorer_record.hpp"
#include "report/records.hpp"
#include "report/verdict.hpp"

namespace vcrit::validation::report {

namespace {

record::Json scene_record(const SceneContents& contents, const Origin& origin,
                          const SceneFiles& files) {
  record::Json record = record::page_of(contents);
  record["in_suite"] = files.in_suite;
  record["page_file"] = files.page;
  record["evidence_file"] = files.evidence;
  add_origin(origin, record);
  return record;
}

}  // namespace

std::string scene_page(const SceneContents& contents, const Origin& origin,
                       const SceneFiles& files) {
  const auto scripts = contents.report.failure.empty() ? explorer_scripts(contents.report.problem)
                                                       : std::vector<std::string>();
  return document("scene", scene_record(contents, origin, files),
                  {title_of(contents.report), true, scripts, !scripts.empty()});
}

std::string evidence_page(const SceneContents& contents, const Origin& origin,
                          const SceneFiles& files) {
  return document("evidence", scene_record(contents, origin, files),
                  {"Evidence: " + title_of(contents.report), true, {}});
}

}  // namespace vcrit::validation::report
