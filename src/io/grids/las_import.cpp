#include "io/grids/las_import.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <fstream>

#include "io/files/crs.h"
#include "io/grids/shoalest_places.h"
#include "mesh/base/error.h"

namespace swathplan {
namespace {

namespace fs = std::filesystem;

static_assert(std::endian::native == std::endian::little, "LAS is read as it lies in memory");

constexpr const char* kConvert =
    "write it as plain LAS or as x y z rows first (pdal translate in.laz out.las; las2txt)";
constexpr std::size_t kMostPoints = 200'000'000;
constexpr unsigned kLowNoise = 7, kHighNoise = 18, kBathymetric = 40;

/// The bytes of a file, read by place.
class Bytes {
 public:
  explicit Bytes(const fs::path& path) : path_(path) {
    std::ifstream in(path, std::ios::binary);
    bytes_.assign(std::istreambuf_iterator<char>(in), {});
  }
  template <class T>
  [[nodiscard]] T at(std::size_t place) const {
    T value;
    std::memcpy(&value, view(place, sizeof(T)).data(), sizeof(T));
    return value;
  }
  [[nodiscard]] std::string_view view(std::size_t place, std::size_t length) const {
    if (place > bytes_.size() || length > bytes_.size() - place) {
      throw InvalidInput(fmt::format(
          "'{}' is LAS (points of a laser scanner), but is cut off: {} bytes; copy it again, or "
          "write it as x y z rows (las2txt)",
          path_.string(), bytes_.size()));
    }
    return std::string_view(bytes_).substr(place, length);
  }

 private:
  const fs::path& path_;
  std::string bytes_;
};

std::string crs_from(const std::string& text) {
  try {
    return parse_crs(text);
  } catch (const UsageError&) {
    return {};
  }
}

/// EPSG code in the GeoTIFF keys: the projected system, else the geographic one.
std::string crs_of_keys(const Bytes& bytes, std::size_t begin, std::size_t length) {
  std::uint16_t projected = 0;
  std::uint16_t geographic = 0;
  for (std::size_t at = begin + 8; at + 8 <= begin + length; at += 8) {
    const auto key = bytes.at<std::uint16_t>(at);
    const auto value = bytes.at<std::uint16_t>(at + 6);
    if (bytes.at<std::uint16_t>(at + 2) != 0) continue;  // the value stands elsewhere
    if (key == 3072) projected = value;
    if (key == 2048) geographic = value;
  }
  const std::uint16_t code = projected != 0 ? projected : geographic;
  constexpr std::uint16_t kUserDefined = 32767;
  return code == 0 || code == kUserDefined ? "" : crs_from(fmt::format("EPSG:{}", code));
}

std::string crs_of_records(const Bytes& bytes) {
  std::size_t at = bytes.at<std::uint16_t>(94);
  const auto count = bytes.at<std::uint32_t>(100);
  std::string crs;
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto id = bytes.at<std::uint16_t>(at + 18);
    const std::size_t length = bytes.at<std::uint16_t>(at + 20);
    const std::string_view user = bytes.view(at + 2, 15);
    const std::size_t begin = at + 54;
    if (user == "LASF_Projection" && id == 2112) {
      std::string wkt(bytes.view(begin, length));
      wkt.erase(std::find(wkt.begin(), wkt.end(), '\0'), wkt.end());
      return crs_from(wkt);
    }
    if (user == "LASF_Projection" && id == 34735) crs = crs_of_keys(bytes, begin, length);
    at = begin + length;
  }
  return crs;
}

struct LasPoint {
  Vec3 place;
  unsigned type = 0;
  bool withheld = false;
};

std::vector<LasPoint> read_points(const Bytes& bytes, unsigned format, const fs::path& path) {
  const std::size_t first = bytes.at<std::uint32_t>(96);
  const std::size_t size = bytes.at<std::uint16_t>(105);
  const bool is_new = bytes.at<std::uint8_t>(25) >= 4;
  std::size_t count = bytes.at<std::uint32_t>(107);
  if (is_new) count = std::max<std::size_t>(count, bytes.at<std::uint64_t>(247));
  if (count > kMostPoints) {
    throw InvalidInput(fmt::format("'{}' holds {} points; at most {} can be used: thin it",
                                   path.string(), count, kMostPoints));
  }
  if (format > 10 || size < 20) {
    throw InvalidInput(
        fmt::format("'{}' is LAS of a kind that is not known; {}", path.string(), kConvert));
  }
  (void)bytes.view(first, count * size);
  const Vec3 scale(bytes.at<double>(131), bytes.at<double>(139), bytes.at<double>(147));
  const Vec3 offset(bytes.at<double>(155), bytes.at<double>(163), bytes.at<double>(171));
  std::vector<LasPoint> points(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t at = first + i * size;
    const Vec3 raw(bytes.at<std::int32_t>(at), bytes.at<std::int32_t>(at + 4),
                   bytes.at<std::int32_t>(at + 8));
    points[i].place = raw.cwiseProduct(scale) + offset;
    const unsigned flags = bytes.at<std::uint8_t>(at + 15);
    points[i].type = format < 6 ? flags & 31U : bytes.at<std::uint8_t>(at + 16);
    points[i].withheld = (flags & (format < 6 ? 128U : 4U)) != 0;
    if (!points[i].place.allFinite()) {
      throw InvalidInput(
          fmt::format("'{}', point {}: a coordinate is not finite", path.string(), i + 1));
    }
  }
  return points;
}

}  // namespace

bool is_las(const fs::path& path) {
  char head[4] = {};
  std::ifstream(path, std::ios::binary).read(head, 4);
  return std::string_view(head, 4) == "LASF";
}

SurfaceData read_las(const fs::path& path, bool z_positive_down) {
  const Bytes bytes(path);
  const unsigned format = bytes.at<std::uint8_t>(104);
  if (format >= 64) {
    throw InvalidInput(
        fmt::format("'{}' holds compressed points (LAZ); {}", path.string(), kConvert));
  }
  const std::vector<LasPoint> points = read_points(bytes, format, path);
  const bool only_bathymetric = std::any_of(
      points.begin(), points.end(), [](const LasPoint& p) { return p.type == kBathymetric; });
  SurfaceData data;
  data.format = "LAS";
  data.crs_wkt = crs_of_records(bytes);
  for (const LasPoint& p : points) {
    const bool noise = p.type == kLowNoise || p.type == kHighNoise;
    if (p.withheld || noise || (only_bathymetric && p.type != kBathymetric)) continue;
    data.vertices.push_back(p.place);
  }
  if (data.vertices.size() < points.size()) {
    data.notes.push_back(fmt::format("{} of {} points were left out: withheld, noise{}",
                                     points.size() - data.vertices.size(), points.size(),
                                     only_bathymetric ? ", or not of the bathymetric class" : ""));
  }
  keep_shoalest_places(data, z_positive_down);
  if (data.vertices.size() < 3) {
    throw InvalidInput(
        fmt::format("'{}' holds {} points at different places; a surface needs at "
                    "least three",
                    path.string(), data.vertices.size()));
  }
  return data;
}

}  // namespace swathplan
