#include <fmt/format.h>

#include "io/files/gdal_at_home.h"
#include "io/files/quiet_gdal.h"
#include "io/grids/grid_import.h"
#include "io/grids/multidim_internal.h"
#include "mesh/base/error.h"

namespace swathplan {

std::unique_ptr<GDALDataset> open_groups(const std::filesystem::path& path) {
  register_gdal();
  const char* const drivers[] = {"HDF5", "BAG", nullptr};
  return std::unique_ptr<GDALDataset>(
      GDALDataset::Open(path.c_str(), GDAL_OF_MULTIDIM_RASTER | GDAL_OF_READONLY, drivers));
}

std::vector<double> values_of(GDALMDArray& array, const std::string& component,
                              const std::filesystem::path& path) {
  constexpr std::size_t kMost = 4 * kMostCells;
  const auto refuse = [&] {
    throw InvalidInput(fmt::format("'{}': the values '{}' of '{}' cannot be read{}", path.string(),
                                   component, array.GetFullName(), QuietGdal::why()));
  };
  std::shared_ptr<GDALMDArray> view;
  if (!component.empty()) {
    view = array.GetView("['" + component + "']");
    if (!view) refuse();
  }
  GDALMDArray& source = view ? *view : array;
  std::vector<std::size_t> count;
  std::size_t size = 1;
  for (const auto& dimension : source.GetDimensions()) {
    count.push_back(static_cast<std::size_t>(dimension->GetSize()));
    if (count.back() > kMost || size * count.back() > kMost) {
      throw InvalidInput(fmt::format("'{}' holds more than {} values in '{}'; crop it first",
                                     path.string(), kMost, array.GetFullName()));
    }
    size *= count.back();
  }
  std::vector<double> values(size);
  const std::vector<GUInt64> start(count.size(), 0);
  if (size > 0 && !source.Read(start.data(), count.data(), nullptr, nullptr,
                               GDALExtendedDataType::Create(GDT_Float64), values.data())) {
    refuse();
  }
  return values;
}

}  // namespace swathplan
