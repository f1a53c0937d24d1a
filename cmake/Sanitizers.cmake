# SPDX-License-Identifier: GPL-2.0-or-later
# A finding ends the program with an error, so that a test fails.
option(SANITIZE "build with AddressSanitizer and UndefinedBehaviorSanitizer" OFF)
if(SANITIZE)
  add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer -g)
  add_link_options(-fsanitize=address,undefined)
endif()
