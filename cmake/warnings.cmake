# SPDX-License-Identifier: MIT
# stad_warnings(TARGET): the warnings every C file of the project is clean under.
function(stad_warnings target)
  target_compile_options(${target} PRIVATE
    $<$<COMPILE_LANGUAGE:C>:-pedantic -Wall -Wextra -Wconversion -Wshadow -Wmissing-prototypes -Wstrict-prototypes>
    $<$<COMPILE_LANGUAGE:CXX>:-Wall -Wextra -Wshadow>
    $<$<BOOL:${STAD_WERROR}>:-Werror>)
  set_target_properties(${target} PROPERTIES C_STANDARD 99 C_STANDARD_REQUIRED ON C_EXTENSIONS OFF)
endfunction()
