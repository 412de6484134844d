// Contiguous arrays of float64, which C++ works on where they lie.
#pragma once

#include <pybind11/numpy.h>

#include <cstddef>
#include <span>

namespace vcrit::python {

using Array = pybind11::array_t<double, pybind11::array::c_style>;

inline std::span<const double> values(const Array& array) {
  return {array.data(), static_cast<std::size_t>(array.size())};
}

inline std::span<double> values(Array& array) {
  return {array.mutable_data(), static_cast<std::size_t>(array.size())};
}

}  // namespace vcrit::python
