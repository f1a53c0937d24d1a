# SPDX-License-Identifier: GPL-2.0-or-later
# A finding ends the program with an error, so that a test fails.
option(SANITIZE "build with AddressSanitizer and UndefinedBehaviorSanitizer" OFF)
# How many times its usual limit a test may take; the tests' own waiting follows it, too.
set(time_factor 1)
if(SANITIZE)
  set(time_factor 10)
  # -Og: a third of the compile time of -O2. -g1: lines, but no variables, in backtraces
  add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=undefined
                      -fno-omit-frame-pointer -Og -g1)
  add_link_options(-fsanitize=address,undefined)
endif()

# time_limit(VARIABLE SECONDS): the limit of a test that has these seconds without sanitizers
function(time_limit variable seconds)
  math(EXPR value "${seconds} * ${time_factor}")
  set(${variable} ${value} PARENT_SCOPE)
endfunction()
