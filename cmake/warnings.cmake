# Every target of the project: warnings are errors, and results may be compared bit for bit.
add_library(vcrit_options INTERFACE)
target_compile_options(vcrit_options INTERFACE -Wall -Wextra -Wconversion -Wshadow -Werror -ffp-contract=off)
