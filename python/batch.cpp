// Eq. 24 over arrays. The GIL is released while C++ works on them, where they lie.
#include "critical/batch.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "bindings.hpp"

namespace vcrit::python {

namespace py = pybind11;

namespace {

using Array = py::array_t<double, py::array::c_style>;

void evaluate(const CriticalVelocities& formula, const std::vector<Array>& columns, Array out) {
  const std::span<double> velocities{out.mutable_data(), static_cast<std::size_t>(out.size())};
  std::vector<std::span<const double>> values;
  for (const Array& column : columns) {
    values.emplace_back(column.data(), static_cast<std::size_t>(column.size()));
    ensure(column.size() == 1 || column.size() == out.size(), "a column has one value or all");
  }
  const py::gil_scoped_release others_run;
  formula(values, velocities);
}

}  // namespace

void add_batch(py::module_& module) {
  using py::arg;
  py::class_<CriticalVelocities>(module, "CriticalVelocities")
      .def(py::init<const Scene&, std::vector<std::string>>(), arg("scene"), arg("varying"))
      .def("__call__", &evaluate, arg("columns").noconvert(), arg("out").noconvert());
}

}  // namespace vcrit::python
