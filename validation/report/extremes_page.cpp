#include "report/extremes_page.hpp"

#include <fmt/core.h>

#include "extremes/pictures.hpp"
#include "extremes/summary.hpp"
#include "report/chart.hpp"
#include "report/document.hpp"
#include "report/extremes_tables.hpp"
#include "report/html.hpp"
#include "report/sections.hpp"

namespace vcrit::validation::report {

namespace {

using extremes::Extremes;

std::string region_section(const Extremes& all, const extremes::RegionName& region) {
  std::vector<Comparison> comparisons;
  for (const Comparison& each : comparisons_of(all, region.key))
    if (each.key != "simulation") comparisons.push_back(each);
  std::string content = fmt::format("<p>{}</p>\n", escape(region.words));
  std::vector<figures::Figure> figures = maps(all, region.key);
  const auto approaches = approach_pictures(all, region.key);
  figures.insert(figures.end(), approaches.begin(), approaches.end());
  if (!figures.empty()) content += panels(figures);
  content += loss_table(all, region.key) + worst_table(all, region.key);
  return section(region.key, region.title, content, comparisons);
}

std::string simulator_section(const Extremes& all) {
  std::vector<Comparison> comparisons;
  for (const Comparison& each : all_comparisons(all))
    if (each.key == "simulation") comparisons.push_back(each);
  return section(
      "simulator", "The simulator",
      "<p>It does not know Eq. (24). On the maps every second column and row is asked, elsewhere "
      "everything; not where v* is no normal double, where conditioning leaves it unknown to "
      "10<sup>−7</sup> in doubles, or where the stuck body would swing over 10,000 times in a "
      "period. An answer that is missing is a loss; a wrong one a failure.</p>\n<p>No ω here is a "
      "whole fraction of the undamped frequency of body and drive. There a free swing of the body "
      "repeats with every period and lifts the least contact velocity: sliding without stick is "
      "steady a little below v* too, with full friction.</p>\n" +
          simulator_table(all) + silence_table(all),
      comparisons);
}

std::string judging_section(const Extremes& all) {
  std::string scenes;
  for (const extremes::FamilyResult& family : all.families)
    scenes += fmt::format("<li><code>{}</code>: {}</li>\n", family.key, escape(family.title));
  return "<section class=\"scene\" id=\"judging\">\n<h2>How it is judged</h2>\n<p>The reference is "
         "v* correctly rounded, by interval arithmetic of adaptive precision; of each kind of "
         "extreme "
         "about thirty values are computed again from the formula as derived, in 200 digits, which "
         "shares no code with it. Digits are lost where the error is more than 32 units of "
         "rounding "
         "times the condition number of Eq. (24). A value off by more than its claimed bound is a "
         "failure, a value without a bound a loss. du<sub>z</sub> is reduced where the contact "
         "would "
         "open: v* is linear in it.</p>\n<p>The scenes have numbers near 1 in SI units, so that "
         "all "
         "extremes are equally far:</p>\n<ul>\n" +
         scenes + "</ul>\n</section>\n";
}

std::string extremes_opening(const ExtremesContents& contents) {
  std::string lines;
  for (const std::string& words : in_words(contents.extremes))
    lines += fmt::format("<li>{}</li>\n", escape(words));
  return fmt::format(
      "<a class=\"skip\" href=\"#content\">To the results</a>\n"
      "<header class=\"page\"><p class=\"program\">vcrit {}</p>\n<h1>Extremes</h1>\n"
      "<p class=\"lead\">Evaluators and simulator where numbers are very large, very small, or "
      "cancel: what they lose, and where what they claim ends.</p>\n{}<ul>\n{}</ul>\n</header>\n"
      "<main id=\"content\">\n",
      escape(contents.origin.machine.program), verdict(all_comparisons(contents.extremes)), lines);
}

}  // namespace

std::string extremes_page(const ExtremesContents& contents) {
  std::string body = extremes_opening(contents) + judging_section(contents.extremes);
  for (const extremes::RegionName& region : extremes::regions())
    body += region_section(contents.extremes, region);
  body += simulator_section(contents.extremes) + machine_section(contents.origin) + "</main>\n";
  return document({"Extremes", body, true, {}});
}

}  // namespace vcrit::validation::report
