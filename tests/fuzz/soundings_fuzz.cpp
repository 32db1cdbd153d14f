#include "fuzz_input.h"
#include "io/soundings/soundings_import.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace swathplan;
  const auto path = fuzz::file_of(data, size, ".xyz");
  fuzz::expect_sentence([&] {
    SurfaceData soundings = read_soundings(path);
    if (soundings.faces.empty()) join_soundings(soundings, std::nullopt);
  });
  return 0;
}
