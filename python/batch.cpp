// Eq. 24 over arrays. The GIL is released while C++ works on them, where they lie.
#include "critical/batch.hpp"

#include <pybind11/stl.h>

#include "arrays.hpp"
#include "bindings.hpp"

namespace vcrit::python {

namespace py = pybind11;

namespace {

void evaluate_columns(const CriticalVelocities& formula, const std::vector<Array>& columns,
                      Array out) {
  const std::span<double> velocities = values(out);
  std::vector<std::span<const double>> inputs;
  for (const Array& column : columns) {
    inputs.push_back(values(column));
    ensure(column.size() == 1 || column.size() == out.size(), "a column has one value or all");
  }
  const py::gil_scoped_release others_run;
  formula(inputs, velocities);
}

}  // namespace

void add_batch(py::module_& module) {
  using py::arg;
  py::class_<CriticalVelocities>(module, "CriticalVelocities")
      .def(py::init<const Scene&, std::vector<std::string>>(), arg("scene"), arg("varying"))
      .def("__call__", &evaluate_columns, arg("columns").noconvert(), arg("out").noconvert());
}

}  // namespace vcrit::python
