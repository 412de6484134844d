# vcrit_knows_commit(TARGET FILE): FILE of TARGET, in the folder that asks, is compiled with VCRIT_COMMIT_FILE, which holds
# the commit as a string literal, and again when that is another one.
set(vcrit_commit_file ${PROJECT_BINARY_DIR}/commit.inc)
add_custom_target(vcrit_commit BYPRODUCTS ${vcrit_commit_file}
                  COMMAND ${CMAKE_COMMAND} -DSOURCE=${PROJECT_SOURCE_DIR} -DOUTPUT=${vcrit_commit_file}
                          -P ${PROJECT_SOURCE_DIR}/cmake/commit.cmake)

function(vcrit_knows_commit target file)
  add_dependencies(${target} vcrit_commit)
  set_property(SOURCE ${file} TARGET_DIRECTORY ${target} APPEND PROPERTY COMPILE_DEFINITIONS VCRIT_COMMIT_FILE="${vcrit_commit_file}")
  set_property(SOURCE ${file} TARGET_DIRECTORY ${target} APPEND PROPERTY OBJECT_DEPENDS ${vcrit_commit_file})
endfunction()
