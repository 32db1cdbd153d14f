#pragma once

#include <optional>
#include <string_view>

namespace swathplan {

/// Metres in one unit of length as files name it ('m', 'US survey foot', 'fathoms', 'cm', ...);
/// empty if the name is not known.
[[nodiscard]] std::optional<double> metres_in(std::string_view unit);

}  // namespace swathplan
