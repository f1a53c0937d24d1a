# SPDX-License-Identifier: GPL-2.0-or-later
# The LAMMPS that the plugin is built for and run with. In this order:
#   LAMMPS_ROOT        a tree with src/ and a built lmp (as made by tools/get_lammps.sh, or a user's)
#   LAMMPS_SOURCE_DIR  a source tree or its src/; LMP_EXECUTABLE says which lmp belongs to it
#   neither            tools/get_lammps.sh obtains and builds LAMMPS_RELEASE, once, in its cache
#                      (from LAMMPS_TARBALL if that is given)
# Gives: target lammps_headers, LAMMPS_SOURCE_DIR (the src/ folder), LAMMPS_VERSION (20250204),
# LMP_EXECUTABLE, and build/bin/lmp, which runs that lmp with the plugin loaded.
set(LAMMPS_ROOT "" CACHE PATH "LAMMPS tree with src/ and a built lmp")
set(LAMMPS_SOURCE_DIR "" CACHE PATH "LAMMPS source tree, or its src/")
set(LAMMPS_TARBALL "" CACHE FILEPATH "Debian's lammps_*.orig.tar.?z, instead of downloading it")
set(LAMMPS_RELEASE 20250204 CACHE STRING "release that tools/get_lammps.sh obtains")
set(LMP_EXECUTABLE "" CACHE FILEPATH "the lmp for runs and tests, built from LAMMPS_SOURCE_DIR")
option(MCAWR_NATIVE "compile the plugin for this machine's processor only (-march=native)" OFF)

# ---- source and lmp
set(_lmp "${LMP_EXECUTABLE}")
if(LAMMPS_ROOT)
  set(_root "${LAMMPS_ROOT}")
