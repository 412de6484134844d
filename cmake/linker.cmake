# Programs are linked by the fastest linker that is installed.
include(CheckLinkerFlag)
foreach(linker lld gold)
  check_linker_flag(CXX -fuse-ld=${linker} VCRIT_LINKS_WITH_${linker})
  if(VCRIT_LINKS_WITH_${linker})
    add_link_options($<$<STREQUAL:$<TARGET_PROPERTY:TYPE>,EXECUTABLE>:-fuse-ld=${linker}>)
    break()
  endif()
endforeach()
