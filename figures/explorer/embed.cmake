# cmake -DFOLDER=... -DPROGRAM=a.js;b.js -DOUTPUT=... -P embed.cmake: the explorer's sources as C++ string literals.
file(READ ${FOLDER}/explorer.html html)
file(READ ${FOLDER}/explorer.css css)
set(program "")
foreach(name IN LISTS PROGRAM)
  file(READ ${FOLDER}/${name} text)
  string(APPEND program "${text}")
endforeach()
set(delimiter "requad")
foreach(text html css program)
  if("${${text}}" MATCHES "\\)${delimiter}\"")
    message(FATAL_ERROR "the explorer's ${text} holds the end of a raw string literal")
  endif()
endforeach()
file(WRITE ${OUTPUT}
"#include \"figures/explorer/sources.hpp\"\n\n"
"namespace requad::figures::explorer_sources {\n\n"
"const char* const html = R\"${delimiter}(${html})${delimiter}\";\n"
"const char* const css = R\"${delimiter}(${css})${delimiter}\";\n"
"const char* const program = R\"${delimiter}(${program})${delimiter}\";\n\n"
"}  // namespace requad::figures::explorer_sources\n")
