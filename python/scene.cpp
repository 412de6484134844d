// A scene for Python: what it names, whether Eq. 24 applies, and v*.
#include "problem/problem.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <tuple>

#include "answers/critical_onset.hpp"
#include "answers/effect_words.hpp"
#include "base/files.hpp"
#include "base/units.hpp"
#include "bindings.hpp"
#include "critical/admissibility.hpp"
#include "interrupt.hpp"
#include "scene/settings.hpp"

namespace vcrit::python {

namespace py = pybind11;

namespace {

using Parameter = std::tuple<std::string, std::optional<double>, std::string>;

// What the scene's formulas may depend on, under the names of the formulas: name, value, unit.
std::vector<Parameter> parameters(const Problem& problem) {
  std::vector<Parameter> all;
  const auto add = [&](const Symbol& symbol, const std::optional<double>& value) {
    const std::string name = to_text(as_called(problem, symbol));
    if (const auto known = problem->source->settable.find(name);
        known != problem->source->settable.end())
      all.emplace_back(name, value, si_unit(known->second));
  };
  for (const Quantity* quantity : {&problem->coefficient, &problem->angular_frequency,
                                   &problem->amplitude, &pressing(problem)})
    add(quantity->symbol, quantity->value);
  if (problem->mass) add(problem->mass->symbol, problem->mass->value);
  if (const auto* isotropic = std::get_if<Isotropic>(&problem->tangential))
    add(isotropic->quantity.symbol, isotropic->quantity.value);
  for (const auto& [symbol, value] : elements_with_values(problem)) add(symbol, value);
  return all;
}

std::map<std::string, std::string> settable(const Problem& problem) {
  std::map<std::string, std::string> units;
  for (const auto& [name, dimension] : problem->source->settable) units[name] = si_unit(dimension);
  return units;
}

std::tuple<double, double, std::string> certified(const Problem& problem) {
  const OthersRun others_run;
  const auto [value, bound, reason] = certified_onset(problem);
  return {value, bound, reason};
}

std::tuple<double, double, std::string, std::string> onset(const Problem& problem) {
  const OthersRun others_run;
  const CriticalOnset found = critical_onset(problem);
  return {found.contact_velocity, found.drive_velocity,
          found.by == CriticalOnset::By::formula ? "formula" : "simulation", found.reason};
}

double parse_value(const Problem& problem, const std::string& name, const std::string& text) {
  const Place place{name};
  refuse_expression(*problem->source, name, place);
  return parse_quantity(
      text, known_dimension(name, problem->source->settable, place, problem->source->named), place);
}

// What vibration does, and at which operating point.
std::pair<std::string, std::string> in_words(const Problem& problem) {
  const OthersRun others_run;
  const Effect effect = effect_of(problem);
  return {sentence(effect), operating_point(effect)};
}

std::string quantity(double value, const std::string& unit) { return rounded(value, unit); }

// Of files beside the scene's own.
bool reads_tables(const Problem& problem) {
  return problem->receptance() != nullptr || !problem->measured.empty() ||
         (problem->indenter && problem->indenter->profile);
}

std::string read(const std::string& file) { return read_file(file); }

}  // namespace

void add_scene(py::module_& module) {
  using py::arg;
  py::class_<Problem>(module, "Scene")
      .def(py::init(&parse_problem), arg("text"), arg("file"), arg("settings"))
      .def_property_readonly("title", [](const Problem& problem) { return problem->source->title; })
      .def_property_readonly("reads_tables", &reads_tables)
      .def_property_readonly("warnings",
                             [](const Problem& problem) { return problem->source->warnings; });
  module.def("read_file", &read, arg("file"));
  module.def("parameters", &parameters, arg("scene"));
  module.def("settable", &settable, arg("scene"));
  module.def("parse_value", &parse_value, arg("scene"), arg("name"), arg("text"));
  module.def("certified", &certified, arg("scene"));
  module.def("reasons", &inadmissible_reasons, arg("scene"));
  module.def("critical_onset", &onset, arg("scene"));
  module.def("in_words", &in_words, arg("scene"));
  module.def("quantity", &quantity, arg("value"), arg("unit"));
}

}  // namespace vcrit::python
