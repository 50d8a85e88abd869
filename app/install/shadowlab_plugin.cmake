# shadowlab_plugin(NAME [FAMILY F] [SOURCES FILE...]): builds NAME.so, a plug-in of shadowlab.
#
# NAME is the namespace in which techniques() is defined, and the folder of shaders/ that its shaders lie in. FAMILY is what
# `shadowlab grade` asks of it: planar, shadow-map, shadow-volume, ray-tracing or radiosity. Without SOURCES: every .cpp file of the folder.
function(shadowlab_plugin name)
  cmake_parse_arguments(PARSE_ARGV 1 plugin "" "FAMILY" "SOURCES")
  if(plugin_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "shadowlab_plugin: '${plugin_UNPARSED_ARGUMENTS}' is not understood; write FAMILY or SOURCES before it")
  endif()
  if(NOT name MATCHES "^[a-z][a-z0-9_]*$")
    message(FATAL_ERROR "shadowlab_plugin: '${name}' is no name of a namespace; use small letters, digits and _")
  endif()
  if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
    set(CMAKE_BUILD_TYPE RelWithDebInfo CACHE STRING "Optimised, and a debugger still knows the lines" FORCE)
  endif()
  if(NOT plugin_SOURCES)
    file(GLOB plugin_SOURCES CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  endif()
  set(shaderFolder ${CMAKE_CURRENT_SOURCE_DIR}/shaders)
  file(GLOB_RECURSE shaders CONFIGURE_DEPENDS ${shaderFolder}/${name}/*.glsl ${shaderFolder}/${name}/*.vert
       ${shaderFolder}/${name}/*.frag ${shaderFolder}/${name}/*.geom)
  file(GLOB headers CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.h)

  set(entry ${CMAKE_CURRENT_BINARY_DIR}/${name}_entry.cpp)
  add_custom_command(
    OUTPUT ${entry}
    COMMAND ${CMAKE_COMMAND} "-DOUTPUT=${entry}" "-DNAME=${name}" "-DFAMILY=${plugin_FAMILY}"
            "-DROOT=${CMAKE_CURRENT_SOURCE_DIR}" "-DSHADERS=${shaders}" "-DSOURCES=${plugin_SOURCES};${headers}" -P
            ${shadowlab_TOOLS}/plugin_entry.cmake
    DEPENDS ${shaders} ${plugin_SOURCES} ${headers} ${shadowlab_TOOLS}/plugin_entry.cmake
    COMMENT "Embedding the shaders of ${name}" VERBATIM)

  add_library(${name} MODULE ${plugin_SOURCES} ${entry})
  target_link_libraries(${name} PRIVATE shadowlab::contract)
  target_compile_options(${name} PRIVATE -Wall -Wextra)
  # What the plug-in defines is its own, whatever has the same name in the program.
  set_target_properties(${name} PROPERTIES PREFIX "" SUFFIX ".so" CXX_EXTENSIONS OFF CXX_VISIBILITY_PRESET hidden
                        VISIBILITY_INLINES_HIDDEN ON)
endfunction()
