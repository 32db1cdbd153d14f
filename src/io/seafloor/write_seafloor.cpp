#include "io/seafloor/write_seafloor.h"

#include <fmt/format.h>
#include <gdal_priv.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "io/files/atomic_file.h"
#include "io/files/gdal_at_home.h"
#include "mesh/base/error.h"

namespace swathplan {
namespace {

constexpr double kNodata = -9999.0;
/// Node spacings of a lattice may differ by this share, because decimal coordinates are rounded.
constexpr double kEven = 1e-6;

std::string obj_text(const Seafloor& seafloor) {
  std::string text = "# seafloor: x east, y north, z up, metres\n";
  for (const Vec3& v : seafloor.vertices) {
    const Vec2 p = seafloor.frame.to_file(v.head<2>());
    fmt::format_to(std::back_inserter(text), "v {} {} {}\n", p.x(), p.y(), v.z());
  }
  for (const Seafloor::Face& f : seafloor.faces) {
    fmt::format_to(std::back_inserter(text), "f {} {} {}\n", f[0] + 1, f[1] + 1, f[2] + 1);
  }
  return text;
}

struct LatticeAxis {
  double first = 0.0, step = 0.0;
  int count = 0;
  [[nodiscard]] int index(double v) const {
    return static_cast<int>(std::lround((v - first) / step));
  }
};

LatticeAxis axis(std::vector<double> values, const std::string& file) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  LatticeAxis result{values.front(), 0.0, static_cast<int>(values.size())};
  if (values.size() > 1)
    result.step = (values.back() - values.front()) / static_cast<double>(values.size() - 1);
  for (std::size_t i = 0; i + 1 < values.size(); ++i) {
    if (std::abs(values[i + 1] - values[i] - result.step) > kEven * result.step) {
      throw UsageError(fmt::format(
          "'{}': this seafloor does not stand on an even lattice; write it as .obj", file));
    }
  }
  return result;
}

void write_grid(const std::filesystem::path& path, const std::string& name,
                const Seafloor& seafloor) {
  std::vector<double> xs;
  std::vector<double> ys;
  for (const Vec3& v : seafloor.vertices) {
    const Vec2 p = seafloor.frame.to_file(v.head<2>());
    xs.push_back(p.x());
    ys.push_back(p.y());
  }
  const LatticeAxis x = axis(xs, name);
  const LatticeAxis y = axis(ys, name);
  if (x.count < 2 || y.count < 2 || std::abs(x.step - y.step) > kEven * x.step) {
    throw UsageError(fmt::format(
        "'{}': this seafloor does not stand on a square lattice; write it as .obj", name));
  }
  std::vector<double> z(static_cast<std::size_t>(x.count) * static_cast<std::size_t>(y.count),
                        kNodata);
  for (std::size_t i = 0; i < seafloor.vertices.size(); ++i) {
    const int row = y.count - 1 - y.index(ys[i]);
    z[static_cast<std::size_t>(row) * static_cast<std::size_t>(x.count) +
      static_cast<std::size_t>(x.index(xs[i]))] = seafloor.vertices[i].z();
  }
  register_gdal();
  GDALDriver* memory = GetGDALDriverManager()->GetDriverByName("MEM");
  const bool ascii = path.extension() == ".asc";
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName(ascii ? "AAIGrid" : "GTiff");
  const GDALDatasetUniquePtr grid(memory->Create("", x.count, y.count, 1, GDT_Float64, nullptr));
  double transform[6] = {
      x.first - 0.5 * x.step, x.step, 0.0, y.first + (y.count - 0.5) * y.step, 0.0, -y.step};
  grid->SetGeoTransform(transform);
  if (!seafloor.frame.crs_wkt.empty()) grid->SetProjection(seafloor.frame.crs_wkt.c_str());
  GDALRasterBand* band = grid->GetRasterBand(1);
  band->SetNoDataValue(kNodata);
  bool good = band->RasterIO(GF_Write, 0, 0, x.count, y.count, z.data(), x.count, y.count,
                             GDT_Float64, 0, 0) == CE_None;
  char** options = ascii ? CSLSetNameValue(nullptr, "DECIMAL_PRECISION", "3")
                         : CSLSetNameValue(nullptr, "COMPRESS", "DEFLATE");
  if (good) {
    const GDALDatasetUniquePtr written(
        driver->CreateCopy(path.c_str(), grid.get(), FALSE, options, nullptr, nullptr));
    good = written != nullptr;
  }
  CSLDestroy(options);
  if (!good) throw InvalidInput(fmt::format("cannot write '{}'", name));
}

}  // namespace

void write_seafloor(const std::filesystem::path& path, const Seafloor& seafloor) {
  const std::string extension = path.extension().string();
  if (extension == ".obj") {
    write_text_atomically(path, obj_text(seafloor));
  } else if (extension == ".asc" || extension == ".tif") {
    write_through_memory(
        path, [&](const std::string& part) { write_grid(part, path.string(), seafloor); });
  } else {
    throw UsageError(fmt::format("'{}': write a seafloor as .obj, .asc or .tif", path.string()));
  }
}

}  // namespace swathplan
