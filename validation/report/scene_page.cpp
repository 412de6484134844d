#include "report/scene_page.hpp"

#include <fmt/core.h>

#include "report/document.hpp"
#include "report/explorer_section.hpp"
#include "report/html.hpp"
#include "report/scene_section.hpp"

namespace vcrit::validation::report {

namespace {

const char* what_follows(const SceneReport& report) {
  if (!report.reasons.empty())
    return "This scene is outside the model. The page says why, and shows the formula that would "
           "apply to a contact that stays closed.";
  if (report.curve.empty() && !report.indented)
    return "Here its formula is derived and evaluated in several ways. Nothing was simulated.";
  return "Here its formula is derived, evaluated in several ways, and set against a stick-slip "
         "simulation that does not know the formula.";
}

std::string scene_opening(const SceneReport& report, const Origin& origin, bool in_suite) {
  return fmt::format(
      "<a class=\"skip\" href=\"#content\">To the results</a>\n"
      "<header class=\"page\"><p class=\"program\">{}vcrit {}</p>\n<h1>{}</h1>\n"
      "<p class=\"lead\">Up to the critical velocity v*, normal oscillation lowers sliding "
      "friction. {}</p>\n</header>\n"
      "<main id=\"content\">\n",
      in_suite ? "<a href=\"index.html\">All scenes</a> · " : "", escape(origin.machine.program),
      escape(title_of(report)), what_follows(report));
}

}  // namespace

std::string scene_page(const SceneContents& contents, const Origin& origin, bool in_suite) {
  const SceneReport& report = contents.report;
  return document({title_of(report),
                   scene_opening(report, origin, in_suite) + scene_section(contents) +
                       machine_section(origin) + "</main>\n",
                   true, explorer_scripts(report)});
}

}  // namespace vcrit::validation::report
