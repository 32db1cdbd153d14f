#include "io/files/quiet_gdal.h"

#include <cpl_error.h>

namespace swathplan {

QuietGdal::QuietGdal() {
  CPLErrorReset();
  CPLPushErrorHandler(CPLQuietErrorHandler);
}

QuietGdal::~QuietGdal() { CPLPopErrorHandler(); }

std::string QuietGdal::why() {
  const std::string text = CPLGetLastErrorMsg();
  return text.empty() ? text : " (" + text + ")";
}

}  // namespace swathplan
