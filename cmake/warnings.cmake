# Every target of the project: warnings are errors, and results may be compared bit for bit.
add_library(vcrit_options INTERFACE)
target_compile_options(vcrit_options INTERFACE
  $<$<COMPILE_LANGUAGE:C,CXX>:-Wall;-Wextra;-Wconversion;-Wshadow;-Werror;-ffp-contract=off>)
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  # GCC 12 sees uninitialised members in inlined std::optional<std::string>, overlaps in "k" +
  # std::to_string(i), and copies of 2^63 bytes in a growing small_vector; none of them is there.
  target_compile_options(vcrit_options INTERFACE
    $<$<COMPILE_LANGUAGE:C,CXX>:-Wno-maybe-uninitialized;-Wno-restrict;-Wno-stringop-overread>)
endif()
