# Writes OUTPUT, a C++ file with the commit that is built: run at each build, so that it is never an old one; the file
# changes only when the commit does. It has the same length for all commits, so that programs of two commits differ in
# nothing else (tests/support/run_changed.py).
execute_process(COMMAND git -C ${SOURCE} describe --always --abbrev=12 --dirty=+ "--exclude=*"
                OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE status)
if(NOT status EQUAL 0 OR NOT commit MATCHES "^[0-9a-f]+[+]?$")
  set(commit "unknown")
endif()
string(LENGTH "${commit}" length)
math(EXPR missing "13 - ${length}")
string(REPEAT " " ${missing} blanks)
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT
     "extern const char vcrit_commit_text[];\nconst char vcrit_commit_text[] = \"vcrit's commit: ${commit}${blanks}\";\n")
