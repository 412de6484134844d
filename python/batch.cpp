// v* over arrays. The GIL is released while C++ works on them, where they lie.
#include <pybind11/stl.h>

#include <utility>

#include "answers/critical_onsets.hpp"
#include "arrays.hpp"
#include "bindings.hpp"
#include "interrupt.hpp"

namespace vcrit::python {

namespace py = pybind11;

namespace {

std::vector<std::span<const double>> spans(const std::vector<Array>& columns) {
  std::vector<std::span<const double>> all;
  for (const Array& column : columns) all.push_back(values(column));
  return all;
}

void evaluate_columns(const CriticalOnsets& formula, const std::vector<Array>& columns, Array out) {
  const std::span<double> velocities = values(out);
  const auto inputs = spans(columns);
  const OthersRun others_run;
  formula(inputs, velocities);
}

// Index and reason.
std::optional<std::pair<std::size_t, std::string>> first_refused(const CriticalOnsets& formula,
                                                                 const std::vector<Array>& columns,
                                                                 std::size_t lanes) {
  const auto inputs = spans(columns);
  const OthersRun others_run;
  const auto refused = formula.first_refused(inputs, lanes);
  if (!refused) return std::nullopt;
  return std::pair(refused->lane, refused->why);
}

}  // namespace

void add_batch(py::module_& module) {
  using py::arg;
  py::class_<CriticalOnsets>(module, "CriticalVelocities")
      .def(py::init<const Problem&, std::vector<std::string>>(), arg("scene"), arg("varying"))
      .def("__call__", &evaluate_columns, arg("columns").noconvert(), arg("out").noconvert())
      .def("first_refused", &first_refused, arg("columns").noconvert(), arg("lanes"));
}

}  // namespace vcrit::python
