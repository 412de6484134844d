# vcrit_templates(TARGET NAME): the files templates/*.mustache of the folder that asks become part of TARGET, between the
# symbols vcrit_NAME and vcrit_NAME_end: of each its name, a zero, its text, a zero (src/record/template.hpp reads that).
function(vcrit_templates target name)
  file(GLOB files CONFIGURE_DEPENDS templates/*.mustache)
  set(assembly "  .section .rodata\n  .global vcrit_${name}, vcrit_${name}_end\nvcrit_${name}:\n")
  foreach(file ${files})
    cmake_path(GET file STEM stem)
    string(APPEND assembly "  .asciz \"${stem}\"\n  .incbin \"${file}\"\n  .byte 0\n")
  endforeach()
  set(output ${CMAKE_CURRENT_BINARY_DIR}/${name}.s)
  file(CONFIGURE OUTPUT ${output}
       CONTENT "${assembly}vcrit_${name}_end:\n  .section .note.GNU-stack, \"\", @progbits\n")
  target_sources(${target} PRIVATE ${output})
  set_source_files_properties(${output} TARGET_DIRECTORY ${target} PROPERTIES OBJECT_DEPENDS "${files}")
endfunction()
