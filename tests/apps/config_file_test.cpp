#include "apps/config_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "mesh/base/error.h"
#include "temporary_folder.h"

namespace swathplan {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

class ConfigFile : public testing::Test {
 protected:
  [[nodiscard]] std::filesystem::path write(const std::string& name,
                                            const std::string& text) const {
    std::ofstream(folder_.path() / name, std::ios::binary) << text;
    return folder_.path() / name;
  }
  /// "name=text|text" of each entry.
  [[nodiscard]] std::vector<std::string> read(const std::string& name,
                                              const std::string& text) const {
    std::vector<std::string> entries;
    for (const ConfigEntry& e : read_config(write(name, text))) {
      std::string joined = e.name + "=";
      for (const std::string& t : e.texts) joined += (&t == &e.texts.front() ? "" : "|") + t;
      entries.push_back(joined);
    }
    return entries;
  }
  [[nodiscard]] std::string refusal(const std::string& name, const std::string& text) const {
    try {
      static_cast<void>(read(name, text));
    } catch (const UsageError& error) {
      return error.what();
    }
    return "accepted";
  }

 private:
  test::TemporaryFolder folder_;
};

TEST_F(ConfigFile, ReadsTheTomlThatOptionsNeed) {
  EXPECT_THAT(
      read("a.toml",
           "# a comment\r\n"
           "resolution_m = 0.25  # cells\n"
           "\n"
           "hit-only = true\n"
           "crs = \"a # in \\\"quotes\\\"\"\n"
           "area = 'C:\\x.shp'\n"
           "export = [\"gpx\", \"kml\"]\n"
           "depth_bands = [10.5, 20]\n"
           "seed = 18446744073709551615\n"),
      ElementsAre("resolution_m=0.25", "hit-only=true", "crs=a # in \"quotes\"", "area=C:\\x.shp",
                  "export=gpx|kml", "depth_bands=10.5|20", "seed=18446744073709551615"));
  EXPECT_THAT(read("empty.toml", ""), ElementsAre());
}

TEST_F(ConfigFile, ReadsTheOptionsOfOutputsButNotWhatWasDerived) {
  EXPECT_THAT(read("plan.json",
                   R"({"command": "plan", "seed": 7, "options": {"draft_m": 0.3, "crs": "",
                       "margin": 0.1, "heading": null, "derived": ["draft_m"]}, "regions": []})"),
              ElementsAre("crs=", "margin=0.1", "seed=7"));
}

TEST_F(ConfigFile, NamesFileLineAndFault) {
  EXPECT_THAT(refusal("a.toml", "x = 1\nresolution 2\n"),
              AllOf(HasSubstr("a.toml"), HasSubstr("line 2"), HasSubstr("resolution 2")));
  EXPECT_THAT(refusal("a.toml", "vehicle = launch\n"),
              AllOf(HasSubstr("line 1"), HasSubstr("quotes")));
  EXPECT_THAT(refusal("a.toml", "x = 1\nx = 2\n"), HasSubstr("twice"));
  EXPECT_THAT(refusal("a.toml", "[plan]\nx = 1\n"), HasSubstr("[plan]"));
  EXPECT_THAT(refusal("a.json", "{\"options\": "), HasSubstr("a.json"));
  EXPECT_THROW(static_cast<void>(read_config("no-such.toml")), UsageError);
}

}  // namespace
}  // namespace swathplan
