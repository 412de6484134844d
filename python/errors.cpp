// The exceptions of the package, and which error of C++ becomes which.
#include "base/errors.hpp"

#include <exception>
#include <utility>

#include "bindings.hpp"
#include "interrupt.hpp"

namespace vcrit::python {

namespace py = pybind11;

namespace {

PyObject* input_error = nullptr;
PyObject* model_error = nullptr;

// Lives as long as the process, as pybind11's translators do.
PyObject* new_exception(py::module_& module, const std::string& name, const char* doc,
                        const py::object& bases) {
  PyObject* type = PyErr_NewExceptionWithDoc(("vcrit." + name).c_str(), doc, bases.ptr(), nullptr);
  if (type == nullptr) throw py::error_already_set();
  module.attr(name.c_str()) = py::reinterpret_borrow<py::object>(type);
  return type;
}

py::tuple both(PyObject* one, PyObject* other) {
  return py::make_tuple(py::reinterpret_borrow<py::object>(one),
                        py::reinterpret_borrow<py::object>(other));
}

void translate(std::exception_ptr thrown) {
  try {
    if (thrown) std::rethrow_exception(std::move(thrown));
  } catch (const InputError& error) {
    PyErr_SetString(input_error, error.what());
  } catch (const ModelError& error) {
    PyErr_SetString(model_error, error.what());
  } catch (const Interrupted&) {
    // What the signal's handler raised, KeyboardInterrupt unless the user has another, is set.
  }
}

}  // namespace

void add_errors(py::module_& module) {
  PyObject* base = new_exception(module, "Error", "What vcrit refuses, and why.",
                                 py::reinterpret_borrow<py::object>(PyExc_Exception));
  input_error = new_exception(module, "InputError",
                              "Wrong input: says where, what was found and what was expected.",
                              both(base, PyExc_ValueError));
  model_error = new_exception(module, "ModelError", "A well-formed scene outside the model.",
                              both(base, PyExc_ArithmeticError));
  py::register_exception_translator(&translate);
}

}  // namespace vcrit::python
