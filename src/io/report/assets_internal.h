#pragma once

#include <string_view>

namespace swathplan::internal {

// The files of this folder, embedded by embed.cmake.
extern const std::string_view kReportPage;  ///< with {{title}}, {{style}}, {{data}} and so on
extern const std::string_view kReportStyle;
extern const std::string_view kReportLibraries;  ///< Leaflet and uPlot with their licences
extern const std::string_view kReportScript;

}  // namespace swathplan::internal
