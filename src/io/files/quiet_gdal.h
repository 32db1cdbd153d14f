#pragma once

#include <string>

namespace swathplan {

/// Keeps GDAL, OGR and PROJ from writing to stderr in this scope and remembers their last error.
class QuietGdal {
 public:
  QuietGdal();
  ~QuietGdal();
  QuietGdal(const QuietGdal&) = delete;
  QuietGdal& operator=(const QuietGdal&) = delete;
  QuietGdal(QuietGdal&&) = delete;
  QuietGdal& operator=(QuietGdal&&) = delete;

  /// ' (what GDAL says)', or nothing.
  [[nodiscard]] static std::string why();
};

}  // namespace swathplan
