# Text of files as C++ string literals, for what the program carries within itself.
include_guard()

# embedded_literal(OUT FILE ROOTS...): sets OUT to `"NAME", R"(the text)"`, NAME being the path below the root that the file lies under.
function(embedded_literal out file)
  set(name ${file})
  foreach(root IN LISTS ARGN)
    string(FIND "${file}" "${root}/" at)
    if(at EQUAL 0)
      file(RELATIVE_PATH name ${root} ${file})
    endif()
  endforeach()
  file(READ ${file} text)
  string(LENGTH "${text}" length)
  if(length GREATER 60000) # compilers need take no more than 65,536
    message(FATAL_ERROR "${file} is too long to embed as one string literal (60000 characters); split it")
  endif()
  set(${out} "\"${name}\", R\"~~~~(${text})~~~~\"" PARENT_SCOPE)
endfunction()
