#include "io/files/crs.h"

#include <fmt/format.h>
#include <gdal_version.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "io/files/quiet_gdal.h"
#include "mesh/base/angle.h"
#include "mesh/base/error.h"

namespace swathplan {
namespace {

OGRSpatialReference reference(const std::string& wkt) {
  OGRSpatialReference crs;
  crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  if (crs.importFromWkt(wkt.c_str()) != OGRERR_NONE) {
    throw InvalidInput("cannot read the coordinate reference system of the data" +
                       QuietGdal::why() + "; give it with <CRS> EPSG:n");
  }
  return crs;
}

std::string to_wkt(const OGRSpatialReference& crs) {
  const char* const options[] = {"FORMAT=WKT2_2019", "MULTILINE=NO", nullptr};
  char* text = nullptr;
  const OGRErr error = crs.exportToWkt(&text, options);
  std::string wkt = error == OGRERR_NONE && text != nullptr ? text : "";
  CPLFree(text);
  return wkt;
}

std::string horizontal_wkt(OGRSpatialReference& crs) {
  crs.StripVertical();
  return to_wkt(crs);
}

}  // namespace

std::string parse_crs(const std::string& text) {
  static constexpr std::array<const char*, 3> kLimits{"ALLOW_NETWORK_ACCESS=NO",
                                                      "ALLOW_FILE_ACCESS=NO", nullptr};
  const QuietGdal quiet;
  OGRSpatialReference crs;
  if (text.empty() || crs.SetFromUserInput(text.c_str(), kLimits.data()) != OGRERR_NONE) {
    throw UsageError(
        fmt::format("'{}' is no coordinate reference system that can be read{}; "
                    "write <CRS> EPSG:n, for instance <CRS> EPSG:32633",
                    text, QuietGdal::why()));
  }
  std::string wkt = horizontal_wkt(crs);
  if (wkt.empty() || (!is_geographic(wkt) && !is_projected(wkt) && crs.IsLocal() == 0)) {
    throw UsageError(fmt::format(
        "'{}' is no horizontal coordinate reference system; write <CRS> EPSG:n of a projected "
        "or geographic one",
        text));
  }
  return wkt;
}

bool is_geographic(const std::string& wkt) {
  const QuietGdal quiet;
  return !wkt.empty() && reference(wkt).IsGeographic() != 0;
}

bool is_projected(const std::string& wkt) {
  const QuietGdal quiet;
  return !wkt.empty() && reference(wkt).IsProjected() != 0;
}

double metres_per_unit(const std::string& wkt) {
  const QuietGdal quiet;
  if (wkt.empty()) return 1.0;
  const OGRSpatialReference crs = reference(wkt);
  return crs.IsGeographic() != 0 ? 1.0 : crs.GetLinearUnits();
}

std::string crs_name(const std::string& wkt) {
  const QuietGdal quiet;
  if (wkt.empty()) return "none";
  OGRSpatialReference crs = reference(wkt);
  const char* name = crs.GetName();
  std::string label = name != nullptr ? name : "unnamed";
  if (crs.GetAuthorityCode(nullptr) == nullptr) crs.AutoIdentifyEPSG();
  const char* code = crs.GetAuthorityCode(nullptr);
  const char* authority = crs.GetAuthorityName(nullptr);
  if (code == nullptr || authority == nullptr) return label;
  return fmt::format("{}:{} ({})", authority, code, label);
}

std::string utm_crs(double lon_deg, double lat_deg) {
  const double wrapped = std::remainder(lon_deg, 360.0);
  const int zone = std::clamp(static_cast<int>(std::floor((wrapped + 180.0) / 6.0)) + 1, 1, 60);
  return parse_crs(fmt::format("EPSG:{}", (lat_deg >= 0.0 ? 32600 : 32700) + zone));
}

std::string wgs84_crs() { return parse_crs("EPSG:4326"); }

struct CrsTransform::Impl {
  std::unique_ptr<OGRCoordinateTransformation> transformation;
};

CrsTransform::CrsTransform(const std::string& from_wkt, const std::string& to_wkt_text)
    : impl_(std::make_unique<Impl>()) {
  const QuietGdal quiet;
  const OGRSpatialReference from = reference(from_wkt);
  const OGRSpatialReference to = reference(to_wkt_text);
  impl_->transformation.reset(OGRCreateCoordinateTransformation(&from, &to));
  if (!impl_->transformation) {
    throw InvalidInput(fmt::format("cannot turn coordinates of {} into {}{}", crs_name(from_wkt),
                                   crs_name(to_wkt_text), QuietGdal::why()));
  }
}

CrsTransform::~CrsTransform() = default;
CrsTransform::CrsTransform(CrsTransform&&) noexcept = default;
CrsTransform& CrsTransform::operator=(CrsTransform&&) noexcept = default;

Vec2 CrsTransform::operator()(const Vec2& p) const { return (*this)(std::vector<Vec2>{p}).front(); }

std::vector<Vec2> CrsTransform::operator()(const std::vector<Vec2>& points) const {
  const QuietGdal quiet;
  std::vector<double> x(points.size());
  std::vector<double> y(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    x[i] = points[i].x();
    y[i] = points[i].y();
  }
  std::vector<int> ok(points.size(), 0);
  impl_->transformation->Transform(static_cast<int>(points.size()), x.data(), y.data(), nullptr,
                                   ok.data());
  std::vector<Vec2> result(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (ok[i] == 0 || !std::isfinite(x[i]) || !std::isfinite(y[i])) {
      throw InvalidInput(fmt::format(
          "the point ({}, {}) has no place in the other coordinate reference system{}; check <CRS>",
          points[i].x(), points[i].y(), QuietGdal::why()));
    }
    result[i] = Vec2(x[i], y[i]);
  }
  return result;
}

namespace {

/// Half of a step on the grid, units: far above rounding, far below the curvature of the grid.
constexpr double kStep = 10.0;

/// The way from `at - step` to `at + step` on the ground, metres to true east and north.
Vec2 true_way(const CrsTransform& to_degrees, const Vec2& at, const Vec2& step) {
  constexpr double kSemiMajor = 6378137.0, kEccentricity2 = 6.69437999014e-3;
  const Vec2 from = to_degrees(at - step);
  const Vec2 to = to_degrees(at + step);
  const double phi = Angle::degrees(0.5 * (from.y() + to.y())).rad();
  const double w2 = 1.0 - kEccentricity2 * std::sin(phi) * std::sin(phi);
  const double meridian = kSemiMajor * (1.0 - kEccentricity2) / (w2 * std::sqrt(w2));
  const double parallel = kSemiMajor / std::sqrt(w2) * std::cos(phi);
  const double east = std::remainder(to.x() - from.x(), 360.0);
  return {parallel * Angle::degrees(east).rad(),
          meridian * Angle::degrees(to.y() - from.y()).rad()};
}

}  // namespace

GroundScale ground_scale(const std::string& wkt, const Vec2& at) {
  const CrsTransform to_degrees(wkt, wgs84_crs());
  return {true_way(to_degrees, at, Vec2(kStep, 0.0)).norm() / (2.0 * kStep),
          true_way(to_degrees, at, Vec2(0.0, kStep)).norm() / (2.0 * kStep)};
}

double meridian_convergence_deg(const std::string& wkt, const Vec2& at) {
  const Vec2 north = true_way(CrsTransform(wkt, wgs84_crs()), at, Vec2(0.0, kStep));
  return Angle::radians(std::atan2(north.x(), north.y())).deg();
}

}  // namespace swathplan
