# Writes one C++ file that holds every shader as a raw string: cmake -DOUTPUT=... -DROOTS=... -DFILES=... -P this
include(${CMAKE_CURRENT_LIST_DIR}/embedded_literal.cmake)
set(body "// Generated from shaders/. Edit those.\n#include \"techniques/foundation/gl/shader_source.h\"\n\nnamespace shadowlab::gl {\n\nstd::span<const EmbeddedShader> embeddedShaders() {\n    static const EmbeddedShader shaders[] = {\n")
foreach(file IN LISTS FILES)
  embedded_literal(literal ${file} ${ROOTS})
  string(APPEND body "        {${literal}},\n")
endforeach()
string(APPEND body "    };\n    return shaders;\n}\n\n} // namespace shadowlab::gl\n")
file(WRITE ${OUTPUT} "${body}")
