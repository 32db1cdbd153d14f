# A room is one folder of src/ (or apps/): one target, the rooms that it may include, and its sources.
#
#   swathplan_room(planners/steering
#     USES mesh/base mesh/plane coverage/route
#     FOREIGN CGAL::CGAL fmt::fmt
#     SOURCES connect.cpp dubins.cpp)
#
# USES are the room's arrows: headers of other rooms may not be included (tests/rooms_test.cpp holds
# every file against them). FOREIGN libraries stay private: their headers appear in .cpp files only.
# UNSANITIZED, behind the name, leaves a room without sanitizers (docs/decisions/0007-sanitizers.md).
define_property(GLOBAL PROPERTY SWATHPLAN_ROOMS
  BRIEF_DOCS "Lines 'room: room room ...' of all arrows that were declared")
define_property(GLOBAL PROPERTY SWATHPLAN_LIBRARIES BRIEF_DOCS "The targets of all rooms of src/")

# swathplan_room_target(OUT ROOM): the CMake target of a room.
function(swathplan_room_target out room)
  string(REPLACE "/" "_" name ${room})
  set(${out} swathplan_${name} PARENT_SCOPE)
endfunction()

# swathplan_arrows(ROOM USED...): declares what ROOM may include.
function(swathplan_arrows room)
  list(JOIN ARGN " " uses)
  set_property(GLOBAL APPEND PROPERTY SWATHPLAN_ROOMS "${room}: ${uses}")
endfunction()

function(swathplan_room room)
  cmake_parse_arguments(ARG "UNSANITIZED" "" "USES;FOREIGN;SOURCES" ${ARGN})
  swathplan_arrows(${room} ${ARG_USES})
  swathplan_room_target(target ${room})
  add_library(${target} STATIC ${ARG_SOURCES})
  target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src>
    $<INSTALL_INTERFACE:include/swathplan>)
  target_compile_features(${target} PUBLIC cxx_std_20)
  foreach(used IN LISTS ARG_USES)
    swathplan_room_target(used_target ${used})
    target_link_libraries(${target} PUBLIC ${used_target})
  endforeach()
  target_link_libraries(${target} PUBLIC Eigen3::Eigen
    PRIVATE $<BUILD_INTERFACE:swathplan_options> fmt::fmt ${ARG_FOREIGN})
  string(REPLACE swathplan_ "" exported ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${exported})
  set_property(GLOBAL APPEND PROPERTY SWATHPLAN_LIBRARIES ${target})
  set_target_properties(${target} PROPERTIES SWATHPLAN_UNSANITIZED ${ARG_UNSANITIZED})
  swathplan_unity(${target})
endfunction()

# Writes the arrows to build/rooms.txt for the test that holds the includes against them.
function(swathplan_write_rooms)
  get_property(rooms GLOBAL PROPERTY SWATHPLAN_ROOMS)
  list(JOIN rooms "\n" text)
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/rooms.txt CONTENT "${text}\n")
endfunction()
