// Long work in C++: other Python threads run meanwhile, and Ctrl-C ends it.
#pragma once

#include <pybind11/pybind11.h>

#include "base/interruption.hpp"

namespace vcrit::python {

/// Thrown through C++ where Ctrl-C was pressed; Python's own exception is set already. Not one of
/// std::exception, which some work answers to.
struct Interrupted {};

/// For a scope without Python objects: lets go of the interpreter.
class OthersRun {
 public:
  OthersRun();

 private:
  pybind11::gil_scoped_release release_;
  Interruptible interruptible_;
};

}  // namespace vcrit::python
