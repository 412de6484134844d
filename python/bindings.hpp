// The parts of the extension module vcrit._vcrit. It holds what must be C++ and takes plain
// numbers, texts and contiguous float64 arrays; what a user of Python sees is made of it in
// python/vcrit.
#pragma once

#include <pybind11/pybind11.h>

namespace vcrit::python {

/// vcrit.Error, InputError and ModelError, with the texts that the program prints.
void add_errors(pybind11::module_& module);

/// A scene, what it names, and its one critical velocity.
void add_scene(pybind11::module_& module);

/// v* over contiguous arrays. Releases the GIL.
void add_batch(pybind11::module_& module);

/// The steady stick-slip motion. Releases the GIL.
void add_friction(pybind11::module_& module);

/// The derivation as `vcrit derive` prints it, one at a time. Releases the GIL.
void add_derivation(pybind11::module_& module);

}  // namespace vcrit::python
