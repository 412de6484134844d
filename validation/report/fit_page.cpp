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
  const auto& [data, fit, known, words, scene, page, text] = it;
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
  f("words", words);
  if (!f.for_page()) return;
  f("heading", "Prony series fitted to " + data.file);
  f("figures", validation::report::fit_figures(data, fit));
  f("lowest", data.rows.front().omega / two_pi)("highest", data.rows.back().omega / two_pi);
  f("trials", fit.trials)("scene_text", text);
}

}  // namespace vcrit::record

namespace vcrit::validation::report {

std::string fit_page(const FitContents& contents) {
  record::Json page = record::page_of(contents);
  const std::string title = page["heading"];
  return document("fit", std::move(page), {title, true, {}});
}

}  // namespace vcrit::validation::report
