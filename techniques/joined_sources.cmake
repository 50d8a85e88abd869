# Compiling is half reading headers: so up to `most` files of one folder are compiled as one (CMake's unity build), which reads the
# headers once for all of them, and those of the libraries are compiled once for a whole target (precompiled headers). Names in
# anonymous namespaces therefore have to differ within a folder. Folders stay apart, so that a new file in one of them changes what
# is compiled for no other.
# SPDX-License-Identifier: MIT
option(SHADOWLAB_JOINED "Compile several files of one folder together, which halves the time of a build from nothing" ON)

# join_sources(TARGET MOST [TOGETHER SOURCE...]): the sources that are named are one group of their own.
function(join_sources target most)
  cmake_parse_arguments(PARSE_ARGV 2 arg "" "" TOGETHER)
  if(NOT SHADOWLAB_JOINED)
    return()
  endif()
  get_target_property(sources ${target} SOURCES)
  foreach(source IN LISTS sources)
    if(NOT source MATCHES "[.]cpp$" OR source MATCHES "^${CMAKE_BINARY_DIR}") # generated files are large as they are
      continue()
    endif()
    if(source IN_LIST arg_TOGETHER)
      set_property(SOURCE ${source} PROPERTY UNITY_GROUP together)
      continue()
    endif()
    get_filename_component(folder ${source} DIRECTORY)
    string(REPLACE "${CMAKE_SOURCE_DIR}" "" folder "${folder}")
    string(MAKE_C_IDENTIFIER "${folder}" folder)
    if(NOT DEFINED count_${folder})
      set(count_${folder} 0)
    endif()
    math(EXPR group "${count_${folder}} / ${most}")
    math(EXPR count_${folder} "${count_${folder}} + 1")
    set_property(SOURCE ${source} PROPERTY UNITY_GROUP ${folder}_${group})
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  target_precompile_headers(${target} PRIVATE <algorithm> <array> <chrono> <cmath> <filesystem> <functional> <map> <memory>
                            <optional> <span> <string> <vector> <glm/glm.hpp>)
endfunction()
