#pragma once

#include <string>
#include <string_view>

#include "io/grids/surface_data.h"

namespace swathplan {

/// What a reader found, as bytes for another process on the same machine.
[[nodiscard]] std::string to_bytes(const SurfaceData& data);

/// The value that to_bytes() was given, bit for bit.
/// @throws InvalidInput if the bytes end early or are none of to_bytes().
[[nodiscard]] SurfaceData surface_from_bytes(std::string_view bytes);

}  // namespace swathplan
