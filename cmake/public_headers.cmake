# Headers for users of the libraries: under include/vcrit, where they include each other as
# "vcrit/...", so that nothing of a user's own can come in between. They are in ${CMAKE_BINARY_DIR}/include
# as they will be installed; examples and reference are built from there.

# vcrit_public_headers(COMPONENT FACADE WORDS HEADER...): the headers, from the current folder, and one
# that includes them all and opens with the words.
function(vcrit_public_headers component facade words)
  set(folder ${CMAKE_BINARY_DIR}/include/vcrit)
  set(script ${PROJECT_SOURCE_DIR}/cmake/public_header.cmake)
  set(copies ${ARGN})
  list(TRANSFORM copies PREPEND ${folder}/)
  set(includes "")
  foreach(header IN LISTS ARGN)
    add_custom_command(OUTPUT ${folder}/${header} DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${header} ${script}
                       COMMAND ${CMAKE_COMMAND} -DFROM=${CMAKE_CURRENT_SOURCE_DIR}/${header}
                               -DTO=${folder}/${header} -P ${script} VERBATIM)
    vcrit_install_header(${component} ${header})
    string(APPEND includes "#include \"vcrit/${header}\"\n")
  endforeach()
  file(CONFIGURE OUTPUT ${folder}/${facade} CONTENT "// ${words}\n#pragma once\n\n${includes}" @ONLY)
  vcrit_install_header(${component} ${facade})
  add_custom_target(vcrit_${component}_headers DEPENDS ${copies})
  add_dependencies(vcrit_${component} vcrit_${component}_headers)
endfunction()

function(vcrit_install_header component header)
  cmake_path(GET header PARENT_PATH room)
  install(FILES ${CMAKE_BINARY_DIR}/include/vcrit/${header}
          DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/vcrit/${room} COMPONENT ${component})
endfunction()

configure_file(docs/Doxyfile.in docs/Doxyfile @ONLY)
