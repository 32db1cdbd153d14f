#pragma once

#include <string>
#include <string_view>

namespace swathplan::internal {

/// Text for an XML element or a quoted attribute: & < > " ' escaped, characters that XML 1.0 has no
/// place for (controls, bytes that are no UTF-8) turned into '?'.
[[nodiscard]] std::string xml_escaped(std::string_view text);

}  // namespace swathplan::internal