elseif(NOT LAMMPS_SOURCE_DIR)
  set(_get "${PROJECT_SOURCE_DIR}/tools/get_lammps.sh")
  set(_args --version ${LAMMPS_RELEASE})
  if(LAMMPS_TARBALL)
    list(APPEND _args --tarball "${LAMMPS_TARBALL}")
  endif()
  execute_process(COMMAND "${_get}" ${_args} RESULT_VARIABLE _rc OUTPUT_VARIABLE _root
                  OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(NOT _rc EQUAL 0)
    message(FATAL_ERROR "tools/get_lammps.sh failed, see its message above. Or give an existing "
            "LAMMPS by -DLAMMPS_ROOT=DIR, or -DLAMMPS_SOURCE_DIR=DIR -DLMP_EXECUTABLE=FILE.")
  endif()
else()
  set(_root "")
endif()

set(_src "")
foreach(_dir "${LAMMPS_SOURCE_DIR}" "${LAMMPS_SOURCE_DIR}/src" "${_root}/src" "${_root}")
  if(EXISTS "${_dir}/version.h" AND EXISTS "${_dir}/lammpsplugin.h")
    set(_src "${_dir}")
    break()
  endif()
endforeach()
if(NOT _src)
  message(FATAL_ERROR "no LAMMPS source (version.h and lammpsplugin.h) in "
          "LAMMPS_ROOT '${LAMMPS_ROOT}' or LAMMPS_SOURCE_DIR '${LAMMPS_SOURCE_DIR}', nor in their "
          "src/. Installed headers are not enough for a plugin: give the source tree.")
endif()
set(LAMMPS_SOURCE_DIR "${_src}")

if(NOT _lmp)
  if(NOT _root)
    cmake_path(GET _src PARENT_PATH _root)
  endif()
  foreach(_file build/lmp bin/lmp lmp src/lmp src/lmp_mpi)
    if(EXISTS "${_root}/${_file}")
      set(_lmp "${_root}/${_file}")
      break()
    endif()
  endforeach()
endif()
if(NOT _lmp AND BUILD_TESTING)
  message(FATAL_ERROR "no lmp in '${_root}' (tried build/lmp, bin/lmp, lmp, src/lmp, src/lmp_mpi). "
          "The tests need the one built from this source, with PLUGIN and MPI: give "
          "-DLMP_EXECUTABLE=FILE, or build the plugin alone with -DBUILD_TESTING=OFF.")
endif()

# ---- version, integer sizes
file(STRINGS "${LAMMPS_SOURCE_DIR}/version.h" _line REGEX "define LAMMPS_VERSION ")
if(NOT _line MATCHES "\"([0-9]+) ([A-Z][a-z][a-z])[a-z]* ([0-9]+)\"")
  message(FATAL_ERROR "no date in ${LAMMPS_SOURCE_DIR}/version.h: '${_line}'")
endif()
set(_date "${CMAKE_MATCH_1} ${CMAKE_MATCH_2} ${CMAKE_MATCH_3}")
set(_day ${CMAKE_MATCH_1})
set(_year ${CMAKE_MATCH_3})
set(_months 0 Jan Feb Mar Apr May Jun Jul Aug Sep Oct Nov Dec)
list(FIND _months ${CMAKE_MATCH_2} _month)
math(EXPR LAMMPS_VERSION "${_year} * 10000 + ${_month} * 100 + ${_day}")
if(LAMMPS_VERSION LESS 20250204)
  message(FATAL_ERROR "LAMMPS ${_date} in ${LAMMPS_SOURCE_DIR} is too old: 4 Feb 2025 or newer is needed")
endif()

set(LAMMPS_SIZES SMALLBIG)
set(_mpi "unknown MPI")
if(_lmp)
  execute_process(COMMAND "${_lmp}" -h RESULT_VARIABLE _rc OUTPUT_VARIABLE _help ERROR_VARIABLE _err)
  if(NOT _rc EQUAL 0)
    message(FATAL_ERROR "'${_lmp} -h' fails: ${_err}")
  endif()
  if(NOT _help MATCHES "Simulator - ${_date}")
    message(FATAL_ERROR "${_lmp} is not of the version of ${LAMMPS_SOURCE_DIR} (${_date})")
  endif()
  if(NOT _help MATCHES "[ \n]PLUGIN[ \n]")
    message(FATAL_ERROR "${_lmp} was built without LAMMPS's package PLUGIN")
  endif()
  if(_help MATCHES "LAMMPS_(SMALLBIG|BIGBIG|SMALLSMALL)")
    set(LAMMPS_SIZES ${CMAKE_MATCH_1})
  endif()
  if(_help MATCHES "MPI v[0-9.]+: ([^\n,]*)")
    set(_mpi "${CMAKE_MATCH_1}")
  endif()
  if(_mpi MATCHES "STUBS")
    message(FATAL_ERROR "${_lmp} was built without MPI")
  endif()
endif()

# ---- what the plugin compiles with
set(MPI_CXX_SKIP_MPICXX TRUE)
find_package(MPI REQUIRED COMPONENTS CXX)
add_library(lammps_headers INTERFACE)
target_include_directories(lammps_headers SYSTEM INTERFACE "${LAMMPS_SOURCE_DIR}")
target_compile_definitions(lammps_headers INTERFACE LAMMPS_${LAMMPS_SIZES} LMP_VERNUM=${LAMMPS_VERSION})
target_link_libraries(lammps_headers INTERFACE MPI::MPI_CXX)
if(MCAWR_NATIVE)
  target_compile_options(lammps_headers INTERFACE -march=native)
endif()

# ---- build/bin/lmp: that lmp, with the plugin loaded at its start
if(_lmp)
  cmake_path(ABSOLUTE_PATH _lmp NORMALIZE)
  set(LMP_EXECUTABLE "${_lmp}")
  set(_preload "")
  if(SANITIZE)
    # lmp itself is not instrumented, so the sanitizers' libraries have to come first
    foreach(_name libasan.so libubsan.so)
      execute_process(COMMAND ${CMAKE_CXX_COMPILER} -print-file-name=${_name}
                      OUTPUT_VARIABLE _file OUTPUT_STRIP_TRAILING_WHITESPACE)
      string(APPEND _preload "${_file}:")
    endforeach()
  endif()
  configure_file("${PROJECT_SOURCE_DIR}/cmake/lmp.in" "${PROJECT_BINARY_DIR}/bin/lmp" @ONLY
                 FILE_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE
                                  WORLD_READ WORLD_EXECUTE)
endif()
message(STATUS "LAMMPS ${_date} (${LAMMPS_SIZES}, ${_mpi}): ${LAMMPS_SOURCE_DIR}, lmp: ${_lmp}")
