# SPDX-License-Identifier: GPL-2.0-or-later
# `cpack -G DEB --config build/CPackConfig.cmake`: a Debian package of the installed tree, below /usr.
# `cpack --config build/CPackSourceConfig.cmake`: the sources.
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_PACKAGE_NAME mca-wheelrail)
set(CPACK_PACKAGE_VENDOR "The MCA-WHEELRAIL developers")
set(CPACK_PACKAGE_CONTACT "The MCA-WHEELRAIL developers")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_RESOURCE_FILE_LICENSE "${PROJECT_SOURCE_DIR}/LICENSE")
set(CPACK_STRIP_FILES ON)
set(CPACK_SOURCE_GENERATOR TGZ)
set(CPACK_SOURCE_PACKAGE_FILE_NAME ${PROJECT_NAME}-${PROJECT_VERSION})
set(CPACK_SOURCE_IGNORE_FILES "^${PROJECT_SOURCE_DIR}/(build|results|\\.git)" "/__pycache__/"
    "/\\.pytest_cache/")

# the archive holds no git, so its commit goes into a file
file(WRITE "${PROJECT_BINARY_DIR}/archive_commit.cmake"
     "if(NOT CPACK_INSTALL_CMAKE_PROJECTS)\n  file(WRITE \"\${CMAKE_INSTALL_PREFIX}/COMMIT\" \"${MCAWR_COMMIT}\\n\")\nendif()\n")
set(CPACK_INSTALL_SCRIPTS "${PROJECT_BINARY_DIR}/archive_commit.cmake")

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
# libraries: as dpkg-shlibdeps finds them, liblammps is in the package
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
if(LAMMPS_BUILT_HERE)
  cmake_path(GET LAMMPS_LIBRARY PARENT_PATH CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS)
endif()
set(CPACK_DEBIAN_PACKAGE_DEPENDS "openmpi-bin, python3, python3-matplotlib, python3-numpy, python3-yaml")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "python3-meshio")
string(JOIN ", " CPACK_DEBIAN_PACKAGE_SUGGESTS cmake g++ libarchive-dev libboost-dev libceres-dev
       libcli11-dev libeigen3-dev libfftw3-dev libfmt-dev libudunits2-dev libyaml-cpp-dev
       nlohmann-json3-dev pkg-config)
include(CPack)
