# The Python module is for the system's own Python (Debian's, with its NumPy), not for one that
# happens to come first on the PATH. VCRIT_PYTHON says whether it is built.
if(NOT DEFINED Python_EXECUTABLE)
  set(Python_EXECUTABLE /usr/bin/python3)
endif()
set(PYBIND11_FINDPYTHON ON)
find_package(Python 3.10 COMPONENTS Interpreter Development.Module QUIET)
if(Python_Development.Module_FOUND)
  find_package(pybind11 2.10 CONFIG QUIET)
endif()
option(VCRIT_PYTHON "Build the Python module" ${pybind11_FOUND})
if(VCRIT_PYTHON AND NOT pybind11_FOUND)
  message(FATAL_ERROR "VCRIT_PYTHON needs pybind11 and the headers of ${Python_EXECUTABLE}")
endif()
