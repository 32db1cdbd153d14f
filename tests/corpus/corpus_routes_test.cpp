// What routes planned over files of the corpus hold, beside the figures of expected.csv.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <regex>

#include "cli/program.h"

namespace swathplan {
namespace {

using testing::HasSubstr;
using testing::Not;

const std::string kPlanned = SWATHPLAN_SOURCE_DIR "/tests/corpus/plan/";
const std::string kRows =
    " --planner back-and-forth --resolution 0.5 --ping-spacing 1 --hit-only --heading 90 -o out";

/// The numbers of a row of route.csv from one column on.
std::vector<double> numbers_of(const std::string& csv, std::size_t row, std::size_t from,
                               std::size_t count) {
  std::istringstream in(csv);
  std::string line;
  for (std::size_t i = 0; i <= row; ++i) std::getline(in, line);
  std::istringstream fields(line);
  std::string field;
  std::vector<double> numbers;
  for (std::size_t i = 0; std::getline(fields, field, ',') && i < from + count; ++i) {
    if (i >= from) numbers.push_back(std::stod(field));
  }
  return numbers;
}

TEST(CorpusRoutes, AStartInTheDegreesOfTheFileIsWhereTheRouteBegins) {
  const test::Folder folder;
  for (const auto& [lon, lat] : {std::pair{-3.701855, 50.551694}, std::pair{-3.70505, 50.54995}}) {
    const auto run = folder.run("plan '" + kPlanned + "deg.tif' --start=" + std::to_string(lon) +
                                "," + std::to_string(lat) + kRows);
    ASSERT_EQ(run.code, 0) << run.err;
    const auto first = numbers_of(test::text_of(folder / "out/route.csv"), 1, 6, 2);
    constexpr double kMetresPerDegree = 111'195.0;
    const double east = (first[0] - lon) * kMetresPerDegree * std::cos(0.8823);
    const double north = (first[1] - lat) * kMetresPerDegree;
    EXPECT_LT(std::hypot(east, north), 60.0) << first[0] << "," << first[1];
  }
}

TEST(CorpusRoutes, LinesAcross180DegreesAreCutThere) {
  const test::Folder folder;
  const auto run = folder.run("plan '" + kPlanned + "anti.tif'" + kRows + " --export kml,gpx");
  ASSERT_EQ(run.code, 0) << run.err;
  const std::string kml = test::text_of(folder / "out/route.kml");
  EXPECT_THAT(kml, HasSubstr("179.99"));
  EXPECT_THAT(kml, HasSubstr("-179.99"));
  // No line runs around the world: neighbours in a list of places are near each other.
  const std::regex list("<coordinates>([^<]*)</coordinates>");
  std::size_t lists = 0;
  for (std::sregex_iterator it(kml.begin(), kml.end(), list), end; it != end; ++it, ++lists) {
    std::istringstream places((*it)[1].str());
    std::string place;
    double before = 0.0;
    for (bool first = true; places >> place; first = false) {
      const double lon = std::stod(place);
      if (!first) {
        EXPECT_LT(std::abs(lon - before), 1.0) << place;
      }
      before = lon;
    }
  }
  EXPECT_GT(lists, 1U);
  const auto geojson = test::json_of(folder / "out/route.geojson");
  std::size_t pieces = 0;
  const std::function<void(const nlohmann::json&)> look = [&](const nlohmann::json& places) {
    if (!places.empty() && places[0].is_array() && places[0][0].is_number()) {
      ++pieces;
      for (std::size_t i = 1; i < places.size(); ++i) {
        EXPECT_LT(std::abs(places[i][0].get<double>() - places[i - 1][0].get<double>()), 1.0);
      }
    } else if (!places.empty() && places[0].is_array()) {
      for (const auto& part : places) look(part);
    }
  };
  for (const auto& feature : geojson.at("features")) look(feature["geometry"]["coordinates"]);
  EXPECT_GE(pieces, 5U);
}

TEST(CorpusRoutes, FeetStandInColumnsThatSayFeet) {
  const test::Folder folder;
  const auto run = folder.run("plan '" + kPlanned + "ftus.tif' --z-unit us-foot" + kRows);
  ASSERT_EQ(run.code, 0) << run.err;
  const std::string csv = test::text_of(folder / "out/route.csv");
  EXPECT_THAT(csv, HasSubstr(",x_us_ft,y_us_ft,"));
  EXPECT_THAT(csv, Not(HasSubstr("x_m")));
  const auto first = numbers_of(csv, 1, 4, 2);
  EXPECT_GT(first[0], 1'012'000.0);
  EXPECT_LT(first[0], 1'013'100.0);
  // What was written can be scored and exported again.
  const auto again = folder.run("score '" + kPlanned +
                                "ftus.tif' out/route.csv --z-unit us-foot --resolution 0.5 "
                                "--ping-spacing 1 --hit-only -o again --json");
  ASSERT_EQ(again.code, 0) << again.err;
  EXPECT_NEAR(nlohmann::json::parse(again.out)["length_m"].get<double>(),
              test::json_of(folder / "out/score.json")["length_m"].get<double>(), 0.01);
  EXPECT_EQ(folder.run("export out/route.csv --format lnw -o lnw").code, 0);
  EXPECT_THAT(test::text_of(folder / "lnw/route.lnw"), HasSubstr("1012"));
}

}  // namespace
}  // namespace swathplan
