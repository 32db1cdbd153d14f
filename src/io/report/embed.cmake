# cmake -DOUTPUT=file.cpp -DFOLDER=dir -P embed.cmake: writes the report's page, style and scripts
# into a C++ file, so that the program needs no file beside it.
set(text "// Written by embed.cmake.\n#include \"io/report/assets_internal.h\"\n\n")
string(APPEND text "namespace swathplan::internal {\n")
foreach(asset "kReportPage report.html" "kReportStyle report.css"
    "kReportScript view.js maps.js page.js limits.js chart.js criteria.js start.js")
  separate_arguments(parts UNIX_COMMAND "${asset}")
  list(POP_FRONT parts name)
  string(APPEND text "const std::string_view ${name} = R\"~asset(")
  foreach(part IN LISTS parts)
    file(READ "${FOLDER}/${part}" content)
    string(APPEND text "${content}")
  endforeach()
  string(APPEND text ")~asset\";\n")
endforeach()
string(APPEND text "}  // namespace swathplan::internal\n")
file(WRITE "${OUTPUT}" "${text}")
