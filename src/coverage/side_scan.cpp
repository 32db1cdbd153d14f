#include "coverage/side_scan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "mesh/base/parallel.h"
#include "mesh/base/random.h"
#include "mesh/base/require.h"

namespace swathplan {
namespace {

constexpr double kLeastWater = 0.5;  // the vehicle stays so far below the surface
constexpr double kLeastAltitude = 0.5;

// Speckle of a pixel: a gamma variate of mean 1 with shape `looks`. It depends on the pixel's place
// alone, so the order of work does not change it. The cube of a normal (Wilson and Hilferty) is
// within a per cent for looks >= 1.
double speckle(std::uint64_t seed, std::uint64_t place, double looks) {
  const std::uint64_t a = scrambled(seed + kSplitmixStep * (2 * place + 1));
  const std::uint64_t b = scrambled(a + kSplitmixStep);
  const double k = 1.0 / (9.0 * looks);
  const double root =
      std::max(0.0, 1.0 - k + normal(uniform_above_0(a), uniform(b)) * std::sqrt(k));
  return root * root * root;
}

// Angles from the vertical at which rays meet a flat bottom rays_per_pixel times a pixel.
std::vector<double> fan_angles(const SideScanSonar& sonar, double altitude) {
  const int count =
      static_cast<int>(std::ceil(sonar.range_m / sonar.pixel_m)) * sonar.rays_per_pixel;
  std::vector<double> angles;
  for (int i = 0; i < count; ++i) {
    const double y = (i + 0.5) * sonar.pixel_m / sonar.rays_per_pixel;
    angles.push_back(std::atan2(y, altitude));
  }
  // Rays above the far edge of a flat bottom: what stands up there is within slant range too.
  const double last = angles.back();
  for (int i = 1; i <= count / 8; ++i) {
    angles.push_back(last + (std::numbers::pi / 2.0 + 0.05 - last) * i / (count / 8.0));
  }
  return angles;
}

void add_side(const RayScene& scene, const Vec3& sonar_at, const Vec2& outward, double altitude,
              const SideScanSonar& sonar, const std::vector<double>& angles, float* row,
              int columns) {
  std::vector<Eigen::Vector3f> directions;
  directions.reserve(angles.size());
  for (const double a : angles) {
    const Vec2 side = std::sin(a) * outward;
    directions.emplace_back(Vec3(side.x(), side.y(), -std::cos(a)).cast<float>());
  }
  std::vector<RayHit> hits(directions.size());
  scene.trace(sonar_at, directions, hits);
  for (std::size_t i = 0; i < hits.size(); ++i) {
    const double slant = hits[i].range_m;
    if (!(slant > 0.0)) continue;
    const double y = std::sqrt(std::max(0.0, slant * slant - altitude * altitude));
    if (y < sonar.nadir_gap_m) continue;
    const auto column = static_cast<std::size_t>(y / sonar.pixel_m);
    if (column >= static_cast<std::size_t>(columns)) continue;
    const Eigen::Vector3f normal(hits[i].nx, hits[i].ny, hits[i].nz);
    const double lambert = std::abs(directions[i].dot(normal));
    const double loss = std::pow(10.0, -0.1 * sonar.attenuation_db_per_m * slant);
    row[column] += static_cast<float>(lambert * lambert * loss);
  }
  // A flat bottom gives rays_per_pixel rays a pixel. A steep face gives more, and their energy adds
  // up to its bright return.
  for (int c = 0; c < columns; ++c) {
    row[c] /= static_cast<float>(sonar.rays_per_pixel);
  }
}

}  // namespace

void check(const SideScanSonar& s) {
  require(s.range_m > 0.0 && s.range_m <= 1000.0, "sonar range", s.range_m, "in (0, 1000] m");
  require(s.pixel_m > 0.0 && s.pixel_m <= s.range_m, "image pixel", s.pixel_m, "in (0, range] m");
  require(s.ping_spacing_m > 0.0, "ping spacing", s.ping_spacing_m, "above 0 m");
  require(s.altitude_m >= kLeastAltitude, "altitude", s.altitude_m, "at least 0.5 m");
  require(s.nadir_gap_m >= 0.0 && s.nadir_gap_m < s.range_m, "nadir gap", s.nadir_gap_m,
          "in [0, range) m");
  require(s.rays_per_pixel >= 1 && s.rays_per_pixel <= 16, "rays per pixel", s.rays_per_pixel,
          "in [1, 16]");
  require(s.attenuation_db_per_m >= 0.0, "attenuation", s.attenuation_db_per_m,
          "at least 0 dB per metre");
  require(s.looks == 0.0 || s.looks >= 1.0, "speckle looks", s.looks, "0 or at least 1");
}

double sonar_height_m(double depth_below_m, const SideScanSonar& sonar) {
  const double wanted = -depth_below_m + sonar.altitude_m;
  return std::max(std::min(wanted, -kLeastWater), -depth_below_m + kLeastAltitude);
}

SideScanImage side_scan_image(const RayScene& scene, const Vec2& from, const Vec2& to,
                              const std::function<double(const Vec2&)>& depth_below,
                              const SideScanSonar& sonar) {
  check(sonar);
  const double length = (to - from).norm();
  const Vec2 course = length > 0.0 ? Vec2((to - from) / length) : Vec2(0.0, 1.0);
  const Vec2 starboard(course.y(), -course.x());
  SideScanImage image;
  image.rows = std::max(1, static_cast<int>(std::floor(length / sonar.ping_spacing_m)));
  image.columns = static_cast<int>(std::ceil(sonar.range_m / sonar.pixel_m));
  image.pixel_m = sonar.pixel_m;
  image.row_m = sonar.ping_spacing_m;
  image.nadir_gap_m = sonar.nadir_gap_m;
  const auto size = static_cast<std::size_t>(image.rows) * static_cast<std::size_t>(image.columns);
  image.port.assign(size, 0.0F);
  image.starboard.assign(size, 0.0F);
  for_each_index(0, image.rows, [&](int row) {
    const Vec2 at = from + (row + 0.5) * sonar.ping_spacing_m * course;
    const double depth = depth_below(at);
    const double z = sonar_height_m(depth, sonar);
    const double altitude = z + depth;
    const auto angles = fan_angles(sonar, altitude);
    const auto first = static_cast<std::size_t>(row) * static_cast<std::size_t>(image.columns);
    for (const bool port : {true, false}) {
      float* pixels = (port ? image.port : image.starboard).data() + first;
      const Vec2 outward = port ? Vec2(-starboard) : starboard;
      add_side(scene, {at.x(), at.y(), z}, outward, altitude, sonar, angles, pixels, image.columns);
      if (sonar.looks == 0.0) continue;
      for (std::size_t c = 0; c < static_cast<std::size_t>(image.columns); ++c) {
        pixels[c] *= static_cast<float>(
            speckle(sonar.seed, 2 * (first + c) + (port ? 1U : 0U), sonar.looks));
      }
    }
  });
  return image;
}

NadirHeights nadir_heights(const RayScene& scene, const Vec2& from, const Vec2& to,
                           const std::function<double(const Vec2&)>& depth_below,
                           double half_width_m, const SideScanSonar& sonar) {
  check(sonar);
  const double length = (to - from).norm();
  const Vec2 course = length > 0.0 ? Vec2((to - from) / length) : Vec2(0.0, 1.0);
  const Vec2 starboard(course.y(), -course.x());
  NadirHeights result;
  result.rows = std::max(1, static_cast<int>(std::floor(length / sonar.ping_spacing_m)));
  result.columns = 2 * static_cast<int>(std::ceil(half_width_m / sonar.pixel_m));
  result.pixel_m = sonar.pixel_m;
  result.row_m = sonar.ping_spacing_m;
  const auto columns = static_cast<std::size_t>(result.columns);
  result.z.assign(static_cast<std::size_t>(result.rows) * columns,
                  std::numeric_limits<float>::quiet_NaN());
  for_each_index(0, result.rows, [&](int row) {
    const Vec2 at = from + (row + 0.5) * sonar.ping_spacing_m * course;
    const double depth = depth_below(at);
    const double z = sonar_height_m(depth, sonar);
    std::vector<Eigen::Vector3f> directions;
    for (int c = 0; c < result.columns; ++c) {
      const Vec2 side = (c + 0.5 - 0.5 * result.columns) * sonar.pixel_m * starboard;
      directions.push_back(Vec3(side.x(), side.y(), -(z + depth)).normalized().cast<float>());
    }
    std::vector<RayHit> hits(directions.size());
    scene.trace({at.x(), at.y(), z}, directions, hits);
    for (std::size_t c = 0; c < columns; ++c) {
      if (!(hits[c].range_m > 0.0F)) continue;
      result.z[static_cast<std::size_t>(row) * columns + c] =
          static_cast<float>(z) + hits[c].range_m * directions[c].z();
    }
  });
  return result;
}

}  // namespace swathplan
