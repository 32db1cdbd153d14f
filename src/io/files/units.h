#pragma once

#include <optional>
#include <string_view>

namespace swathplan {

/// Metres in one unit of length as files name it ('m', 'US survey foot', 'fathoms', 'cm', ...);
/// empty if the name is not known.
[[nodiscard]] std::optional<double> metres_in(std::string_view unit);

/// What names of columns and properties end in for coordinates of so many metres a unit: 'm', 'ft',
/// 'us_ft', or 'crs' for other units of a coordinate reference system.
[[nodiscard]] std::string_view unit_mark(double metres_per_unit);
/// The metres in a unit that has such a mark; empty for 'crs' and for what is no mark.
[[nodiscard]] std::optional<double> metres_of_mark(std::string_view mark);

}  // namespace swathplan
