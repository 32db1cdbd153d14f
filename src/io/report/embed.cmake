# cmake -DOUTPUT=file.cpp -DFOLDER=dir -DSTYLES=... -DLIBRARIES=... -DSCRIPTS=... -P embed.cmake:
# writes the report's page, styles and scripts into a C++ file, so that the program needs no file
# beside it.
set(text "// Written by embed.cmake.\n#include \"io/report/assets_internal.h\"\n\n")
string(APPEND text "namespace swathplan::internal {\n")

# Each file is one literal; neighbouring literals are joined.
function(embed name)
  set(body "const std::string_view ${name} =")
  foreach(part IN LISTS ARGN)
    file(READ "${FOLDER}/${part}" content)
    if(part MATCHES "^vendor/.*css$")
      # Pictures of controls that the page does not use: a page of one file can fetch none.
      string(REGEX REPLACE "url\\([^)]*\\)" "none" content "${content}")
    endif()
    if(part MATCHES "^vendor/.*js$")
      # Browsers would look for a map that is not there.
      string(REGEX REPLACE "\n//# sourceMappingURL=[^\n]*" "" content "${content}")
    endif()
    if(part MATCHES "LICENSE$")
      set(content "/*\n${content}*/")
    endif()
    string(APPEND body "\n  R\"~asset(${content}\n)~asset\"")
  endforeach()
  set(text "${text}${body};\n" PARENT_SCOPE)
endfunction()

embed(kReportPage report.html)
embed(kReportStyle ${STYLES})
embed(kReportLibraries ${LIBRARIES})
embed(kReportScript ${SCRIPTS})
string(APPEND text "}  // namespace swathplan::internal\n")
file(WRITE "${OUTPUT}" "${text}")
