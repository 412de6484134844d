// What amplitude, frequency or speed reaches a friction ratio, as `vcrit solve` finds it.
#include "design/solve.hpp"

#include <fmt/core.h>
#include <pybind11/stl.h>

#include "base/constants.hpp"
#include "base/joined.hpp"
#include "bindings.hpp"
#include "interrupt.hpp"

namespace vcrit::python {

namespace py = pybind11;

namespace {

using design::Sought;

Sought sought_named(const std::string& name) {
  std::vector<std::string> names;
  for (const Sought sought : design::all_sought) {
    if (name == to_text(sought)) return sought;
    names.emplace_back(to_text(sought));
  }
  throw InputError(argument("for"), '"' + name + '"',
                   fmt::format("one of {}", joined(names, ", ")));
}

std::optional<double> end_of_range(const std::string& text, Sought sought, const char* name) {
  if (text.empty()) return std::nullopt;
  return parse_quantity(text, dimension_of(sought), argument(name));
}

/// The smallest frequency is known to be it, because all below it were searched.
std::optional<std::string> warning_of_range(const design::DesignQuestion& question,
                                            const design::DesignAnswer& answer) {
  if (question.sought != Sought::frequency) return std::nullopt;
  return beyond_fitted_range(question.problem, two_pi * answer.from, two_pi * answer.value);
}

py::dict as_dict(const design::DesignQuestion& question, const design::DesignAnswer& answer) {
  using py::arg;
  return py::dict(arg("sought") = to_text(question.sought), arg("value") = answer.value,
                  arg("unit") = unit_of(question.sought), arg("value_error") = answer.value_error,
                  arg("at_start") = answer.at_start,
                  arg("friction_ratio") = answer.state.friction_ratio,
                  arg("friction_ratio_error") = answer.state.friction_ratio_error,
                  arg("regime") = to_text(answer.state.regime), arg("velocity") = answer.velocity,
                  arg("critical_velocity") = answer.critical_velocity,
                  arg("largest_amplitude") = answer.largest_amplitude,
                  arg("largest_frequency") = answer.largest_frequency,
                  arg("searched") = py::make_tuple(answer.from, answer.to),
                  arg("evaluations") = answer.evaluations, arg("unanswered") = answer.unanswered);
}

py::tuple solved(const Problem& problem, const std::string& name, double friction_ratio,
                 const std::string& velocity, const std::string& from, const std::string& to,
                 std::optional<int> samples) {
  const Sought sought = sought_named(name);
  design::DesignQuestion question{problem,
                                  sought,
                                  friction_ratio,
                                  0,
                                  end_of_range(from, sought, "from"),
                                  end_of_range(to, sought, "to"),
                                  samples};
  if (!velocity.empty())
    question.velocity = parse_quantity(velocity, Dimension::velocity, argument("velocity"));
  const design::DesignAnswer answer = [&] {
    const OthersRun others_run;
    return design::solve(question);
  }();
  return py::make_tuple(as_dict(question, answer), warning_of_range(question, answer));
}

}  // namespace

void add_solve(py::module_& module) {
  using py::arg;
  module.def("solve", &solved, arg("scene"), arg("sought"), arg("friction_ratio"), arg("velocity"),
             arg("from_"), arg("to"), arg("samples"));
}

}  // namespace vcrit::python
