// Quantities over a grid of parameters, as `vcrit sweep` finds them, in memory.
#include "sweep/sweep.hpp"

#include <pybind11/stl.h>

#include <algorithm>

#include "arrays.hpp"
#include "base/constants.hpp"
#include "bindings.hpp"
#include "interrupt.hpp"

namespace vcrit::python {

namespace py = pybind11;

namespace {

Axis axis_of_array(const Problem& problem, const std::string& name, const Array& given) {
  const std::span<const double> all = values(given);
  return axis_of(name, {all.begin(), all.end()}, problem);
}

Axis axis_of_text(const Problem& problem, const std::string& text) {
  return parse_axis(text, problem);
}

/// Frequencies beyond the data that a scene was fitted to.
std::vector<std::string> warnings_of_axes(const Sweep& sweep) {
  std::vector<std::string> all;
  for (const Axis& axis : sweep.axes) {
    const auto named = sweep.problem->source->named.find(axis.name);
    if (named == sweep.problem->source->named.end() || axis.values.empty()) continue;
    const bool hertz = named->second == frequency_symbol;
    if (!hertz && named->second != sweep.problem->angular_frequency.symbol) continue;
    const double factor = hertz ? two_pi : 1;
    const auto [least, most] = std::minmax_element(axis.values.begin(), axis.values.end());
    if (const auto beyond = beyond_fitted_range(sweep.problem, factor * *least, factor * *most))
      all.push_back(*beyond);
  }
  return all;
}

py::list descriptions(const std::vector<SweptQuantity>& quantities) {
  py::list all;
  for (const SweptQuantity& quantity : quantities)
    all.append(py::make_tuple(column_name(quantity), unit(quantity), words(quantity),
                              first_flag(quantity)));
  return all;
}

std::optional<double> speed_of(const std::string& text, Dimension dimension, const char* name) {
  if (text.empty()) return std::nullopt;
  return parse_quantity(text, dimension, argument(name));
}

/// The table, what its columns of quantities are, rows outside the model and why the first is,
/// and warnings.
py::tuple swept_table(const Problem& problem, const std::vector<Axis>& axes,
                      const std::vector<std::string>& quantities, const std::string& velocity,
                      const std::string& velocity_ratio) {
  Sweep sweep{problem, axes, {}, {}, {}};
  for (const std::string& name : quantities)
    sweep.quantities.push_back(parse_swept_quantity(name, problem));
  sweep.velocity = speed_of(velocity, Dimension::velocity, "velocity");
  sweep.velocity_ratio = speed_of(velocity_ratio, Dimension::none, "velocity_ratio");
  const SweptTable table = [&] {
    const OthersRun others_run;
    return swept(sweep);
  }();
  Array numbers({table.rows, table.columns.size()});
  std::copy(table.values.begin(), table.values.end(), values(numbers).begin());
  return py::make_tuple(numbers, descriptions(sweep.quantities), table.outside, table.reason,
                        warnings_of_axes(sweep));
}

}  // namespace

void add_sweep(py::module_& module) {
  using py::arg;
  py::class_<Axis>(module, "Axis")
      .def_readonly("name", &Axis::name)
      .def_property_readonly("unit", [](const Axis& axis) { return si_unit(axis.dimension); })
      .def_readonly("values", &Axis::values);
  module.def("axis_of_array", &axis_of_array, arg("scene"), arg("name"), arg("values").noconvert());
  module.def("axis_of_text", &axis_of_text, arg("scene"), arg("text"));
  module.def("sweep", &swept_table, arg("scene"), arg("axes"), arg("quantities"), arg("velocity"),
             arg("velocity_ratio"));
}

}  // namespace vcrit::python
