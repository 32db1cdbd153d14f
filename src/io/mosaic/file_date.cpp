#include "io/mosaic/file_date.h"

#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <regex>

#include "io/charts/chart_import.h"
#include "io/files/gdal_at_home.h"
#include "io/files/quiet_gdal.h"

namespace swathplan {
namespace {

namespace fs = std::filesystem;

std::string issue_of_cell(const fs::path& path) {
  const char* const options[] = {"UPDATES=APPLY", nullptr};
  const GDALDatasetUniquePtr cell(GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY,
                                                    nullptr, options, nullptr));
  OGRLayer* layer = cell ? cell->GetLayerByName("DSID") : nullptr;
  const OGRFeatureUniquePtr header(layer == nullptr ? nullptr : layer->GetNextFeature());
  const int at = header ? header->GetFieldIndex("DSID_ISDT") : -1;
  return at < 0 ? "" : header->GetFieldAsString(at);
}

/// '2025:09:23 10:00:00'.
std::string date_of_tiff(const fs::path& path) {
  const GDALDatasetUniquePtr file(
      GDALDataset::Open(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY));
  const char* text = file ? file->GetMetadataItem("TIFFTAG_DATETIME") : nullptr;
  return text == nullptr ? "" : text;
}

}  // namespace

std::optional<std::string> last_date_in(const std::string& text) {
  static const std::regex kDate(
      R"((^|[^0-9])((?:19|20)[0-9]{2})[-_:]?(0[1-9]|1[0-2])[-_:]?(0[1-9]|[12][0-9]|3[01])(?![0-9]))");
  std::optional<std::string> found;
  for (std::sregex_iterator at(text.begin(), text.end(), kDate), end; at != end; ++at) {
    found = (*at)[2].str() + (*at)[3].str() + (*at)[4].str();
  }
  return found;
}

std::optional<std::string> file_date(const fs::path& path) {
  const QuietGdal quiet;
  register_gdal();
  const std::string own = is_chart(path) ? issue_of_cell(path) : date_of_tiff(path);
  if (auto stated = last_date_in(own)) return stated;
  return last_date_in(path.filename().string());
}

}  // namespace swathplan
