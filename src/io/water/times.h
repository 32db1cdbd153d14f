#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace swathplan {

/// Seconds since 1970-01-01 00:00 UTC of '2026-05-01T06:30', '2026-05-01 06:30:15Z' or
/// '2026-05-01T08:30+02:00'; without a zone it is UTC. Empty for anything else.
[[nodiscard]] std::optional<double> time_of(std::string_view text);

/// '2026-05-01T06:30:15Z', to the nearest second.
[[nodiscard]] std::string time_text(double time_s);

}  // namespace swathplan
