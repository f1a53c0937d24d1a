# SPDX-License-Identifier: GPL-2.0-or-later
# What `cmake --install build --prefix DIR` leaves; no path in it is absolute, except that of a
# LAMMPS which the project did not build.
#   bin/                                      lmp-mca, wr_fit, wr_creep, mca-campaign, mca-reproduce
#   lib/mca-wheelrail/                        plugin, LAMMPS, its Python module, static libraries
#   lib/libwheelrail_c.so                     the C interface
#   lib/python3/dist-packages/wheelrail/      the Python module; Debian's place below /usr
#   include/wheelrail/, lib/cmake/wheelrail/  for find_package(wheelrail)
#   lib/pkgconfig/wheelrail.pc                the C interface for pkg-config
#   share/mca-wheelrail/                      as the checkout: tools, potentials, examples, pages
include(CMakePackageConfigHelpers)
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY TRUE) # what tests need is not built for it
set(_lib lib/mca-wheelrail)
set(_share share/mca-wheelrail)
set(_written "${PROJECT_BINARY_DIR}/installed") # files made for the installed tree

# Folders that are new are made first, so that every user can read them: CMake would make them by the
# umask of who installs, whatever CMAKE_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS says, and cpack makes
# that of its package so.
set(_folders . bin lib ${_lib} share share/doc share/doc/mca-wheelrail ${_share} ${_share}/tools)
if(BUILD_MCA AND LAMMPS_BUILT_HERE)
  list(APPEND _folders ${_lib}/python ${_lib}/python/lammps)
endif()
if(BUILD_WHEELRAIL)
  list(APPEND _folders include include/wheelrail lib/cmake lib/cmake/wheelrail lib/pkgconfig)
  if(BUILD_PYTHON)
    set(_folder "")
    string(REPLACE "/" ";" _parts "${WHEELRAIL_PYTHON_DIR}/wheelrail")
    foreach(_part ${_parts})
      cmake_path(APPEND _folder ${_part})
      list(APPEND _folders ${_folder})
    endforeach()
  endif()
endif()
set(_permissions OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE
                 WORLD_READ WORLD_EXECUTE)
