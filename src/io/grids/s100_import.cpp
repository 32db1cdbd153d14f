#include "io/grids/s100_import.h"

#include <fmt/format.h>
#include <gdal_priv.h>

#include <array>
#include <cmath>
#include <fstream>
#include <initializer_list>

#include "io/files/crs.h"
#include "io/files/layer_choice.h"
#include "io/files/quiet_gdal.h"
#include "io/files/text.h"
#include "io/grids/grid_import.h"
#include "io/grids/multidim_internal.h"
#include "io/grids/raster_internal.h"
#include "mesh/base/error.h"

namespace swathplan {
namespace {

namespace fs = std::filesystem;

constexpr const char* kCoverage = "BathymetryCoverage";
constexpr double kS102Nodata = 1e6;

bool is_hdf5(const fs::path& path) {
  constexpr std::string_view kMagic("\x89HDF\r\n\x1a\n", 8);
  std::array<char, 8> head{};
  std::ifstream(path, std::ios::binary).read(head.data(), head.size());
  return std::string_view(head.data(), head.size()) == kMagic;
}

std::string product_of(const GDALGroup& root) {
  const std::shared_ptr<GDALAttribute> product = root.GetAttribute("productSpecification");
  const char* text = product ? product->ReadAsString() : nullptr;
  return text == nullptr ? "" : text;
}

bool holds_coverage(const GDALGroup& root) {
  const std::vector<std::string> names = root.GetGroupNames();
  return std::find(names.begin(), names.end(), kCoverage) != names.end();
}

/// The first of the names that one of the groups has as a number.
std::optional<double> number(const std::vector<std::shared_ptr<GDALGroup>>& groups,
                             std::initializer_list<const char*> names) {
  for (const auto& group : groups) {
    for (const char* name : names) {
      const auto attribute = group->GetAttribute(name);
      if (attribute && attribute->GetDataType().GetClass() == GEDTC_NUMERIC) {
        return attribute->ReadAsDouble();
      }
    }
  }
  return {};
}

double needed(const std::vector<std::shared_ptr<GDALGroup>>& groups,
              std::initializer_list<const char*> names, const fs::path& path) {
  const std::optional<double> value = number(groups, names);
  if (!value || !std::isfinite(*value)) {
    throw InvalidInput(
        fmt::format("'{}' is S-102, but has no number '{}'", path.string(), *names.begin()));
  }
  return *value;
}

std::shared_ptr<GDALGroup> chosen_instance(const GDALGroup& coverage, const std::string& layer,
                                           const fs::path& path) {
  std::vector<std::string> names;
  for (const std::string& name : coverage.GetGroupNames()) {
    if (name.starts_with(std::string(kCoverage) + ".")) names.push_back(name);
  }
  if (names.empty()) {
    throw InvalidInput(fmt::format("'{}' is S-102, but holds no coverage", path.string()));
  }
  const std::optional<std::size_t> chosen = chosen_layer(layer, names);
  if (!chosen && names.size() > 1) refuse_layers(path, names);
  return coverage.OpenGroup(names[chosen.value_or(0)]);
}

std::string crs_by_code(const std::vector<std::shared_ptr<GDALGroup>>& groups, SurfaceData& data) {
  const std::optional<double> code = number(groups, {"horizontalCRS", "horizontalDatumValue"});
  if (!code || !(*code > 0.0 && *code < 1e6)) return {};
  try {
    return parse_crs(fmt::format("EPSG:{}", std::lround(*code)));
  } catch (const UsageError&) {
    data.warnings.push_back(
        fmt::format("the file names the reference system {}, which is not known", *code));
    return {};
  }
}

}  // namespace

bool is_s100(const fs::path& path) {
  if (!is_hdf5(path)) return false;
  const QuietGdal quiet;
  const std::unique_ptr<GDALDataset> file = open_groups(path);
  const std::shared_ptr<GDALGroup> root = file ? file->GetRootGroup() : nullptr;
  return root && (holds_coverage(*root) || product_of(*root).find("S-1") != std::string::npos);
}

SurfaceData read_s100(const fs::path& path, std::optional<double> nodata,
                      const std::string& layer) {
  const QuietGdal quiet;
  const std::unique_ptr<GDALDataset> file = open_groups(path);
  const std::shared_ptr<GDALGroup> root = file ? file->GetRootGroup() : nullptr;
  if (!root || !holds_coverage(*root)) {
    throw InvalidInput(
        fmt::format("'{}' holds no bathymetric surface (its product is '{}'); give an S-102 file",
                    path.string(), root ? quotable(product_of(*root)) : ""));
  }
  const std::shared_ptr<GDALGroup> coverage = root->OpenGroup(kCoverage);
  const std::shared_ptr<GDALGroup> instance = chosen_instance(*coverage, layer, path);
  const auto group = instance ? instance->OpenGroup("Group_001") : nullptr;
  const auto values = group ? group->OpenMDArray("values") : nullptr;
  if (!values || values->GetDimensionCount() != 2) {
    throw InvalidInput(fmt::format("'{}' is S-102, but its values cannot be found", path.string()));
  }
  const std::vector<std::shared_ptr<GDALGroup>> from{instance};
  const double step_x = needed(from, {"gridSpacingLongitudinal"}, path);
  const double step_y = needed(from, {"gridSpacingLatitudinal"}, path);
  Raster raster;
  raster.rows = static_cast<std::size_t>(values->GetDimensions()[0]->GetSize());
  raster.columns = static_cast<std::size_t>(values->GetDimensions()[1]->GetSize());
  raster.transform = {needed(from, {"gridOriginLongitude"}, path) - 0.5 * step_x, step_x, 0.0,
                      needed(from, {"gridOriginLatitude"}, path) - 0.5 * step_y,  0.0,    step_y};
  raster.nodata = kS102Nodata;
  raster.more_nodata = nodata;
  check_shape(raster, path);
  raster.raw = values_of(*values, "depth", path);
  std::vector<std::string> warnings;
  drop_undeclared_nodata(raster, warnings);
  SurfaceData data = surface_of(raster, path);
  data.warnings = std::move(warnings);
  data.format = "S-102";
  data.z_is_depth = true;
  data.notes.emplace_back("z is positive down, as S-102 has it");
  data.crs_wkt = crs_by_code({root, coverage, instance}, data);
  return data;
}

}  // namespace swathplan
