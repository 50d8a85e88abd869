# The generated sources: the shaders and what is shown of the C++ as strings, and the list of techniques. Functions, because a test builds both
# again with one more technique to show that adding one edits nothing.

# embed_shaders(OUTPUT ROOT...): every shader below the roots, named relative to its root.
function(embed_shaders output)
  set(files "")
  foreach(root IN LISTS ARGN)
    file(GLOB_RECURSE found CONFIGURE_DEPENDS ${root}/*.glsl ${root}/*.vert ${root}/*.frag)
    list(APPEND files ${found})
  endforeach()
  add_custom_command(
    OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} "-DOUTPUT=${output}" "-DROOTS=${ARGN}" "-DFILES=${files}" -P
            ${CMAKE_SOURCE_DIR}/techniques/embed_shaders.cmake
    DEPENDS ${files} ${CMAKE_SOURCE_DIR}/techniques/embed_shaders.cmake
            ${CMAKE_SOURCE_DIR}/techniques/embedded_literal.cmake
    COMMENT "Embedding the shaders" VERBATIM)
endfunction()

# technique_list(OUTPUT SOURCES_VARIABLE PARENT...): every folder directly below the parents that holds a technique.cpp.
# Sets SOURCES_VARIABLE to the sources of all of them.
function(technique_list output sources_variable)
  set(TECHNIQUE_DECLARATIONS "")
  set(TECHNIQUE_ENTRIES "")
  set(all_sources "")
  foreach(parent IN LISTS ARGN)
    file(GLOB mains CONFIGURE_DEPENDS ${parent}/*/technique.cpp)
    foreach(main IN LISTS mains)
      get_filename_component(folder ${main} DIRECTORY)
      get_filename_component(name ${folder} NAME)
      file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${folder}/*.cpp)
      list(APPEND all_sources ${sources})
      string(APPEND TECHNIQUE_DECLARATIONS "namespace ${name} { std::span<const TechniqueInfo> techniques(); }\n")
      string(APPEND TECHNIQUE_ENTRIES "            {\"${name}\", ${name}::techniques()},\n")
    endforeach()
  endforeach()
  configure_file(${CMAKE_SOURCE_DIR}/techniques/technique_list.cpp.in ${output} @ONLY)
  set(${sources_variable} ${all_sources} PARENT_SCOPE)
endfunction()

# embed_sources(OUTPUT ROOT...): of the techniques below the roots every C++ file that has an anchor (techniques/source_text.h), and all
# of techniques/lecture, named relative to its root.
function(embed_sources output)
  set(files "")
  foreach(root IN LISTS ARGN)
    file(GLOB_RECURSE found CONFIGURE_DEPENDS ${root}/techniques/*.h ${root}/techniques/*.cpp)
    list(APPEND files ${found})
  endforeach()
  add_custom_command(
    OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} "-DOUTPUT=${output}" "-DROOTS=${ARGN}" "-DFILES=${files}" -P
            ${CMAKE_SOURCE_DIR}/techniques/embed_sources.cmake
    DEPENDS ${files} ${CMAKE_SOURCE_DIR}/techniques/embed_sources.cmake
            ${CMAKE_SOURCE_DIR}/techniques/embedded_literal.cmake
    COMMENT "Embedding the sources that have anchors" VERBATIM)
endfunction()
