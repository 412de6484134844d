# What makes compiling quick.

# GCC starts to collect its garbage at 128 MiB and does so again and again in units of many files: a fifth of their time.
# From 1 GiB on, the largest unit takes 1.6 GiB in place of 1.3.
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  add_compile_options($<$<COMPILE_LANGUAGE:CXX>:--param=ggc-min-heapsize=1048576>)
endif()

# Files of a target compiled together. A translation unit spends its time on headers and on templates that each file
# instantiates anew; few units of many files share both and take a quarter of the time from scratch. After a change of
# one file they take longer, so the preset `dev` goes without; names are kept apart by tests/project/test_names.py.
option(VCRIT_UNITY "Compile many files in one unit: faster from scratch, slower for one changed file" OFF)

# That a format suits its arguments is checked while compiling, by code that the compiler interprets: a twentieth of its
# time. `dev` checks it; here the library only does so when it runs, as it does anyway.
if(VCRIT_UNITY)
  add_compile_definitions(FMT_CONSTEVAL=)
endif()

# vcrit_together(TARGET UNITS): in so many units, in the order of the sources. Call it when the target has them all.
function(vcrit_together target units)
  if(VCRIT_UNITY)
    get_target_property(sources ${target} SOURCES)
    list(FILTER sources INCLUDE REGEX "\\.cpp$")
    list(LENGTH sources count)
    math(EXPR batch "(${count} + ${units} - 1) / ${units}")
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${batch})
  endif()
endfunction()

# vcrit_rooms_together(TARGET ROOMS...): a unit for each argument, the rooms in it, with spaces between. A change of one
# room leaves all programs as they are, to the byte, that link to no unit of it; tests of these are not run again.
function(vcrit_rooms_together target)
  if(VCRIT_UNITY)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
    get_target_property(sources ${target} SOURCES)
    foreach(rooms IN LISTS ARGN)
      string(REPLACE " " "|" any ${rooms})
      set(unit ${sources})
      list(FILTER unit INCLUDE REGEX "^${CMAKE_CURRENT_SOURCE_DIR}/(${any})/.*\\.cpp$")
      string(MAKE_C_IDENTIFIER ${rooms} name)
      set_source_files_properties(${unit} TARGET_DIRECTORY ${target} PROPERTIES UNITY_GROUP ${name})
    endforeach()
  endif()
endfunction()

# vcrit_objects_first(LIBRARY LATER): all sources of the library but those that match LATER become LIBRARY_first, objects
# of a target of its own that are part of the library all the same: a program that needs no more links them while the
# rest is yet to be compiled.
function(vcrit_objects_first library later)
  get_target_property(sources ${library} SOURCES)
  set(first ${sources})
  list(FILTER first EXCLUDE REGEX "${later}|TARGET_OBJECTS")
  list(FILTER sources INCLUDE REGEX "${later}|TARGET_OBJECTS")
  add_library(${library}_first OBJECT ${first})
  foreach(property INCLUDE_DIRECTORIES COMPILE_DEFINITIONS COMPILE_OPTIONS LINK_LIBRARIES)
    get_target_property(value ${library} ${property})
    if(value)
      set_property(TARGET ${library}_first PROPERTY ${property} ${value})
    endif()
  endforeach()
  set_property(TARGET ${library} PROPERTY SOURCES ${sources} $<TARGET_OBJECTS:${library}_first>)
endfunction()
