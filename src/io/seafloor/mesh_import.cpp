#include "io/seafloor/mesh_import.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <fstream>

#include "io/files/child_process.h"
#include "io/files/text.h"
#include "io/seafloor/assimp_internal.h"
#include "io/seafloor/polygon_soup_internal.h"
#include "io/seafloor/surface_bytes.h"
#include "mesh/base/error.h"

namespace swathplan {
namespace {

namespace fs = std::filesystem;

/// Extensions that assimp reads as meshes, but that mean something else to a surveyor.
constexpr std::array kNotMeshes = {".csv", ".xyz", ".txt", ".asc", ".raw", ".xml", ".pts", ".dat"};
constexpr std::size_t kStlHeader = 84;
constexpr std::size_t kStlFacet = 50;

struct StlHead {
  bool says_solid = false;
  std::size_t facets = 0, size = 0;
};

StlHead stl_head(const fs::path& path) {
  StlHead head;
  head.size = fs::file_size(path);
  std::array<char, kStlHeader> bytes{};
  std::ifstream in(path, std::ios::binary);
  in.read(bytes.data(), bytes.size());
  head.says_solid = std::memcmp(bytes.data(), "solid", 5) == 0;
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + 80, sizeof count);
  head.facets = count;
  return head;
}

bool is_ascii_stl(const fs::path& path) {
  // Some binary files begin with 'solid' too, so the size decides.
  const StlHead head = stl_head(path);
  return head.says_solid && head.size != kStlHeader + kStlFacet * head.facets;
}

void check_binary_stl(const fs::path& path) {
  const StlHead head = stl_head(path);
  const std::size_t expected = kStlHeader + kStlFacet * head.facets;
  if (head.size < kStlHeader || head.size < expected) {
    throw InvalidInput(fmt::format(
        "'{}' is {} bytes long, but its {} facets need {}: the file is truncated or no STL; "
        "export it again",
        path.string(), head.size, head.facets, expected));
  }
}

/// The step between neighbouring 32-bit floats at the largest coordinate.
double float_step(const std::vector<Vec3>& vertices) {
  double largest = 0.0;
  for (const Vec3& v : vertices) largest = std::max(largest, v.cwiseAbs().maxCoeff());
  if (!std::isfinite(largest) || largest == 0.0) return 0.0;
  return std::ldexp(1.0, std::ilogb(largest) - 23);
}

/// Corners as they are stored, three a facet; the numbers are little-endian, as this program's are.
SurfaceData read_binary_stl(const fs::path& path) {
  check_binary_stl(path);
  constexpr std::size_t kNormal = 12;
  const std::size_t facets = stl_head(path).facets;
  SurfaceData data;
  data.format = "binary STL";
  std::ifstream in(path, std::ios::binary);
  in.seekg(kStlHeader);
  std::array<char, kStlFacet> bytes{};
  for (std::size_t k = 0; k < facets && in.read(bytes.data(), bytes.size()); ++k) {
    std::array<float, 9> corners{};
    std::memcpy(corners.data(), bytes.data() + kNormal, sizeof corners);
    const auto first = static_cast<std::uint32_t>(data.vertices.size());
    for (std::size_t i = 0; i < corners.size(); i += 3) {
      data.vertices.emplace_back(corners.at(i), corners.at(i + 1), corners.at(i + 2));
    }
    data.faces.push_back({first, first + 1, first + 2});
  }
  data.float_step = float_step(data.vertices);
  return data;
}

SurfaceData read_exactly(const fs::path& path, const std::string& extension) {
  SurfaceData data;
  std::vector<SoupPolygon> polygons;
  if (extension == ".obj") {
    read_obj(path, data.vertices, polygons);
  } else {
    const SoupFormat format = extension == ".ply"   ? SoupFormat::ply
                              : extension == ".off" ? SoupFormat::off
                                                    : SoupFormat::ascii_stl;
    read_soup(path, format, data.vertices, polygons);
  }
  data.format = extension == ".obj"   ? "OBJ"
                : extension == ".ply" ? "PLY"
                : extension == ".off" ? "OFF"
                                      : "ASCII STL";
  data.faces = triangulate(path, data.vertices, polygons);
  return data;
}

}  // namespace

bool is_mesh_extension(const std::string& extension) {
  if (std::find(kNotMeshes.begin(), kNotMeshes.end(), extension) != kNotMeshes.end()) return false;
  return extension == ".off" || (!extension.empty() && assimp_reads(extension));
}

SurfaceData read_mesh_unguarded(const fs::path& path) {
  const std::string extension = lower(path.extension().string());
  const bool is_stl = extension == ".stl";
  const bool exact = extension == ".obj" || extension == ".ply" || extension == ".off" ||
                     (is_stl && is_ascii_stl(path));
  SurfaceData data = exact    ? read_exactly(path, extension)
                     : is_stl ? read_binary_stl(path)
                              : read_with_assimp(path);
  if (!exact && !is_stl) data.float_step = float_step(data.vertices);
  if (data.vertices.empty()) {
    throw InvalidInput(
        fmt::format("'{}' holds neither vertices nor faces; it is no {} file, or it "
                    "is truncated or garbled",
                    path.string(), data.format));
  }
  if (data.faces.empty()) {
    throw InvalidInput(fmt::format(
        "'{}' holds {} vertices but no faces; a seafloor mesh needs faces (for points alone, write "
        "them as XYZ or CSV)",
        path.string(), data.vertices.size()));
  }
  return data;
}

namespace {

/// More for a larger file; what broken counts, cycles and instances ask for is far beyond it.
ChildLimits limits_for(std::uintmax_t bytes) {
  constexpr double kSeconds = 15.0, kSecondsPerMegabyte = 0.5;
  constexpr std::size_t kMemory = std::size_t{1} << 30, kMemoryPerByte = 60;
  return {kSeconds + kSecondsPerMegabyte * static_cast<double>(bytes) / 1e6,
          kMemory + kMemoryPerByte * static_cast<std::size_t>(bytes)};
}

std::string why_not(ChildEnd end, const ChildLimits& limits) {
  switch (end) {
    case ChildEnd::too_long:
      return fmt::format("reading it did not end within {:.0f} s", limits.seconds);
    case ChildEnd::too_large:
      return "it asks for far more memory than a mesh of its size needs";
    default:
      return "its reader breaks down over it";
  }
}

}  // namespace

SurfaceData read_mesh(const fs::path& path) {
  // Foreign readers crash or loop on broken files. In a process of its own the reader can do no
  // harm, and the user gets an error message.
  const ChildLimits limits = limits_for(fs::file_size(path));
  const ChildResult result =
      run_in_child([&] { return to_bytes(read_mesh_unguarded(path)); }, limits);
  if (result.end == ChildEnd::done) return surface_from_bytes(result.text);
  if (result.end == ChildEnd::failed) throw InvalidInput(result.text);
  throw InvalidInput(
      fmt::format("'{}' cannot be read as a mesh: {}. It is damaged or no {} file; export it "
                  "again, for instance as OBJ",
                  path.string(), why_not(result.end, limits),
                  path.extension().empty() ? "mesh" : path.extension().string().substr(1)));
}

}  // namespace swathplan
