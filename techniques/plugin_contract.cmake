# Numbers the contract that plug-ins are built for, by the content of its files: cmake -DOUTPUT=... -DROOT=... -DFILES=... -P this
# Any change gives another number, also one of a comment: too often told to build anew is better than once too rarely.
list(SORT FILES)
set(all "")
foreach(file IN LISTS FILES)
  file(RELATIVE_PATH name ${ROOT} ${file})
  file(SHA256 ${file} sum)
  string(APPEND all "${name} ${sum}\n")
endforeach()
string(SHA256 sum "${all}")
string(SUBSTRING ${sum} 0 16 digits)
file(WRITE ${OUTPUT}.new "// Generated from the headers of techniques/ and the shaders.\n#pragma once\n#define SHADOWLAB_PLUGIN_CONTRACT \"${digits}\"\n")
file(COPY_FILE ${OUTPUT}.new ${OUTPUT} ONLY_IF_DIFFERENT)
file(REMOVE ${OUTPUT}.new)
