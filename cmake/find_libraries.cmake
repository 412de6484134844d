# Debian ships these two without a CMake package or a pkg-config file of their own.
function(vcrit_library target header library)
  find_path(${target}_INCLUDE ${header} REQUIRED)
  find_library(${target}_LIBRARY ${library} REQUIRED)
  add_library(${target} INTERFACE IMPORTED)
  target_include_directories(${target} SYSTEM INTERFACE ${${target}_INCLUDE})
  target_link_libraries(${target} INTERFACE ${${target}_LIBRARY} ${ARGN})
endfunction()

find_library(FLINT_LIBRARY flint REQUIRED)
find_library(GMP_LIBRARY gmp REQUIRED)  # called from FLINT's headers
vcrit_library(vcrit_udunits udunits2.h udunits2)
vcrit_library(vcrit_arb arb.h flint-arb ${FLINT_LIBRARY} ${GMP_LIBRARY})
