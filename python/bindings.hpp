// The parts of the extension module vcrit._vcrit. It holds what must be C++ and takes plain
// numbers, texts and contiguous float64 arrays; what a user of Python sees is made of it in
// python/vcrit.
#pragma once

#include <pybind11/pybind11.h>

#include <string>
#include <vector>

namespace vcrit::python {

/// Texts of a library with its arguments (base/arguments.hpp) as they are called in Python.
std::vector<std::string> with_python_names(std::vector<std::string> texts);

/// vcrit.Error, InputError and ModelError, with the texts that the program prints.
void add_errors(pybind11::module_& module);

/// A scene, what it names, its one critical velocity, and what vibration does to it in words.
void add_scene(pybind11::module_& module);

/// v* over contiguous arrays. Releases the GIL.
void add_batch(pybind11::module_& module);

/// The steady stick-slip motion. Releases the GIL.
void add_friction(pybind11::module_& module);

/// What reaches a friction ratio. Releases the GIL.
void add_solve(pybind11::module_& module);

/// Quantities over a grid, on all cores. Releases the GIL.
void add_sweep(pybind11::module_& module);

/// A Prony series from measured stiffness. Releases the GIL.
void add_fit(pybind11::module_& module);

/// Pictures of a scene. Releases the GIL.
void add_pictures(pybind11::module_& module);

/// The derivation as `vcrit derive` prints it, one at a time. Releases the GIL.
void add_derivation(pybind11::module_& module);

}  // namespace vcrit::python
