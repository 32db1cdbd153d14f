#pragma once

#include <gdal_priv.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace swathplan {

/// An open raster and the band of it that holds the seafloor.
struct GridSource {
  /// Of text that begins with a byte-order mark: the folder of its copy in GDAL's memory.
  std::shared_ptr<const std::string> copy;
  GDALDatasetUniquePtr data;
  int band = 1;
  std::vector<std::string> notes, warnings;
};

/// Opens a raster. Where it holds several variables, subdatasets or bands, `layer` chooses; without
/// it a band comes first, and a variable that is alone or alone named as a height or depth.
/// @throws InvalidInput if it cannot be opened, is a picture, or none of several layers is chosen.
[[nodiscard]] GridSource open_grid(const std::filesystem::path& path, const std::string& layer);

}  // namespace swathplan
