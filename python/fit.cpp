// A Prony series from measured stiffness, as `vcrit fit` finds it.
#include "fit/fit.hpp"

#include <pybind11/stl.h>

#include "base/constants.hpp"
#include "bindings.hpp"
#include "fit/bounds.hpp"
#include "fit/scene_text.hpp"
#include "fit/words.hpp"
#include "interrupt.hpp"

namespace vcrit::python {

namespace py = pybind11;

namespace {

using fit::Uncertain;
using Pair = std::pair<double, double>;
using Columns = std::vector<std::vector<double>>;

std::optional<Pair> pair_of(const std::optional<Uncertain>& number) {
  if (!number) return std::nullopt;
  return Pair(number->value, number->error);
}

/// Stiffness, time and the error of each.
Columns branches_of(const fit::Fit& found) {
  Columns columns(4);
  for (const auto& [stiffness, time] : found.branches) {
    columns[0].push_back(stiffness.value);
    columns[1].push_back(time.value);
    columns[2].push_back(stiffness.error);
    columns[3].push_back(time.error);
  }
  return columns;
}

/// Frequency; storage and loss; the lowest and the highest value of each.
Columns known_of(const StiffnessTable& data, const fit::Fit& found) {
  Columns columns(7);
  for (const fit::KnownStiffness& at :
       known_stiffness(data, found, fit::frequencies_across(data))) {
    const auto& [omega, storage, loss, of_storage, of_loss] = at;
    const double row[] = {omega / two_pi,  storage,     loss,        of_storage.low,
                          of_storage.high, of_loss.low, of_loss.high};
    for (std::size_t i = 0; i < columns.size(); ++i) columns[i].push_back(row[i]);
  }
  return columns;
}

/// "rest": what the scene says besides, as texts.
struct Given {
  std::string text, file, punch_radius;
  fit::Rest rest;
  fit::Options options;
};

struct Fitted {
  StiffnessTable data;
  fit::Fit series;
  Columns known;
  std::string scene;
};

Fitted fitted_to(const Given& given) {
  const OthersRun others_run;
  const auto punch = punch_of(given.punch_radius, given.rest.poisson);
  StiffnessTable data = parse_stiffness_table(given.text, given.file, punch);
  fit::Fit series = fit::fitted(data, given.options);
  Columns known = known_of(data, series);
  std::string scene = scene_text(series, data, given.rest);
  return {std::move(data), std::move(series), std::move(known), std::move(scene)};
}

py::dict fitted_series(const std::string& text, const std::string& file,
                       const std::string& punch_radius, bool damper, int max_branches,
                       const std::map<std::string, std::string>& rest) {
  const auto of = [&](const char* key) {
    const auto found = rest.find(key);
    return found == rest.end() ? std::string() : found->second;
  };
  const Fitted found = fitted_to({text,
                                  file,
                                  punch_radius,
                                  {of("title"), of("poisson"), of("frequency"), of("amplitude"),
                                   of("indentation"), of("coefficient")},
                                  {damper, max_branches}});
  const fit::Fit& series = found.series;
  using py::arg;
  return py::dict(arg("text") = found.scene, arg("equilibrium") = pair_of(series.equilibrium),
                  arg("damper") = pair_of(series.damper), arg("branches") = branches_of(series),
                  arg("known") = found.known, arg("rms_relative_misfit") = series.rms_relative,
                  arg("noise") = series.noise,
                  arg("degrees_of_freedom") = series.degrees_of_freedom,
                  arg("order_in_doubt") = series.order_in_doubt,
                  arg("exhausted") = series.exhausted, arg("notes") = found.data.notes,
                  arg("words") = with_python_names(in_words(found.data, series)));
}

}  // namespace

void add_fit(py::module_& module) {
  using py::arg;
  module.def("fit", &fitted_series, arg("text"), arg("file"), arg("punch_radius"), arg("damper"),
             arg("max_branches"), arg("rest"));
}

}  // namespace vcrit::python
