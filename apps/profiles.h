#pragma once

#include <array>
#include <span>
#include <string_view>

// Profiles: what practice or the papers ask of a plan, as rows of data. A row is an option by its
// name in outputs, and its value as it would be typed; it holds where neither the command line nor
// a configuration file says otherwise. A user's own profile is a configuration file of such rows.
namespace swathplan {

struct ProfileRow {
  std::string_view name, value;
};

struct Profile {
  std::string_view name, what;
  std::span<const ProfileRow> rows;
};

/// What surveyors do: pings by the clock, coverage of logged lines, one pair of angles a line, room
/// for the hull. Options that no row names follow from vehicle and sonar.
inline constexpr std::array kSurveyRows{
    ProfileRow{"counted", "logged"},
    ProfileRow{"angles", "line"},
    ProfileRow{"max_opening_deg", "130"},
};

/// What the papers' simulations do.
inline constexpr std::array kPaperRows{
    ProfileRow{"counted", "all"},        ProfileRow{"angles", "ping"},
    ProfileRow{"ping_spacing_m", "0.1"}, ProfileRow{"clearance_m", "0.05"},
    ProfileRow{"least_line_m", "0"},     ProfileRow{"swath_by", "footprint"},
};

/// Under any profile, where the seafloor is an S-57 chart: its soundings lie hundreds of metres
/// apart, so cells of decimetres would only take time.
inline constexpr std::array kChartRows{
    ProfileRow{"resolution_m", "1"},
};
inline constexpr std::string_view kChartExtension = ".000";

inline constexpr std::array kProfiles{
    Profile{"survey", "what surveyors do", kSurveyRows},
    Profile{"paper", "what the papers' simulations do", kPaperRows},
};

}  // namespace swathplan
