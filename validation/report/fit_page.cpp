#include "report/fit_page.hpp"

#include <fmt/core.h>

#include "base/constants.hpp"
#include "report/chart.hpp"
#include "report/document.hpp"
#include "report/fit_figures.hpp"
#include "report/html.hpp"

namespace vcrit::validation::report {

namespace {

// A chance below this says that the misfit is more than noise of the errors given.
constexpr double unlikely = fit::significance;

std::string series_words(const fit::Fit& fit) {
  const std::size_t n = fit.branches.size();
  std::string text = fmt::format("{} branch{}", n, n == 1 ? "" : "es");
  if (fit.equilibrium)
    text += n == 0 ? ", an equilibrium spring alone" : " and an equilibrium spring";
  if (fit.damper) text += " and a damper";
  return text;
}

std::string noise(const fit::Fit& fit) {
  if (fit.noise)
    return fmt::format("the noise of the data is estimated to {:.2g} % of |K|", 100 * *fit.noise);
  return fmt::format("chi-squared is {:.4g} with {} degrees of freedom ({:.3g} each)",
                     fit.sum_of_squares, fit.degrees_of_freedom,
                     fit.sum_of_squares / fit.degrees_of_freedom);
}

std::string uncertain_row(const char* name, const fit::Uncertain& a, const char* unit) {
  return fmt::format("<tr><th>{}</th><td>{:.5g} ± {:.2g} {}</td><td></td></tr>\n", name, a.value,
                     a.error, unit);
}

std::string branch_table(const fit::Fit& fit) {
  std::string rows;
  if (fit.equilibrium) rows += uncertain_row("k<sub>0</sub>", *fit.equilibrium, "N/m");
  if (fit.damper) rows += uncertain_row("c<sub>0</sub>", *fit.damper, "N s/m");
  int j = 0;
  for (const auto& [k, tau] : fit.branches)
    rows += fmt::format(
        "<tr><th>branch {}</th><td>{:.5g} ± {:.2g} N/m</td><td>{:.5g} ± {:.2g} s</td></tr>\n", ++j,
        k.value, k.error, tau.value, tau.error);
  return "<h3>The series</h3>\n<div class=\"scroll\"><table class=\"plain\"><thead><tr><th></th>"
         "<th>stiffness</th><th>relaxation time</th></tr></thead><tbody>\n" +
         rows + "</tbody></table></div>\n";
}

std::string interval_cells(double value, const fit::Interval& interval) {
  return fmt::format("<td>{:.5g}</td><td>{:.4g} to {:.4g}</td>", value, interval.low,
                     interval.high);
}

std::string stiffness_table(const std::vector<fit::KnownStiffness>& known) {
  std::string rows;
  for (const fit::KnownStiffness& at : known)
    rows += fmt::format("<tr><th>{:.4g}</th>", at.omega / two_pi) +
            interval_cells(at.storage, at.storage_interval) +
            interval_cells(at.loss, at.loss_interval) + "</tr>\n";
  return "<h3>How well the stiffness is known</h3>\n<p>Any series of springs and dampers that fits "
         "these data lies in the 95 % intervals, whatever its number of branches.</p>\n<div "
         "class=\"scroll\"><table class=\"plain\"><thead><tr><th>frequency, Hz</th><th>storage, "
         "N/m</th><th>95 %</th><th>loss, N/m</th><th>95 %</th></tr></thead><tbody>\n" +
         rows + "</tbody></table></div>\n";
}

std::string trial_table(const fit::Fit& fit) {
  std::string rows;
  for (const fit::Trial& trial : fit.trials)
    rows +=
        fmt::format("<tr><th>{}</th><td>{:.5g}</td><td>{}</td><td>{}</td></tr>\n", trial.branches,
                    trial.sum_of_squares, trial.chance ? fmt::format("{:.2g}", *trial.chance) : "",
                    trial.chance ? fmt::format("{:.2g}", trial.level) : "");
  return "<h3>How many branches</h3>\n<p>A longer series always comes nearer to the data. It is "
         "taken "
         "only where the chance that noise alone makes it so much better is below the level; the "
         "chance is against the longest series taken before.</p>\n<div class=\"scroll\"><table "
         "class=\"plain\"><thead><tr><th>branches</th><th>sum of squares</th><th>chance</th>"
         "<th>level</th></tr></thead><tbody>\n" +
         rows + "</tbody></table></div>\n";
}

}  // namespace

std::vector<std::string> fit_in_words(const fit::Data& data, const fit::Fit& fit) {
  std::vector<std::string> words{series_words(fit),
                                 fmt::format("the root mean square misfit is {:.3g} %; {}",
                                             100 * fit.rms_relative, noise(fit))};
  if (fit.exhausted)
    words.push_back(
        fmt::format("the last of {} branches still helped: more may be needed (--max-branches)",
                    fit.branches.size()));
  if (fit.order_in_doubt)
    words.emplace_back(
        "the noise leaves the number of branches in doubt: the errors of the branches hold for "
        "this "
        "number only, the intervals of the stiffness for any");
  if (fit.time_at_an_end)
    words.emplace_back(
        "the relaxation time is only a bound: the data show no more than the tail of the loss");
  if (fit.rms_relative > fit::far_off)
    words.emplace_back("no series of springs and dampers comes near these data");
  if (fit.chance && *fit.chance < unlikely)
    words.emplace_back(
        "the misfit is larger than the errors given explain: they are too small, or no series "
        "fits");
  if (!fit.equilibrium)
    words.emplace_back(
        "the data need no equilibrium spring; without one this contact carries no static load and "
        "is not admissible as a normal contact");
  for (const auto& [k, tau] : fit.branches)
    if (k.error > k.value / 2)
      words.push_back(fmt::format("the branch at {:.3g} s is poorly known ({:.2g} ± {:.1g} N/m)",
                                  tau.value, k.value, k.error));
  if (data.rows.size() < 2 * fit.branches.size())
    words.emplace_back("there are more numbers in the series than frequencies in the data");
  words.insert(words.end(), data.notes.begin(), data.notes.end());
  return words;
}

std::string fit_page(const fit::Data& data, const fit::Fit& fit,
                     const std::vector<fit::KnownStiffness>& known, const std::string& scene) {
  const auto pictures = fit_figures(data, fit);
  std::string words;
  for (const std::string& each : fit_in_words(data, fit))
    words += "<li>" + escape(each) + "</li>\n";
  std::string charts;
  for (const figures::Figure& figure : pictures)
    charts += "<h3>" + escape(figure.title) + "</h3>\n" + chart(figure);
  const std::string title = "Prony series fitted to " + data.file;
  return document(
      {title,
       fmt::format(
           "<a class=\"skip\" href=\"#content\">To the results</a>\n<header><p "
           "class=\"program\">vcrit</p>\n<h1>{}</h1>\n<p class=\"lead\">{} frequencies from "
           "{:.4g} to {:.4g} Hz</p></header>\n<main id=\"content\">\n<ul>\n{}</ul>\n",
           escape(title), data.rows.size(), data.rows.front().omega / two_pi,
           data.rows.back().omega / two_pi, words) +
           charts + stiffness_table(known) + branch_table(fit) + trial_table(fit) +
           "<h3>The scene</h3>\n<pre><code>" + escape(scene) + "</code></pre>\n</main>\n",
       true,
       {}});
}

}  // namespace vcrit::validation::report
