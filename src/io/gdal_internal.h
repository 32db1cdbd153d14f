#pragma once

#include <cpl_error.h>

#include <string>

namespace swathplan {

/// Keeps GDAL, OGR and PROJ from writing to stderr in this scope and remembers their last error.
class QuietGdal {
 public:
  QuietGdal() {
    CPLErrorReset();
    CPLPushErrorHandler(CPLQuietErrorHandler);
  }
  ~QuietGdal() { CPLPopErrorHandler(); }
  QuietGdal(const QuietGdal&) = delete;
  QuietGdal& operator=(const QuietGdal&) = delete;
  QuietGdal(QuietGdal&&) = delete;
  QuietGdal& operator=(QuietGdal&&) = delete;

  /// ' (what GDAL says)', or nothing.
  [[nodiscard]] static std::string why() {
    const std::string text = CPLGetLastErrorMsg();
    return text.empty() ? text : " (" + text + ")";
  }
};

}  // namespace swathplan
