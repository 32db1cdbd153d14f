# How our own code is compiled; linked privately by every target of the project.
add_library(swathplan_options INTERFACE)
target_compile_options(swathplan_options INTERFACE -Wall -Wextra -Wshadow -Wconversion)
if(PROJECT_IS_TOP_LEVEL)
  target_compile_options(swathplan_options INTERFACE -Werror)
endif()
# The same bytes on every machine: no fused multiply-add where the compiler feels like it.
target_compile_options(swathplan_options INTERFACE -ffp-contract=off)
if(SWATHPLAN_ASSERTS)
  target_compile_options(swathplan_options INTERFACE -UNDEBUG)
endif()
if(SWATHPLAN_SANITIZE)
  target_compile_options(swathplan_options INTERFACE
    -fsanitize=${SWATHPLAN_SANITIZE} -fno-omit-frame-pointer)
  target_link_options(swathplan_options INTERFACE -fsanitize=${SWATHPLAN_SANITIZE})
endif()

# Headers that are large and never change are parsed once for each target. ccache has to be told that it
# may trust them.
option(SWATHPLAN_PRECOMPILE "Precompile large foreign headers" ON)
function(swathplan_precompile target)
  if(NOT SWATHPLAN_PRECOMPILE)
    return()
  endif()
  target_precompile_headers(${target} PRIVATE ${ARGN})
  if(CCACHE_PROGRAM)
    target_compile_options(${target} PRIVATE -fpch-preprocess)
    set_target_properties(${target} PROPERTIES CXX_COMPILER_LAUNCHER
      "${CMAKE_COMMAND};-E;env;CCACHE_SLOPPINESS=pch_defines,time_macros;${CCACHE_PROGRAM}")
  endif()
endfunction()
