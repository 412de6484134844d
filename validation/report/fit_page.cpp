#include "report/fit_page.hpp"

#include <fmt/core.h>

#include <utility>

#include "base/constants.hpp"
#include "report/document.hpp"
#include "report/fit_figures.hpp"
#include "report/records.hpp"

namespace vcrit::record {

using validation::report::FitContents;

void fields(Fields& f, const fit::FittedBranch& it) {
  f("stiffness", it.stiffness.value)("stiffness_error", it.stiffness.error);
  f("time", it.time.value)("time_error", it.time.error);
}

void fields(Fields& f, const fit::KnownStiffness& it) {
  f("frequency", it.omega / two_pi)("storage", it.storage);
  f("storage_low", it.storage_interval.low)("storage_high", it.storage_interval.high);
  f("loss", it.loss)("loss_low", it.loss_interval.low)("loss_high", it.loss_interval.high);
}

void fields(Fields& f, const fit::Trial& it) {
  f("branches", it.branches)("sum_of_squares", it.sum_of_squares);
  f("chance", it.chance)("level", it.level)("judged", it.chance.has_value());
}

void fields(Fields& f, const FitContents& it) {
  const auto& [data, fit, known, scene, page, text] = it;
  const auto uncertain = [&](const char* key, const char* error, const auto& number) {
    f.when(number.has_value(), key, number.value_or(fit::Uncertain{}).value);
    f.when(number.has_value(), error, number.value_or(fit::Uncertain{}).error);
  };
  f("scene", scene)("page", page)("rows", data.rows.size());
  uncertain("equilibrium", "equilibrium_error", fit.equilibrium);
  uncertain("damper", "damper_error", fit.damper);
  f("branches", fit.branches)("order_in_doubt", fit.order_in_doubt)("stiffness", known);
  f("rms_relative_misfit", fit.rms_relative)("degrees_of_freedom", fit.degrees_of_freedom);
  f.some("noise", fit.noise).when(fit.chance.has_value(), "chi_squared", fit.sum_of_squares);
  f.some("chance", fit.chance)("exhausted", fit.exhausted);
  f("words", validation::report::fit_in_words(data, fit));
  if (!f.for_page()) return;
  f("heading", "Prony series fitted to " + data.file);
  f("figures", validation::report::fit_figures(data, fit));
  f("lowest", data.rows.front().omega / two_pi)("highest", data.rows.back().omega / two_pi);
  f("trials", fit.trials)("scene_text", text);
}

}  // namespace vcrit::record

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

std::string fit_page(const FitContents& contents) {
  record::Json page = record::page_of(contents);
  const std::string title = page["heading"];
  return document("fit", std::move(page), {title, true, {}});
}

}  // namespace vcrit::validation::report
