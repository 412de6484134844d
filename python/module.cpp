// The extension module vcrit._vcrit.
#include "bindings.hpp"

PYBIND11_MODULE(_vcrit, module) {
  module.doc() = "What vcrit does in C++; use it through the package vcrit.";
  module.attr("version") = VCRIT_VERSION;
  vcrit::python::add_errors(module);
  vcrit::python::add_scene(module);
  vcrit::python::add_batch(module);
  vcrit::python::add_friction(module);
  vcrit::python::add_solve(module);
  vcrit::python::add_sweep(module);
  vcrit::python::add_fit(module);
  vcrit::python::add_pictures(module);
  vcrit::python::add_derivation(module);
}
