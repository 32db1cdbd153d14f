#pragma once

#include <string>
#include <string_view>

namespace swathplan {

/// Text for an XML element or a quoted attribute. & < > " ' are escaped. Characters that XML 1.0
/// does not allow become '?': control characters and bytes that are not UTF-8.
[[nodiscard]] std::string xml_escaped(std::string_view text);

}  // namespace swathplan
