#include <cstring>

#include "fuzz_input.h"
#include "io/seafloor/mesh_import.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace swathplan;
  // Binary ones go to assimp, which is not ours to mend.
  const std::string text = fuzz::text_of(data, size);
  std::uint32_t facets = 0;
  if (size >= 84) std::memcpy(&facets, data + 80, sizeof facets);
  if (!text.starts_with("solid") || size == 84 + std::size_t{50} * facets) return 0;
  const auto path = fuzz::file_of(data, size, ".stl");
  fuzz::expect_sentence([&] { static_cast<void>(read_mesh_unguarded(path)); });
  return 0;
}
