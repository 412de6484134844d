# Every target of the project: warnings are errors, and results may be compared bit for bit.
add_library(vcrit_options INTERFACE)
target_compile_options(vcrit_options INTERFACE
  $<$<COMPILE_LANGUAGE:CXX>:-Wall;-Wextra;-Wconversion;-Wshadow;-Werror;-ffp-contract=off>)
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  # GCC 12 sees uninitialised members in inlined std::optional<std::string>, and overlaps in "k" +
  # std::to_string(i); neither is there.
  target_compile_options(vcrit_options INTERFACE $<$<COMPILE_LANGUAGE:CXX>:-Wno-maybe-uninitialized;-Wno-restrict>)
endif()
