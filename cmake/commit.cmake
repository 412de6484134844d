# Writes OUTPUT, a C++ string literal of the commit that is built: run at each build, so that it is
# never an old one; the file changes only when the commit does.
execute_process(COMMAND git -C ${SOURCE} describe --always --abbrev=12 --dirty=+ "--exclude=*"
                OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE status)
if(NOT status EQUAL 0 OR NOT commit MATCHES "^[0-9a-f]+[+]?$")
  set(commit "unknown")
endif()
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT "\"${commit}\"\n")
