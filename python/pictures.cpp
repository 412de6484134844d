// The pictures of `vcrit plot`: as SVG, and as what they show.
#include "pictures/pictures.hpp"

#include <pybind11/stl.h>

#include "bindings.hpp"
#include "interrupt.hpp"

namespace vcrit::python {

namespace {

std::string svg_of(const Problem& problem, const std::string& of, std::optional<double> to,
                   double velocity) {
  const OthersRun others_run;
  return validation::picture_svg(problem, {of, to, velocity});
}

std::string figures_of(const Problem& problem, const std::string& of, std::optional<double> to,
                       double velocity) {
  const OthersRun others_run;
  return validation::picture_json(problem, {of, to, velocity});
}

}  // namespace

void add_pictures(pybind11::module_& module) {
  using pybind11::arg;
  module.def("svg", &svg_of, arg("scene"), arg("of"), arg("to"), arg("velocity"));
  module.def("figures", &figures_of, arg("scene"), arg("of"), arg("to"), arg("velocity"));
}

}  // namespace vcrit::python
