# SPDX-License-Identifier: GPL-2.0-or-later
# rooms_as_one(TARGET): each folder of the target's sources is compiled as one source, which takes a
# third of the time. Not where a compiler cache does better: there a change of one file compiles that
# file alone.
if(CMAKE_CXX_COMPILER_LAUNCHER)
  set(_default OFF)
else()
  set(_default ON)
endif()
option(ROOMS_AS_ONE "compile the sources of a folder as one" ${_default})

function(rooms_as_one target)
  get_target_property(_sources ${target} SOURCES)
  foreach(_source ${_sources})
    cmake_path(GET _source PARENT_PATH _room)
    string(REPLACE / _ _room "room_${_room}")
    set_source_files_properties(${_source} PROPERTIES UNITY_GROUP ${_room})
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${ROOMS_AS_ONE} UNITY_BUILD_MODE GROUP)
endfunction()
