#include "fuzz_input.h"
#include "io/files/crs.h"
#include "io/route/read_route.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace swathplan;
  static const Frame frame{.origin = Vec2(500000.0, 6651000.0),
                           .metres_per_unit = 1.0,
                           .crs_wkt = parse_crs("EPSG:32633")};
  static const RouteDefaults defaults{.fan = FanAngles{Angle::degrees(60.0), Angle::degrees(60.0)},
                                      .speed_mps = 2.0};
  const std::string text = fuzz::text_of(data, size);
  // Drawings are read in a process of their own.
  if (route_format(text) == RouteFormat::dxf) return 0;
  fuzz::expect_sentence([&] { static_cast<void>(parse_route(text, "route", frame, defaults)); });
  return 0;
}
