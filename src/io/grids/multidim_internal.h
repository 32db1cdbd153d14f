#pragma once

#include <gdal_priv.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace swathplan {

/// Opens an HDF5 file (BAG and S-100 are such) with its groups and arrays; empty if it is none.
[[nodiscard]] std::unique_ptr<GDALDataset> open_groups(const std::filesystem::path& path);

/// One component of an array of records, or the array itself where `component` is empty.
/// @throws InvalidInput if the component does not exist or cannot be read.
[[nodiscard]] std::vector<double> values_of(GDALMDArray& array, const std::string& component,
                                            const std::filesystem::path& path);

}  // namespace swathplan
