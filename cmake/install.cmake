# What is installed for programs that are built on the libraries: headers, static libraries and the
# CMake package. The program itself is installed in apps/CMakeLists.txt.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

get_property(rooms GLOBAL PROPERTY SWATHPLAN_LIBRARIES)
add_library(swathplan_libraries INTERFACE)
target_link_libraries(swathplan_libraries INTERFACE ${rooms})
set_target_properties(swathplan_libraries PROPERTIES EXPORT_NAME swathplan)

add_custom_target(libraries DEPENDS ${rooms})

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/swathplan)
install(TARGETS swathplan_libraries ${rooms} EXPORT swathplan
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
install(EXPORT swathplan FILE swathplanTargets.cmake NAMESPACE swathplan::
  DESTINATION ${package_folder} COMPONENT development)
install(DIRECTORY src/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/swathplan COMPONENT development
  FILES_MATCHING PATTERN "*.h" PATTERN "*_internal.h" EXCLUDE)

configure_package_config_file(cmake/swathplanConfig.cmake.in
  ${PROJECT_BINARY_DIR}/swathplanConfig.cmake INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/swathplanConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES cmake/dependencies.cmake ${PROJECT_BINARY_DIR}/swathplanConfig.cmake
  ${PROJECT_BINARY_DIR}/swathplanConfigVersion.cmake
  DESTINATION ${package_folder} COMPONENT development)
