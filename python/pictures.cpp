// The pictures of `vcrit plot`: as SVG, and as what they show.
#include <fmt/core.h>
#include <pybind11/stl.h>

#include "bindings.hpp"
#include "figures/figure_json.hpp"
#include "figures/svg.hpp"
#include "interrupt.hpp"
#include "report/plots.hpp"
#include "report/units.hpp"

namespace vcrit::python {

namespace py = pybind11;

namespace {

using validation::figures::Figure;

/// `velocity` (m/s) is that of a cycle.
std::vector<Figure> figures_of(const Problem& problem, const std::string& of,
                               std::optional<double> to, double velocity) {
  const OthersRun others_run;
  if (of == "friction") return validation::report::friction_plot(problem, to);
  if (of == "frequency") return validation::report::frequency_plot(problem);
  if (of == "cycle") return validation::report::cycle_plot(problem, velocity);
  throw InputError(argument("of"), '"' + of + '"', "one of friction, frequency, cycle");
}

std::string picture(const Problem& problem, const std::string& of, std::optional<double> to,
                    double velocity) {
  return validation::figures::svg(figures_of(problem, of, to, velocity));
}

/// JSON: a list of figures.
std::string shown(const Problem& problem, const std::string& of, std::optional<double> to,
                  double velocity) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const Figure& figure : figures_of(problem, of, to, velocity))
    all.push_back(validation::figures::figure_json(figure));
  return all.dump();
}

}  // namespace

void add_pictures(py::module_& module) {
  using py::arg;
  module.def("svg", &picture, arg("scene"), arg("of"), arg("to"), arg("velocity"));
  module.def("figures", &shown, arg("scene"), arg("of"), arg("to"), arg("velocity"));
  module.def("quantity", &validation::report::quantity, arg("value"), arg("unit"), arg("digits"));
}

}  // namespace vcrit::python
