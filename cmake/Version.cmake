# SPDX-License-Identifier: GPL-2.0-or-later
# MCAWR_VERSION_TEXT = version and commit as every program prints them: "1.2.3 (v1.2.3-4-gabcdef0)".
# The commit is that of the last configuration; in a source archive (cmake/Package.cmake) it stands
# in the file COMMIT; else it is "unknown".
set(_commit "")
find_package(Git QUIET)
if(GIT_FOUND AND EXISTS "${PROJECT_SOURCE_DIR}/.git")
  execute_process(COMMAND "${GIT_EXECUTABLE}" -C "${PROJECT_SOURCE_DIR}" describe --always --dirty
                          --match "v[0-9]*"
                  OUTPUT_VARIABLE _commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
endif()
if(NOT _commit AND EXISTS "${PROJECT_SOURCE_DIR}/COMMIT")
  file(STRINGS "${PROJECT_SOURCE_DIR}/COMMIT" _commit LIMIT_COUNT 1)
endif()
if(NOT _commit)
  set(_commit unknown)
endif()
set(MCAWR_COMMIT "${_commit}")
set(MCAWR_VERSION_TEXT "${PROJECT_VERSION} (${_commit})")
