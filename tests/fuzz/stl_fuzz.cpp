#include "fuzz_input.h"
#include "io/seafloor/mesh_import.h"

// ASCII and binary: the file's size tells which.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace swathplan;
  const auto path = fuzz::file_of(data, size, ".stl");
  fuzz::expect_sentence([&] { static_cast<void>(read_mesh_unguarded(path)); });
  return 0;
}
