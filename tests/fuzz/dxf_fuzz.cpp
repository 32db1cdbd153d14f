#include "fuzz_input.h"
#include "io/files/crs.h"
#include "io/seafloor/area_import.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace swathplan;
  static const Frame frame{.origin = Vec2(500000.0, 6651000.0),
                           .metres_per_unit = 1.0,
                           .crs_wkt = parse_crs("EPSG:32633")};
  const auto path = fuzz::file_of(data, size, ".dxf");
  for (const double buffer : {0.0, 5.0}) {
    fuzz::expect_sentence([&] {
      static_cast<void>(import_area(path, frame, {.buffer_m = buffer, .tolerance_m = 0.1}));
    });
  }
  return 0;
}
