# Debian packages by CPack: swathplan (the program, its manual, sample seafloors) and swathplan-dev
# (headers and libraries). './dev package' makes them.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME swathplan)
set(CPACK_PACKAGE_VENDOR "swathplan contributors")
set(CPACK_PACKAGE_CONTACT "swathplan contributors")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_OUTPUT_FILE_PREFIX ${PROJECT_BINARY_DIR}/packages)

set(CPACK_COMPONENTS_ALL program development)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION
  "Plans routes for multibeam surveys over a seafloor that is roughly known, and predicts the coverage by tracing every beam.")
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "Headers, static libraries and the CMake package of swathplan.")

set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME swathplan)
set(CPACK_DEBIAN_PROGRAM_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME swathplan-dev)
set(CPACK_DEBIAN_DEVELOPMENT_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
# What dependencies.cmake looks for.
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "g++, cmake, pkg-config, libcgal-dev, libassimp-dev, libembree-dev, libeigen3-dev, coinor-libipopt-dev, libopencv-core-dev, libopencv-imgproc-dev, libopencv-imgcodecs-dev, libopencv-ml-dev, libgdal-dev, libpolyclipping-dev, libcli11-dev, nlohmann-json3-dev, libfmt-dev, libtbb-dev")

include(CPack)
