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
  # Rooms that are declared UNSANITIZED take most of the compiler's time, and CGAL's own code is most of them.
  target_compile_options(swathplan_options INTERFACE -fno-omit-frame-pointer
    $<$<NOT:$<BOOL:$<TARGET_PROPERTY:SWATHPLAN_UNSANITIZED>>>:-fsanitize=${SWATHPLAN_SANITIZE}>)
  target_link_options(swathplan_options INTERFACE -fsanitize=${SWATHPLAN_SANITIZE})
endif()

# A room is compiled as one unit: its headers, Eigen's and CGAL's among them, are parsed once. Off for
# work on single files and for tools that read one file at a time.
option(SWATHPLAN_UNITY "Compile the files of a room together" ON)
function(swathplan_unity target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${SWATHPLAN_UNITY} UNITY_BUILD_BATCH_SIZE 0)
endfunction()
