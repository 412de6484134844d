// The exceptions of the package, and which error of C++ becomes which.
#include <exception>
#include <utility>

#include "base/arguments.hpp"
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

// Names of files need not be UTF-8.
py::object text(const std::string& bytes) {
  return py::reinterpret_steal<py::object>(
      PyUnicode_DecodeUTF8(bytes.data(), static_cast<Py_ssize_t>(bytes.size()), "surrogateescape"));
}

py::object text_or_none(const std::string& bytes) {
  return bytes.empty() ? py::none() : text(bytes);
}

py::object place_of(const Place& place) {
  const auto known = [](int number) {
    return number > 0 ? py::object(py::int_(number)) : py::object(py::none());
  };
  return py::make_tuple(text(place.argument.empty() ? place.file : place.argument),
                        known(place.line), known(place.column));
}

void raise(PyObject* type, const std::exception& error, const std::string& advice,
           const InputError* input = nullptr) {
  const py::object raised = py::reinterpret_borrow<py::object>(type)(text(error.what()));
  raised.attr("advice") = text_or_none(advice);
  raised.attr("place") = input != nullptr ? place_of(input->place()) : py::none();
  raised.attr("found") = input != nullptr ? text(input->found()) : py::none();
  raised.attr("expected") = input != nullptr ? text(input->expected()) : py::none();
  PyErr_SetObject(type, raised.ptr());
}

// "velocity", "k1" of "set k1", "from_" of "from", which Python keeps for itself.
std::string python_name(const std::string& argument) {
  const std::size_t space = argument.find(' ');
  const std::string key = argument.substr(0, space);
  const std::string rest = space == argument.npos ? "" : argument.substr(space + 1);
  if (key == "set") return rest.find('=') == rest.npos ? rest : "with_values(" + rest + ")";
  if (key == "for") return "sought";
  if (argument == "from") return "from_";
  if (argument == "from, to") return "from_, to";
  return argument;
}

void translate(std::exception_ptr thrown) {
  try {
    if (thrown) std::rethrow_exception(std::move(thrown));
  } catch (const InputError& error) {
    const InputError words = spelled(error, python_name);
    raise(input_error, words, words.advice(), &words);
  } catch (const ModelError& error) {
    const ModelError words = spelled(error, python_name);
    raise(model_error, words, words.advice());
  } catch (const Interrupted&) {
    // What the signal's handler raised, KeyboardInterrupt unless the user has another, is set.
  }
}

}  // namespace

std::vector<std::string> with_python_names(std::vector<std::string> texts) {
  for (std::string& text : texts) text = spelled(text, python_name);
  return texts;
}

void add_errors(py::module_& module) {
  PyObject* base = new_exception(module, "Error", "What vcrit refuses, and why.",
                                 py::reinterpret_borrow<py::object>(PyExc_Exception));
  for (const char* part : {"place", "found", "expected", "advice"})
    module.attr("Error").attr(part) = py::none();  // where they are not known
  input_error = new_exception(module, "InputError",
                              "Wrong input: says where, what was found and what was expected.",
                              both(base, PyExc_ValueError));
  model_error = new_exception(module, "ModelError", "A well-formed scene outside the model.",
                              both(base, PyExc_ArithmeticError));
  py::register_exception_translator(&translate);
}

}  // namespace vcrit::python
