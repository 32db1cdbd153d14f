#include "io/seafloor/mesh_import.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <fstream>

#include "io/files/text_fields.h"
#include "io/seafloor/assimp_internal.h"
#include "io/seafloor/polygon_soup_internal.h"
#include "mesh/base/error.h"

namespace swathplan {
namespace {

namespace fs = std::filesystem;

/// Extensions that assimp claims but that mean something else to a surveyor.
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

/// Steps between neighbouring 32-bit floats at the largest coordinate.
double float_step(const std::vector<Vec3>& vertices) {
  double largest = 0.0;
  for (const Vec3& v : vertices) largest = std::max(largest, v.cwiseAbs().maxCoeff());
  if (!std::isfinite(largest) || largest == 0.0) return 0.0;
  return std::ldexp(1.0, std::ilogb(largest) - 23);
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

SurfaceData read_mesh(const fs::path& path) {
  const std::string extension = lower(path.extension().string());
  const bool is_stl = extension == ".stl";
  const bool exact = extension == ".obj" || extension == ".ply" || extension == ".off" ||
                     (is_stl && is_ascii_stl(path));
  if (is_stl && !exact) check_binary_stl(path);
  SurfaceData data = exact ? read_exactly(path, extension) : read_with_assimp(path);
  if (is_stl && !exact) data.format = "binary STL";
  if (!exact) data.float_step = float_step(data.vertices);
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

}  // namespace swathplan
