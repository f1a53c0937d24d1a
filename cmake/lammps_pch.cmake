# SPDX-License-Identifier: GPL-2.0-or-later
# Given to LAMMPS's own build as -DCMAKE_PROJECT_lammps_INCLUDE=<this file>: adds a precompiled
# header to its library without touching its sources.
set(MCAWR_PCH "$<$<COMPILE_LANGUAGE:CXX>:${CMAKE_CURRENT_LIST_DIR}/lammps_pch.h>")
cmake_language(EVAL CODE
  "cmake_language(DEFER CALL target_precompile_headers lammps PRIVATE [[${MCAWR_PCH}]])")
