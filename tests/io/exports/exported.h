#pragma once

#include <ogrsf_frmts.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "io/exports/route_export.h"
#include "io/sample_plan.h"
#include "io/sample_route.h"
#include "temporary_folder.h"

namespace swathplan::test {

/// The bytes of a file.
inline std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// Exports a route as one format under the name 'north & south'.
struct Exported {
  explicit Exported(ExportFormat format, const Route& planned = lawnmower(3)) : route(planned) {
    const PlacedRoute placed{route, frame, nullptr};
    done = export_route(folder.path(), "north & south", placed, placed, {{format}, 0.1, 0}).at(0);
  }
  [[nodiscard]] const std::filesystem::path& file() const { return done.files.at(0); }
  [[nodiscard]] GDALDatasetUniquePtr open() const {
    GDALAllRegister();
    return GDALDatasetUniquePtr(GDALDataset::Open(file().c_str(), GDAL_OF_VECTOR));
  }
  TemporaryFolder folder;
  Route route;
  Frame frame = utm_frame();
  ExportedRoute done{};
};

}  // namespace swathplan::test
