#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace swathplan {

/// A class of hazards by its name in S-57, and how far off it the boat keeps where its position is
/// known exactly.
struct HazardClass {
  std::string_view layer, what;
  double base_m = 0.0;      ///< room around the object itself, metres
  bool is_danger = false;   ///< lies under water: the quality of the soundings is that of its place
  bool to_be_seen = false;  ///< not sailed over, but its cells count in the coverage
};

/// The classes that are kept off unasked.
inline constexpr std::array kHazardClasses{
    HazardClass{"LNDARE", "land", 10.0},
    HazardClass{"SLCONS", "shoreline constructions", 10.0},
    HazardClass{"PONTON", "pontoons", 10.0},
    HazardClass{"RESARE", "restricted areas", 0.0},
    HazardClass{"WRECKS", "wrecks", 20.0, true, true},
    HazardClass{"OBSTRN", "obstructions", 10.0, true, true},
    HazardClass{"UWTROC", "rocks", 10.0, true, true},
};
/// The row of a layer's name, in small or large letters; nullptr where it has none.
[[nodiscard]] const HazardClass* hazard_class(std::string_view layer);

/// What a chart says about how well the place of an object is known.
struct StatedPosition {
  std::optional<double> posacc_m;  ///< POSACC of its points and edges, the largest
  std::optional<int> quapos;       ///< QUAPOS of its points and edges, the worst
  std::optional<int> catzoc;       ///< CATZOC of the M_QUAL area that it lies in
  int scale = 0;                   ///< the chart's 1:scale; 0: not said
};

/// How far the true place may be from the charted one, and which statement says so.
struct PositionAccuracy {
  double metres = 0.0;
  std::string from;  ///< 'POSACC', 'QUAPOS 4', 'CATZOC B', 'scale 1:80000'
};

/// The accuracy of a charted place. POSACC counts as it stands. Else the larger one of QUAPOS and,
/// for dangers, CATZOC. A chart cannot show more than 0.3 mm at its scale, so no figure but POSACC
/// is less than that.
[[nodiscard]] PositionAccuracy position_accuracy(const StatedPosition& stated, bool is_danger);

/// Metres that QUAPOS stands for; 0 for places that were measured.
[[nodiscard]] double quapos_m(int quapos);
/// Metres that CATZOC stands for; 0 for zones of no known quality.
[[nodiscard]] double catzoc_m(int catzoc);
/// 'A1', 'B', 'U' (not assessed).
[[nodiscard]] std::string catzoc_name(int catzoc);

}  // namespace swathplan