install(CODE "
  foreach(_folder ${_folders})
    cmake_path(SET _folder NORMALIZE \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/\${_folder}\")
    if(NOT EXISTS \"\${_folder}\" OR \"\${_folder}\" MATCHES \"/_CPack_Packages/\")
      file(MAKE_DIRECTORY \"\${_folder}\")
      file(CHMOD \"\${_folder}\" PERMISSIONS ${_permissions})
    endif()
  endforeach()")

if(BUILD_MCA)
  install(TARGETS mcaplugin LIBRARY DESTINATION ${_lib})
  set(_plugins "$prefix/${_lib}")
  set(_potentials "$prefix/${_share}/potentials")
  set(_program "${LMP_EXECUTABLE}")
  if(LAMMPS_BUILT_HERE) # lmp, its library and its module move together
    set(_program "$prefix/${_lib}/lmp")
    install(PROGRAMS "${LMP_EXECUTABLE}" DESTINATION ${_lib})
    install(FILES "${LAMMPS_LIBRARY}" DESTINATION ${_lib})
    install(DIRECTORY "${LAMMPS_PYTHON}/lammps" DESTINATION ${_lib}/python
            PATTERN __pycache__ EXCLUDE PATTERN liblammps.so EXCLUDE)
    cmake_path(GET LAMMPS_LIBRARY FILENAME _file)
    file(MAKE_DIRECTORY "${_written}")
    file(CREATE_LINK "../../${_file}" "${_written}/liblammps.so" SYMBOLIC)
    install(FILES "${_written}/liblammps.so" DESTINATION ${_lib}/python/lammps)
  endif()
  if(LMP_EXECUTABLE)
    configure_file(cmake/lmp.in "${_written}/lmp-mca" @ONLY)
    install(PROGRAMS "${_written}/lmp-mca" DESTINATION bin)
  endif()
endif()

if(BUILD_WHEELRAIL)
  install(TARGETS wr_fit wr_creep RUNTIME DESTINATION bin)
  install(TARGETS wheelrail mcawr_shared EXPORT wheelrail ARCHIVE DESTINATION ${_lib})
  install(TARGETS wheelrail_c EXPORT wheelrail_c LIBRARY DESTINATION lib)
  install(EXPORT wheelrail_c FILE wheelrail_cTargets.cmake NAMESPACE wheelrail::
          DESTINATION lib/cmake/wheelrail)
  configure_file(cmake/wheelrail.pc.in "${_written}/wheelrail.pc" @ONLY)
  install(FILES "${_written}/wheelrail.pc" DESTINATION lib/pkgconfig)
  install(EXPORT wheelrail FILE wheelrailTargets.cmake NAMESPACE wheelrail::
          DESTINATION lib/cmake/wheelrail)
  install(DIRECTORY src/WHEELRAIL/ src/shared DESTINATION include/wheelrail
          FILES_MATCHING PATTERN "*.h")
  if(BUILD_PYTHON)
    install(TARGETS wheelrail_python LIBRARY DESTINATION ${WHEELRAIL_PYTHON_DIR}/wheelrail)
    install(DIRECTORY src/WHEELRAIL/python/wheelrail/ DESTINATION ${WHEELRAIL_PYTHON_DIR}/wheelrail
            PATTERN __pycache__ EXCLUDE)
  endif()
  configure_package_config_file(cmake/wheelrailConfig.cmake.in "${_written}/wheelrailConfig.cmake"
                                INSTALL_DESTINATION lib/cmake/wheelrail)
  write_basic_package_version_file("${_written}/wheelrailConfigVersion.cmake"
                                   COMPATIBILITY SameMinorVersion)
  install(FILES "${_written}/wheelrailConfig.cmake" "${_written}/wheelrailConfigVersion.cmake"
          DESTINATION lib/cmake/wheelrail)
endif()

set(_up "/../..")
set(_plugins "$_mcawr/${_lib}")
set(_potentials "$_mcawr/${_share}/potentials")
set(_python "$_mcawr/${_lib}/python:$_mcawr/${_share}/tools:$_mcawr/${WHEELRAIL_PYTHON_DIR}")
configure_file(cmake/env.sh.in "${_written}/env.sh" @ONLY)
file(WRITE "${_written}/VERSION" "${MCAWR_VERSION_TEXT}\n")
install(FILES "${_written}/env.sh" "${_written}/VERSION" README.md CONTRIBUTING.md CHANGELOG.md
        CITATION.cff LICENSE DESTINATION ${_share})
install(DIRECTORY doc examples potentials DESTINATION ${_share}
        PATTERN __pycache__ EXCLUDE REGEX "/doc/site$" EXCLUDE)
install(FILES cmake/copyright DESTINATION share/doc/mca-wheelrail)

# scripts of users; those of developers need the checkout
set(_tools tools/campaign tools/reproduce tools/campaign_to_creep.sh tools/contact_inp.py
    tools/dump_to_vtk.py)
foreach(_what creep fit fragment friction layer patch series wheelrail)
  list(APPEND _tools tools/plot_${_what}.py)
endforeach()
install(PROGRAMS ${_tools} DESTINATION ${_share}/tools)
install(FILES tools/common.sh DESTINATION ${_share}/tools)
install(DIRECTORY tools/mcawr tools/campaign_parts tools/contact_parts tools/reproduce_parts
        DESTINATION ${_share}/tools PATTERN __pycache__ EXCLUDE)
file(MAKE_DIRECTORY "${_written}")
foreach(_name campaign reproduce)
  file(CREATE_LINK "../${_share}/tools/${_name}" "${_written}/mca-${_name}" SYMBOLIC)
  install(FILES "${_written}/mca-${_name}" DESTINATION bin)
endforeach()
