# Everything comes from Debian 12; nothing is fetched at configure time. The installed CMake package
# reads this file too.
set(CGAL_DO_NOT_WARN_ABOUT_CMAKE_BUILD_TYPE TRUE)
find_package(CGAL 5.5 REQUIRED)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(assimp 5.2 REQUIRED)
find_package(embree 3.13 REQUIRED)
find_package(TBB REQUIRED)
find_package(GDAL CONFIG REQUIRED)
find_package(CLI11 REQUIRED)
find_package(nlohmann_json 3.11 REQUIRED)
find_package(fmt REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(IPOPT REQUIRED IMPORTED_TARGET ipopt)
pkg_check_modules(CLIPPER REQUIRED IMPORTED_TARGET polyclipping)

# OpenCV's own config file ships only in Debian's full package, so the modules are found by hand.
find_path(OPENCV_INCLUDE_DIR opencv2/core.hpp PATH_SUFFIXES opencv4 REQUIRED)
find_library(OPENCV_CORE_LIBRARY opencv_core REQUIRED)
find_library(OPENCV_IMGPROC_LIBRARY opencv_imgproc REQUIRED)
find_library(OPENCV_IMGCODECS_LIBRARY opencv_imgcodecs REQUIRED)
find_library(OPENCV_ML_LIBRARY opencv_ml REQUIRED)
add_library(swathplan_opencv INTERFACE IMPORTED)
target_include_directories(swathplan_opencv SYSTEM INTERFACE ${OPENCV_INCLUDE_DIR})
target_link_libraries(swathplan_opencv INTERFACE
  ${OPENCV_IMGCODECS_LIBRARY} ${OPENCV_ML_LIBRARY} ${OPENCV_IMGPROC_LIBRARY} ${OPENCV_CORE_LIBRARY})
