// Names of files and of what is in them must never run as script in the report.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/chromium.h"

namespace swathplan {
namespace {

using test::dataset;
using test::Folder;
using testing::HasSubstr;
using testing::Not;

const std::string kRun = R"(document.title='run')";

/// Texts that would run where a page takes them as they are: as an element, out of an attribute,
/// out of a script, as a picture that fails.
const std::vector<std::string> kHostile{"\"><script>" + kRun + "</script>",
                                        "'-" + kRun + "-'",
                                        "</script><script>" + kRun + "</script>",
                                        "<img src=x onerror=" + kRun + ">",
                                        "\\u003cscript\\u003e" + kRun + "\\u003c" + "script\\u003e",
                                        "<!--<script>" + kRun};

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos;
       at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
  return text;
}

/// Within single quotes of the shell.
std::string quoted(const std::string& text) { return "'" + replaced(text, "'", "'\\''") + "'"; }

/// File names hold no slash.
std::string file_name(const std::string& hostile) { return replaced(hostile, "/", "\xE2\x88\x95"); }

/// Plans with hostile names: of the seafloor's file, of an area and its properties, of a route.
std::filesystem::path hostile_report(const Folder& folder, const std::string& hostile) {
  const std::string seafloor = file_name(hostile) + ".obj";
  std::filesystem::copy_file(dataset("shaft.obj"), folder / seafloor);
  const std::string inner = replaced(replaced(hostile, "\\", "\\\\"), "\"", "\\\"");
  const std::string area = file_name(hostile) + ".geojson";
  folder.write(area, R"({"type":"FeatureCollection","name":")" + inner +
                         R"(","features":[{"type":"Feature","properties":{"name":")" + inner +
                         R"("},"geometry":{"type":"Polygon","coordinates":)"
                         R"([[[-40,-40],[40,-40],[40,40],[-40,40],[-40,-40]]]}}]})");
  auto run = folder.run("plan " + quoted("./" + seafloor) + " --area " + quoted("./" + area) +
                        " --planner back-and-forth --hit-only --resolution 1 -o out");
  EXPECT_EQ(run.code, 0) << run.err;
  const std::string route = file_name(hostile) + ".csv";
  std::filesystem::copy_file(folder / "out" / "route.csv", folder / route);
  run = folder.run("score " + quoted("./" + seafloor) + " " + quoted("./" + route) + " --area " +
                   quoted("./" + area) + " --infill --hit-only --resolution 1 -o scored");
  EXPECT_EQ(run.code, 0) << run.err;
  return folder / "scored" / "report.html";
}

TEST(ReportScript, NamesStandInThePageAsDataOnlyAndABrowserRunsNone) {
  const bool browser = test::has_chromium();
  for (const std::string& hostile : kHostile) {
    const Folder folder;
    const std::string page = test::text_of(hostile_report(folder, hostile));
    EXPECT_THAT(page, HasSubstr("run")) << "the name is shown";
    if (hostile.find('<') != std::string::npos) {
      EXPECT_THAT(page, Not(HasSubstr(file_name(hostile)))) << hostile;
      EXPECT_THAT(page, Not(HasSubstr(hostile)));
    }
    if (!browser) continue;
    const test::Chromium chromium(folder);
    for (const std::string name : {"out", "scored"}) {
      const std::string rendered = chromium.dom(folder / name / "report.html");
      EXPECT_THAT(rendered, HasSubstr("data-ready=")) << "the page's own script has run";
      EXPECT_THAT(rendered, HasSubstr("<title>"));
      EXPECT_THAT(rendered, Not(HasSubstr("<title>run</title>"))) << hostile;
      EXPECT_EQ(chromium.console(), "") << hostile;
    }
  }
  if (!browser) GTEST_SKIP() << "the browser's part was skipped: chromium is not installed";
}

}  // namespace
}  // namespace swathplan
