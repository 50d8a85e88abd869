# Writes one C++ file that holds, as raw strings, every source file with an anchor, and all of techniques/lecture, which skeletons are
# made from: cmake -DOUTPUT=... -DROOTS=... -DFILES=... -P this
include(${CMAKE_CURRENT_LIST_DIR}/embedded_literal.cmake)
set(body "// Generated from techniques/. Edit those.\n#include \"techniques/source_text.h\"\n\nnamespace shadowlab {\n\nstd::span<const EmbeddedSource> embeddedSources() {\n    static const EmbeddedSource sources[] = {\n")
foreach(file IN LISTS FILES)
  file(STRINGS ${file} anchors REGEX "^ *// \\[anchor: ")
  if(anchors STREQUAL "" AND NOT file MATCHES "/techniques/lecture/")
    continue()
  endif()
  embedded_literal(literal ${file} ${ROOTS})
  string(APPEND body "        {${literal}},\n")
endforeach()
string(APPEND body "    };\n    return sources;\n}\n\n} // namespace shadowlab\n")
# Most edits of a technique change nothing here: then nothing is compiled again.
file(WRITE ${OUTPUT}.new "${body}")
file(COPY_FILE ${OUTPUT}.new ${OUTPUT} ONLY_IF_DIFFERENT)
file(REMOVE ${OUTPUT}.new)
