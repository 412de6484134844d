#include "report/scene_page.hpp"

#include "report/assets.hpp"
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
  const SceneReport& report = contents.report;
  std::vector<std::string> scripts;
  if (report.failure.empty()) scripts = explorer_scripts(report.problem);
  const bool simulates = !scripts.empty();
  if (report.failure.empty() && report.cycle) {
    if (!simulates) scripts.emplace_back(scrubber_script());
    scripts.emplace_back(cycle_script());
  }
  return document("scene", scene_record(contents, origin, files),
                  {title_of(report), true, scripts, simulates});
}

std::string evidence_page(const SceneContents& contents, const Origin& origin,
                          const SceneFiles& files) {
  return document("evidence", scene_record(contents, origin, files),
                  {"Evidence: " + title_of(contents.report), true, {}});
}

}  // namespace vcrit::validation::report
