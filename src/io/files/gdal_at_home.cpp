#include "io/files/gdal_at_home.h"

#include <cpl_conv.h>
#include <cpl_error.h>
#include <cpl_http.h>
#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogr_srs_api.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/base/error.h"

namespace swathplan {
namespace {

namespace fs = std::filesystem;

/// Drivers whose data lie on other machines or in databases.
constexpr std::array kElsewhere = {
    "WCS",    "WMS",           "WMTS",       "WFS",        "OAPIF",         "OGCAPI",
    "HTTP",   "PLMOSAIC",      "PLSCENES",   "EEDA",       "EEDAI",         "DAAS",
    "NGW",    "CSW",           "Carto",      "AmigoCloud", "Elasticsearch", "STACTA",
    "STACIT", "PostGISRaster", "PostgreSQL", "MySQL",      "MSSQLSpatial",  "ODBC",
    "PGeo",   "GMLAS",         "OGR_OGDI",   "GPSBabel",   "Rasterlite"};

CPLHTTPResult* no_answer(const char* url, CSLConstList, GDALProgressFunc, void*,
                         CPLHTTPFetchWriteFunc, void*, void*) {
  auto* result = static_cast<CPLHTTPResult*>(CPLCalloc(1, sizeof(CPLHTTPResult)));
  result->nStatus = 1;
  result->pszErrBuf = CPLStrdup("this program does not use the network");
  CPLError(CE_Failure, CPLE_AppDefined,
           "'%s' is not fetched: this program does not use the network", url);
  return result;
}

std::string start_of(const fs::path& file, std::size_t most) {
  std::ifstream in(file, std::ios::binary);
  std::string text(most, '\0');
  in.read(text.data(), static_cast<std::streamsize>(most));
  text.resize(static_cast<std::size_t>(in.gcount()));
  return text;
}

bool is_virtual(const std::string& text) {
  return text.find("<VRTDataset") != std::string::npos ||
         text.find("<OGRVRTDataSource") != std::string::npos;
}

/// Beside the file or below it, and a plain file: no way up, no other root, no virtual file system,
/// no driver's prefix.
bool stays_beside(const std::string& source) {
  if (source.empty()) return true;
  const fs::path path(source);
  return path.is_relative() && source.find(':') == std::string::npos &&
         source.find("/vsi") == std::string::npos && source.find('<') == std::string::npos &&
         std::none_of(path.begin(), path.end(), [](const fs::path& part) { return part == ".."; });
}

/// What the elements that name sources hold.
std::vector<std::string> sources_of(std::string_view text) {
  std::vector<std::string> sources;
  for (const std::string_view element : {"<SourceFilename", "<SourceDataset", "<SrcDataSource",
                                         "<SrcDataset", "<SrcDSN", "<Dataset"}) {
    for (std::size_t at = text.find(element); at != std::string_view::npos;
         at = text.find(element, at + 1)) {
      const std::size_t begin = text.find('>', at);
      if (begin == std::string_view::npos) break;
      sources.emplace_back(text.substr(begin + 1, text.find('<', begin) - begin - 1));
    }
  }
  return sources;
}

[[noreturn]] void refuse(const fs::path& file, const std::string& source) {
  throw InvalidInput(
      fmt::format("'{}' draws on '{}'; a virtual file may only draw on files beside it: copy that "
                  "file there, or write the data into one file (gdal_translate)",
                  file.string(), source));
}

void check_virtual(const fs::path& file, int depth) {
  constexpr std::size_t kMostText = 64 << 20;
  constexpr int kMostDepth = 8;
  if (!is_virtual(start_of(file, 4096))) return;
  if (depth > kMostDepth) refuse(file, "itself, through others");
  const std::string text = start_of(file, kMostText);
  if (text.find("VRTRawRasterBand") != std::string::npos) refuse(file, "raw bytes of another file");
  if (text.find("&#") != std::string::npos) refuse(file, "a source that is written in codes");
  for (const std::string& name : sources_of(text)) {
    if (!stays_beside(name)) refuse(file, name);
    const fs::path target = file.parent_path() / name;
    std::error_code ignored;
    if (fs::is_regular_file(target, ignored)) check_virtual(target, depth + 1);
  }
}

}  // namespace

void register_gdal() {
  static std::once_flag once;
  std::call_once(once, [] {
    // Nothing over http is a file with this extension.
    CPLSetConfigOption("CPL_VSIL_CURL_ALLOWED_EXTENSIONS", "{not-allowed}");
    CPLSetConfigOption("GDAL_VRT_ENABLE_PYTHON", "NO");
    CPLSetConfigOption("GDAL_VRT_ENABLE_RAWRASTERBAND", "NO");
    CPLHTTPSetFetchCallback(&no_answer, nullptr);
    OSRSetPROJEnableNetwork(0);
    GDALAllRegister();
    GDALDriverManager& drivers = *GetGDALDriverManager();
    for (const char* name : kElsewhere) {
      if (GDALDriver* driver = drivers.GetDriverByName(name)) drivers.DeregisterDriver(driver);
    }
  });
}

void check_sources_stay_beside(const fs::path& file) { check_virtual(file, 0); }

}  // namespace swathplan
