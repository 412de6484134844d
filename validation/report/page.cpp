#include "report/page.hpp"

#include <fmt/format.h>

#include "report/document_head.hpp"
#include "report/html.hpp"
#include "report/machine_section.hpp"
#include "report/scene_section.hpp"
#include "report/script_elements.hpp"

namespace vcrit::validation::report {

namespace {

std::string head(const Contents& contents) {
  const bool single = contents.scenes.size() == 1;
  return document_head(
      single ? title_of(contents.scenes.front()) : "Validation of critical velocities",
      script_policy());
}

std::string summary(const Contents& contents) {
  std::size_t made = 0, failures = 0, skipped = 0;
  for (const SceneReport& report : contents.scenes) {
    made += report.comparisons.size() - count(report, Comparison::Outcome::not_run);
    failures += count(report, Comparison::Outcome::failed);
    skipped += count(report, Comparison::Outcome::not_run);
  }
  const char* state = failures > 0 ? "failed" : skipped > 0 ? "not-run" : "passed";
  std::string words = failures > 0 ? fmt::format("{} of {} comparisons failed", failures, made)
                                   : fmt::format("{} comparisons passed", made);
  if (skipped > 0) words += fmt::format(", {} not run", skipped);
  return fmt::format("<p class=\"total {}\">{}.</p>\n", state, words);
}

std::string index_line(const SceneReport& report, std::size_t number) {
  return fmt::format(
      "<li class=\"{}\"><a href=\"#scene-{}\"><span class=\"name\">{}</span>"
      "<span class=\"velocity\">{}</span><span class=\"state\">{}</span></a></li>\n",
      state_class(report), number, escape(title_of(report)), escape(velocity_words(report)),
      escape(state_words(report)));
}

std::string index(const Contents& contents) {
  if (contents.scenes.size() < 2) return {};
  std::string lines;
  for (std::size_t i = 0; i < contents.scenes.size(); ++i)
    lines += index_line(contents.scenes[i], i + 1);
  return "<nav aria-label=\"Scenes\"><ol class=\"index\">\n" + lines + "</ol></nav>\n";
}

std::string opening(const Contents& contents) {
  return fmt::format(
      "<body>\n<a class=\"skip\" href=\"#content\">To the results</a>\n"
      "<header class=\"page\"><p class=\"program\">vcrit {}</p>\n"
      "<h1>Critical velocity, validated</h1>\n"
      "<p class=\"lead\">Up to the critical velocity v*, normal oscillation lowers sliding "
      "friction. Here its formula is derived, evaluated in several ways, and set against a "
      "stick-slip simulation that does not know the formula.</p>\n{}</header>\n"
      "<main id=\"content\">\n",
      escape(contents.machine.program), summary(contents));
}

}  // namespace

std::string page(const Contents& contents) {
  std::string html = head(contents) + opening(contents) + index(contents);
  for (std::size_t i = 0; i < contents.scenes.size(); ++i)
    html += scene_section(contents.scenes[i], i + 1);
  return html + machine_section(contents.machine, command(contents)) + "</main>\n" +
         script_elements() + "</body>\n</html>\n";
}

}  // namespace vcrit::validation::report
