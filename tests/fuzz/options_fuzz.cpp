#include "apps/config_file.h"
#include "apps/option_table.h"
#include "fuzz_input.h"

namespace {

using namespace swathplan;

/// One row of each kind.
struct Values {
  double depth = 1.0;
  std::optional<double> width;
  int count = 1;
  std::uint64_t seed = 1;
  std::string word = "one";
  std::vector<std::string> words;
  std::filesystem::path file;
  bool on = false;

  OptionTable table() {
    return {real("--depth", "", depth, kMetres, above(0.0), "", "depth_m"),
            real("--width", "", width, kMetres, within(0.0, 10.0), "", "width_m"),
            whole("--count", "", count, at_least(1.0), "", "count"),
            whole("--seed", "", seed, "", "seed"),
            choice("--word", "", word, {"one", "two"}, "", "word"),
            texts("--words", "", words, "", "words"),
            path("--file", "", file, "", "file"),
            flag("--on", "", on, "", "on")};
  }
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto file = fuzz::file_of(data, size, ".toml");
  fuzz::expect_sentence([&] {
    Values values;
    const OptionTable table = values.table();
    for (const ConfigEntry& entry : read_config(file)) {
      for (const Option& option : table) {
        if (option.name != entry.name) continue;
        fuzz::expect_sentence([&] {
          set(option, entry.texts);
          check(option);
          static_cast<void>(value_of(option));
        });
      }
    }
  });
  return 0;
}
