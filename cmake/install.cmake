# The installed package: program, libraries, vcritConfig.cmake and pkg-config files. Nothing in it names
# the place it is installed to, so that it may be moved.
include(CMakePackageConfigHelpers)
set(package ${CMAKE_INSTALL_LIBDIR}/cmake/vcrit)
set(pkgconfig ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

# vcrit_install_library(COMPONENT NAME): the library as vcrit::NAME, and PKGCONFIG.pc.
function(vcrit_install_library component name pkgconfig_name)
  set_target_properties(vcrit_${component} PROPERTIES EXPORT_NAME ${name})
  install(TARGETS vcrit_${component} EXPORT vcrit_${component}
          ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT ${component})
  install(EXPORT vcrit_${component} NAMESPACE vcrit:: FILE vcrit-${component}.cmake
          DESTINATION ${package} COMPONENT ${component})
  string(JOIN " " REQUIRES ${vcrit_${component}_REQUIRES} ${ARGN})
  string(JOIN " " LIBS ${vcrit_${component}_LIBS})
  get_target_property(LIBRARY vcrit_${component} OUTPUT_NAME)
  file(RELATIVE_PATH UP /${pkgconfig} /)
  configure_file(cmake/vcrit.pc.in ${pkgconfig_name}.pc @ONLY)
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/${pkgconfig_name}.pc DESTINATION ${pkgconfig}
          COMPONENT ${component})
endfunction()

vcrit_install_library(numeric vcrit vcrit)
vcrit_install_library(symbolic symbolic vcrit-symbolic vcrit)

configure_file(cmake/vcritConfig.cmake.in vcritConfig.cmake @ONLY)
write_basic_package_version_file(vcritConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/vcritConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/vcritConfigVersion.cmake
              cmake/dependencies.cmake DESTINATION ${package} COMPONENT numeric)

install(TARGETS vcrit RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
install(FILES ${CMAKE_BINARY_DIR}/share/man/man1/vcrit.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program)
install(FILES ${CMAKE_BINARY_DIR}/share/bash-completion/completions/vcrit
        DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT program)
install(FILES ${CMAKE_BINARY_DIR}/share/zsh/site-functions/_vcrit
        DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions COMPONENT program)

# As they lie in the sources, so that the links of README.md hold.
install(FILES README.md CITATION.cff CONTRIBUTING.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
install(FILES LICENSES/GPL-3.0-or-later.txt RENAME LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
install(DIRECTORY docs scenes examples DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program
        FILES_MATCHING PATTERN *.md PATTERN *.svg PATTERN *.toml PATTERN *.csv PATTERN *.c PATTERN *.cpp PATTERN *.py
        PATTERN CMakeLists.txt)

# What `cmake --install` takes; every command of ./dev that builds this folder builds it.
add_custom_target(vcrit_installed)
add_dependencies(vcrit_installed vcrit vcrit_numeric vcrit_symbolic)
if(VCRIT_PYTHON)
  add_dependencies(vcrit_installed _vcrit)
endif()
