// The one file of the program that asks all libraries for their versions.
#include <CGAL/version.h>
#include <IpoptConfig.h>
#include <assimp/version.h>
#include <embree3/rtcore.h>
#include <fmt/format.h>
#include <gdal.h>
#include <ogr_srs_api.h>
#include <oneapi/tbb/version.h>

#include <CLI/Version.hpp>
#include <Eigen/Core>
#include <array>
#include <boost/version.hpp>
#include <nlohmann/json.hpp>
#include <opencv2/core/utility.hpp>
#include <polyclipping/clipper.hpp>

#include "apps/commands.h"

namespace swathplan {
namespace {

std::string dotted(int major, int minor, int patch) {
  return fmt::format("{}.{}.{}", major, minor, patch);
}

std::string assimp_version() {
  return dotted(static_cast<int>(aiGetVersionMajor()), static_cast<int>(aiGetVersionMinor()),
                static_cast<int>(aiGetVersionPatch()));
}

std::string embree_version() {
  const RTCDevice device = rtcNewDevice(nullptr);
  if (device == nullptr) return "does not start on this machine";
  const auto part = [&](RTCDeviceProperty property) {
    return static_cast<int>(rtcGetDeviceProperty(device, property));
  };
  std::string version =
      dotted(part(RTC_DEVICE_PROPERTY_VERSION_MAJOR), part(RTC_DEVICE_PROPERTY_VERSION_MINOR),
             part(RTC_DEVICE_PROPERTY_VERSION_PATCH));
  rtcReleaseDevice(device);
  return version;
}

std::string proj_version() {
  std::array<int, 3> v{};
  OSRGetPROJVersion(&v[0], &v[1], &v[2]);
  return dotted(v[0], v[1], v[2]);
}

}  // namespace

std::string version_text() {
  std::string text = fmt::format("swathplan {}\n", SWATHPLAN_VERSION);
  const auto add = [&text](const char* kind, const char* name, const std::string& version) {
    text += fmt::format("  {:<11} {:<8} {}\n", kind, name, version);
  };
  // A loaded library tells its own version. The others tell the version of their headers.
  constexpr const char* kLoaded = "loaded";
  constexpr const char* kBuilt = "built with";
  add(kLoaded, "assimp", assimp_version());
  add(kLoaded, "Embree", embree_version());
  add(kLoaded, "GDAL", GDALVersionInfo("RELEASE_NAME"));
  add(kLoaded, "oneTBB", TBB_runtime_version());
  add(kLoaded, "OpenCV", cv::getVersionString());
  add(kLoaded, "PROJ", proj_version());
  add(kBuilt, "Boost",
      dotted(BOOST_VERSION / 100000, BOOST_VERSION / 100 % 1000, BOOST_VERSION % 100));
  add(kBuilt, "CGAL", CGAL_VERSION_STR);
  add(kBuilt, "CLI11", CLI11_VERSION);
  add(kBuilt, "Clipper", CLIPPER_VERSION);
  add(kBuilt, "Eigen", dotted(EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION));
  add(kBuilt, "fmt", dotted(FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100));
  add(kBuilt, "Ipopt", IPOPT_VERSION);
  add(kBuilt, "JSON",
      dotted(NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR,
             NLOHMANN_JSON_VERSION_PATCH));
  text += fmt::format("  {:<11} {:<8} {}", "compiled by", "GCC", __VERSION__);
  return text;
}

}  // namespace swathplan
