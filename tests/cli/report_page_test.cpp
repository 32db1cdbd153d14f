// The report in a browser: on a screen, on a phone and on paper.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <regex>

#include "cli/chromium.h"

namespace swathplan {
namespace {

using test::Chromium;
using test::dataset;
using test::Folder;
using testing::IsEmpty;

constexpr std::size_t kMegabyte = 1'000'000;

const std::string kHarbour =
    " " + dataset("harbour.asc") +
    " --profile survey --resolution 1 --vehicle small-usv --clearance 1.5 ";

/// The report over two plans of a harbour.
std::filesystem::path compared(const Folder& folder) {
  const auto run =
      folder.run("compare" + kHarbour + "--planners back-and-forth,multi-depth -o compared");
  EXPECT_EQ(run.code, 0) << run.err;
  return folder / "compared" / "report.html";
}

/// The report over one plan, judged by a criterion.
std::filesystem::path judged(const Folder& folder) {
  const auto run = folder.run("plan" + kHarbour +
                              "--planner back-and-forth --criteria s44-1a --smooth-seafloor "
                              "--positioning rtk --motion-sensor mru --water-level-uncertainty "
                              "0.05 -o judged");
  EXPECT_EQ(run.code, 0) << run.err;
  return folder / "judged" / "report.html";
}

/// A copy of the page that also writes down how wide it is and what it loaded.
std::filesystem::path probed(const Folder& folder, const std::filesystem::path& page) {
  const std::string probe =
      "<script>{ const d = document.documentElement.dataset;"
      "const cut = document.documentElement.scrollWidth - document.documentElement.clientWidth;"
      "d.probe = `${innerWidth} px, ${cut} cut off`;"
      "d.loaded = performance.getEntriesByType('resource')"
      ".filter((e) => !e.name.startsWith('data:')).map((e) => e.name).join(' '); }</script>";
  std::string text = test::text_of(page);
  text.insert(text.rfind("</body>"), probe);
  return folder.write("probed.html", text);
}

/// A page that shows another one in a frame of a phone's width, narrower than any window of the
/// browser, and holds what became of it as text.
std::filesystem::path on_a_phone(const Folder& folder, const std::filesystem::path& page) {
  std::string inner;
  for (const char c : test::text_of(page)) {
    inner += c == '&' ? "&amp;" : c == '"' ? "&quot;" : std::string(1, c);
  }
  return folder.write(
      "phone.html",
      "<!doctype html><meta charset=\"utf-8\"><link rel=\"icon\" href=\"data:,\"><iframe "
      "style=\"width:390px;height:844px;border:0\" srcdoc=\"" +
          inner +
          "\"></iframe><pre></pre><script>setTimeout(() => { "
          "document.querySelector('pre').textContent = document.querySelector('iframe')"
          ".contentDocument.documentElement.outerHTML; }, 3000)</script>");
}

// A matcher would print all of the page.
bool has(const std::string& dom, const std::string& text) {
  return dom.find(text) != std::string::npos;
}

/// data-figure -> data-value of the first element that shows it in a part of the page.
std::map<std::string, double> figures_of(const std::string& dom) {
  std::map<std::string, double> values;
  const std::regex figure(R"re(data-figure="(\w+)" data-value="([^"]+)")re");
  for (std::sregex_iterator it(dom.begin(), dom.end(), figure), end; it != end; ++it) {
    values.emplace((*it)[1], std::stod((*it)[2]));
  }
  return values;
}

std::size_t pages(const std::string& pdf) {
  std::size_t count = 0;
  for (std::size_t at = pdf.find("/Type /Page"); at != std::string::npos;
       at = pdf.find("/Type /Page", at + 1)) {
    if (pdf.at(at + 11) != 's') ++count;
  }
  return count;
}

void expect_works(const std::string& dom, int width) {
  EXPECT_TRUE(has(dom, "data-ready=\"")) << width << ": the script ran to its end";
  EXPECT_TRUE(has(dom, "data-loaded=\"\"")) << width << ": nothing was fetched";
  const std::string probe = "data-probe=\"" + std::to_string(width) + " px, 0 cut off\"";
  EXPECT_TRUE(has(dom, probe)) << width << ": nothing is cut off at the right";
  EXPECT_TRUE(has(dom, "leaflet-image-layer")) << width << ": the map shows a ground";
  EXPECT_TRUE(has(dom, "u-over")) << width << ": the charts are there";
}

void expect_works(const Folder& folder, const std::filesystem::path& report) {
  const std::filesystem::path page = probed(folder, report);
  EXPECT_LT(std::filesystem::file_size(page), 5 * kMegabyte);
  const Chromium chromium(folder);
  expect_works(chromium.dom(page), 1280);
  EXPECT_THAT(chromium.console(), IsEmpty());
  expect_works(chromium.dom(on_a_phone(folder, page)), 390);
  EXPECT_THAT(chromium.console(), IsEmpty());
  const std::string pdf = chromium.pdf(page);
  EXPECT_THAT(chromium.console(), IsEmpty());
  EXPECT_GE(pages(pdf), 2U);
  EXPECT_LE(pages(pdf), 4U);
}

TEST(ReportPage, OfOnePlanWorksOnAScreenOnAPhoneAndOnPaper) {
  if (!test::has_chromium()) GTEST_SKIP() << "skipped: chromium is not installed";
  const Folder folder;
  expect_works(folder, judged(folder));
}

TEST(ReportPage, OfSeveralPlansWorksOnAScreenOnAPhoneAndOnPaper) {
  if (!test::has_chromium()) GTEST_SKIP() << "skipped: chromium is not installed";
  const Folder folder;
  expect_works(folder, compared(folder));
}

TEST(ReportPage, OfAWholeJobHasItsBoatsSortiesAndPatchTest) {
  if (!test::has_chromium()) GTEST_SKIP() << "skipped: chromium is not installed";
  const Folder folder;
  const auto run = folder.run("plan" + kHarbour +
                              "--planner back-and-forth --berth 150,200 --boats 2 --cross-lines 5 "
                              "--patch-test -o job");
  ASSERT_EQ(run.code, 0) << run.err;
  const std::filesystem::path page = folder / "job" / "report.html";
  expect_works(folder, page);
  const std::string dom = Chromium(folder).dom(page);
  const auto plan = test::json_of(folder / "job" / "plan.json");
  for (const auto& sortie : plan.at("job").at("sorties")) {
    const int boat = sortie.at("boat");
    EXPECT_TRUE(has(dom, "Boat " + std::to_string(boat) + ", sortie 1</button>")) << boat;
  }
  for (const auto& test : plan.at("job").at("patch_test")) {
    const std::string reason = test.at("reason");
    EXPECT_TRUE(has(dom, reason)) << reason;
  }
  EXPECT_TRUE(has(dom, "Under keel")) << "the least water of each line";
}

TEST(ReportPage, ShowsTheNumbersOfScoreJson) {
  if (!test::has_chromium()) GTEST_SKIP() << "skipped: chromium is not installed";
  const Folder folder;
  const auto run = folder.run("plan" + kHarbour + "--planner back-and-forth -o out");
  ASSERT_EQ(run.code, 0) << run.err;
  const nlohmann::json score = test::json_of(folder / "out" / "score.json");
  const std::string dom = Chromium(folder).dom(folder / "out" / "report.html");
  const std::map<std::string, double> values = figures_of(dom);
  EXPECT_GE(values.size(), 25U);
  for (const auto& [key, value] : values) {
    if (key == "planning_s") continue;  // differs from run to run, so it is in no score
    EXPECT_EQ(score.at(key).get<double>(), value) << key;
  }
  // In words, as the verdict and the tiles have them; the route is some kilometres long.
  char text[200];
  std::snprintf(text, sizeof text, "%.1f km, %.1f %% logged",
                score.at("length_m").get<double>() / 1000.0,
                score.at("coverage_hit_logged_pct").get<double>());
  EXPECT_TRUE(has(dom, text)) << text;
}

}  // namespace
}  // namespace swathplan
