# Debian packages, by cpack in the build folder: the program, the libraries, and, where the prefix is /usr
# (Python's folder for packages depends on it), the Python module.
foreach(package vcrit:program libvcrit-dev:numeric python3-vcrit:python)
  string(REGEX MATCH "(.*):(.*)" package ${package})
  if(VCRIT_PYTHON OR NOT CMAKE_MATCH_2 STREQUAL python)
    install(FILES cmake/package/copyright CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${CMAKE_MATCH_1}
            COMPONENT ${CMAKE_MATCH_2})
  endif()
endforeach()

set(CPACK_GENERATOR DEB)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGE_CONTACT "The vcrit authors <authors@vcrit.invalid>")
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_VERBATIM_VARIABLES ON)

set(CPACK_COMPONENTS_ALL program numeric symbolic)
if(VCRIT_PYTHON AND CMAKE_INSTALL_PREFIX STREQUAL /usr)
  list(APPEND CPACK_COMPONENTS_ALL python)
endif()

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME vcrit)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS g++)  # reports compile the evaluators that they check
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS gnuplot-nox)

set(CPACK_DEBIAN_DEV_PACKAGE_NAME libvcrit-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
string(CONCAT CPACK_DEBIAN_DEV_PACKAGE_DEPENDS
  "libfmt-dev, libgsl-dev, libtbb-dev, libtomlplusplus-dev, libudunits2-dev, libflint-arb-dev, libflint-dev, "
  "libgmp-dev, libginac-dev")

set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-vcrit)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
math(EXPR after "${Python_VERSION_MINOR} + 1")
string(CONCAT CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
  "python3 (>= ${Python_VERSION_MAJOR}.${Python_VERSION_MINOR}), python3 (<< ${Python_VERSION_MAJOR}.${after}), "
  "python3-numpy")

include(CPack)
cpack_add_component(program DESCRIPTION "the program vcrit: formulas, numbers, code and reports")
cpack_add_component_group(dev DESCRIPTION "the C++ libraries of vcrit")
cpack_add_component(numeric GROUP dev)
cpack_add_component(symbolic GROUP dev)
cpack_add_component(python DESCRIPTION "vcrit for Python")
