# What the libraries are linked to, one line a library. Read by the build, which also writes it into
# vcrit.pc and vcrit-symbolic.pc, and installed beside vcritConfig.cmake, which finds the same again
# for whoever links them.
#
#   vcrit_needs(COMPONENT TARGET... PACKAGE name [argument...] PKGCONFIG name)  found by find_package; LIBRARIES in place of
#     PKGCONFIG where its flags are none of those who link vcrit
#   vcrit_needs(COMPONENT TARGET PKGCONFIG name VERSION least)    has a pkg-config file and no more
#   vcrit_needs(COMPONENT TARGET HEADER file LIBRARIES name...)   has neither
#
# Only components in vcrit_components are looked for; what is not there is in
# vcrit_COMPONENT_MISSING.
macro(vcrit_needs component)
  cmake_parse_arguments(need "" "HEADER;PKGCONFIG;VERSION" "PACKAGE;LIBRARIES" ${ARGN})
  if(${component} IN_LIST vcrit_components)
    if(need_PACKAGE)
      find_package(${need_PACKAGE} QUIET)
      list(POP_FRONT need_PACKAGE need_name)
      if(NOT ${need_name}_FOUND)
        list(APPEND vcrit_${component}_MISSING ${need_name})
      endif()
    elseif(need_PKGCONFIG)
      vcrit_find_by_pkgconfig(${component} ${need_PKGCONFIG} ${need_VERSION})
    else()
      vcrit_find_by_header(${component} ${need_UNPARSED_ARGUMENTS} ${need_HEADER} ${need_LIBRARIES})
    endif()
    list(APPEND vcrit_${component}_LIBRARIES ${need_UNPARSED_ARGUMENTS})
    list(APPEND vcrit_${component}_REQUIRES ${need_PKGCONFIG})
    list(TRANSFORM need_LIBRARIES PREPEND -l)
    list(APPEND vcrit_${component}_LIBS ${need_LIBRARIES})
  endif()
endmacro()

# The target PkgConfig::NAME, its name in capitals.
macro(vcrit_find_by_pkgconfig component name version)
  string(TOUPPER ${name} need_prefix)
  find_package(PkgConfig QUIET)
  if(PkgConfig_FOUND)
    pkg_check_modules(${need_prefix} QUIET IMPORTED_TARGET ${name}>=${version})
  endif()
  if(NOT ${need_prefix}_FOUND)
    list(APPEND vcrit_${component}_MISSING "${name} ${version}")
  endif()
endmacro()

macro(vcrit_find_by_header component target header)
  find_path(${target}_INCLUDE ${header})
  set(need_files)
  foreach(library ${ARGN})
    find_library(vcrit_${library}_LIBRARY ${library})
    list(APPEND need_files ${vcrit_${library}_LIBRARY})
  endforeach()
  if(NOT ${target}_INCLUDE OR "${need_files}" MATCHES "NOTFOUND")
    list(APPEND vcrit_${component}_MISSING "${ARGN} (${header})")
  elseif(NOT TARGET ${target})
    add_library(${target} INTERFACE IMPORTED)
    target_include_directories(${target} SYSTEM INTERFACE ${${target}_INCLUDE})
    target_link_libraries(${target} INTERFACE ${need_files})
  endif()
endmacro()

vcrit_needs(numeric fmt::fmt PACKAGE fmt 9.1 PKGCONFIG fmt)
vcrit_needs(numeric GSL::gsl GSL::gslcblas PACKAGE GSL 2.7 PKGCONFIG gsl)
vcrit_needs(numeric TBB::tbb PACKAGE TBB 2021.8 PKGCONFIG tbb)
vcrit_needs(numeric tomlplusplus::tomlplusplus PACKAGE tomlplusplus 3.3 LIBRARIES tomlplusplus)  # linked, not included by users
vcrit_needs(numeric vcrit_udunits HEADER udunits2.h LIBRARIES udunits2)
vcrit_needs(numeric vcrit_arb HEADER arb.h LIBRARIES flint-arb flint gmp)  # GMP: called from FLINT's headers
vcrit_needs(symbolic PkgConfig::GINAC PKGCONFIG ginac VERSION 1.8)
