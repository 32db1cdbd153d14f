#include "coverage/standards/judge.h"

#include <gmock/gmock.h>

#include <random>

#include "coverage/standards/judged_gaps.h"
#include "mesh/base/error.h"

namespace swathplan {
namespace {

/// 20 x 20 cells at 10 m of water in which every rule of every criterion holds.
JudgedGrid good_grid(const char* name, std::uint32_t side = 20) {
  JudgedGrid grid;
  grid.cell_m = cell_m(criterion(name), 10.0);
  grid.columns = grid.rows = side;
  JudgedCell cell;
  cell.asked = true;
  cell.lines = 2;
  cell.soundings = cell.accepted = 6;
  cell.depth_m = 10.0F;
  cell.tvu_m = 0.1F;
  cell.thu_m = 0.5F;
  cell.feature_pings = cell.feature_beams = 4.0F;
  grid.cells.assign(std::size_t{side} * side, cell);
  return grid;
}

JudgedCell& at(JudgedGrid& grid, std::size_t column, std::size_t row) {
  return grid.cells[row * grid.columns + column];
}

void empty(JudgedCell& cell) {
  const float depth = cell.depth_m;
  cell = {};
  cell.asked = true;
  cell.depth_m = depth;
}

Verdict judged(const char* name, const JudgedGrid& grid) {
  return judge(criterion(name), std::span(&grid, 1));
}

/// The names of the rules that fail; each of them says where.
std::vector<std::string> failing(const Verdict& verdict) {
  std::vector<std::string> names;
  for (const JudgedRule& rule : verdict.rules) {
    if (rule.pass) continue;
    names.push_back(rule.name);
    EXPECT_FALSE(rule.where.empty()) << rule.name;
    EXPECT_GT(rule.failing_m2, 0.0) << rule.name;
  }
  EXPECT_EQ(verdict.pass, names.empty());
  return names;
}

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

TEST(Judge, AGoodSurveyPassesEveryCriterion) {
  for (const Criterion& order : criteria()) {
    const std::string name(order.name);
    const Verdict verdict = judged(name.c_str(), good_grid(name.c_str()));
    EXPECT_THAT(failing(verdict), IsEmpty()) << name;
    EXPECT_EQ(sentence(verdict), "predicted to pass " + std::string(order.title));
  }
}

TEST(Judge, DensityFailsAlone) {
  for (const char* name : {"s44-special", "s44-1a", "noaa-object-detection"}) {
    JudgedGrid grid = good_grid(name);
    for (std::size_t i = 0; i < 20; ++i) grid.cells[i * 20].accepted = 4;
    EXPECT_THAT(failing(judged(name, grid)), IsEmpty()) << name;  // 5 %
    at(grid, 10, 10).accepted = 4;
    const Verdict verdict = judged(name, grid);
    EXPECT_THAT(failing(verdict), ElementsAre("density")) << name;
    EXPECT_NEAR(verdict.rules[1].figure_pct, 100.0 * 379 / 400, 1e-9);
    EXPECT_THAT(sentence(verdict), StartsWith("predicted to fail "));
  }
}

TEST(Judge, LeavesEmptyCellsOutOfTheDensity) {
  JudgedGrid grid = good_grid("noaa-complete-coverage");
  for (std::size_t i = 0; i < 40; ++i) empty(grid.cells[i * 10 + (i / 2) % 2]);  // 10 %, apart
  EXPECT_THAT(failing(judged("noaa-complete-coverage", grid)), IsEmpty());
}

TEST(Judge, VerticalUncertaintyFailsAlone) {
  for (const Criterion& order : criteria()) {
    const std::string name(order.name);
    JudgedGrid grid = good_grid(name.c_str());
    const auto limit = static_cast<float>(tvu_limit_m(order, 10.0));
    for (JudgedCell& cell : grid.cells) cell.tvu_m = 0.999F * limit;
    for (std::size_t i = 0; i < 20; ++i) grid.cells[i * 20].tvu_m = 1.001F * limit;
    EXPECT_THAT(failing(judged(name.c_str(), grid)), IsEmpty()) << name;
    at(grid, 10, 10).tvu_m = 1.001F * limit;
    EXPECT_THAT(failing(judged(name.c_str(), grid)), ElementsAre("vertical uncertainty")) << name;
  }
}

TEST(Judge, HorizontalUncertaintyFailsAlone) {
  for (const Criterion& order : criteria()) {
    const std::string name(order.name);
    JudgedGrid grid = good_grid(name.c_str());
    const auto limit = static_cast<float>(thu_limit_m(order, 10.0));
    for (std::size_t i = 0; i < 21; ++i) grid.cells[i * 19].thu_m = 1.001F * limit;
    EXPECT_THAT(failing(judged(name.c_str(), grid)), ElementsAre("horizontal uncertainty")) << name;
  }
}

TEST(Judge, FeaturesFailAloneByPingsAndByBeams) {
  for (const char* name : {"s44-exclusive", "s44-special", "s44-1a"}) {
    for (const bool pings : {true, false}) {
      JudgedGrid grid = good_grid(name);
      const auto spoil = [&](std::size_t column, std::size_t row) {
        JudgedCell& cell = at(grid, column, row);
        (pings ? cell.feature_pings : cell.feature_beams) = 2.9F;
      };
      spoil(5, 5), spoil(6, 5), spoil(6, 6);
      EXPECT_THAT(failing(judged(name, grid)), IsEmpty()) << name;
      spoil(5, 6);  // a whole cube
      EXPECT_THAT(failing(judged(name, grid)), ElementsAre("features")) << name;
    }
  }
}

TEST(Judge, StatesHowManyStrikesAreAskedAndWhy) {
  const Verdict verdict = judged("s44-special", good_grid("s44-special"));
  EXPECT_THAT(verdict.rules[2].asks, HasSubstr("3 pings and 3 beams on a cube of 1 m (three by"));
  EXPECT_THAT(verdict.rules[2].asks, HasSubstr("the standard names no number"));
}

TEST(Judge, CoverageFailsAloneWhereAFeatureFitsIntoAGap) {
  for (const char* name : {"s44-special", "s44-1a"}) {
    JudgedGrid grid = good_grid(name);
    empty(at(grid, 5, 5)), empty(at(grid, 6, 5)), empty(at(grid, 7, 5)), empty(at(grid, 5, 6));
    EXPECT_THAT(failing(judged(name, grid)), IsEmpty()) << name;
    empty(at(grid, 6, 6));
    const Verdict verdict = judged(name, grid);
    EXPECT_THAT(failing(verdict), ElementsAre("coverage")) << name;
    EXPECT_NEAR(verdict.rules[0].failing_m2, 4.0 * grid.cell_m * grid.cell_m, 1e-9);
    EXPECT_EQ(verdict.rules[0].failing_places, 1U);
  }
}

TEST(Judge, TwoHundredPerCentAreTwoLines) {
  JudgedGrid grid = good_grid("s44-exclusive");
  for (std::size_t row = 3; row < 5; ++row) {
    for (std::size_t column = 8; column < 10; ++column) at(grid, column, row).lines = 1;
  }
  EXPECT_THAT(failing(judged("s44-exclusive", grid)), ElementsAre("coverage"));
  EXPECT_THAT(failing(judged("s44-special", grid)), IsEmpty());
}

TEST(Judge, ObjectDetectionForbidsThreeEmptyCellsInARow) {
  const char* name = "noaa-object-detection";
  JudgedGrid grid = good_grid(name);
  empty(at(grid, 5, 5)), empty(at(grid, 6, 5)), empty(at(grid, 5, 6)), empty(at(grid, 7, 7));
  EXPECT_THAT(failing(judged(name, grid)), IsEmpty());
  empty(at(grid, 5, 7));
  EXPECT_THAT(failing(judged(name, grid)), ElementsAre("coverage"));
  grid = good_grid(name);
  for (const std::size_t column : {17U, 18U, 19U}) empty(at(grid, column, 19));
  EXPECT_THAT(failing(judged(name, grid)), ElementsAre("coverage"));
  EXPECT_THAT(failing(judged("noaa-complete-coverage", grid)), IsEmpty());
}

TEST(Judge, CompleteCoverageForbidsNineEmptyCellsInABox) {
  const char* name = "noaa-complete-coverage";
  JudgedGrid grid = good_grid(name);
  for (std::size_t i = 0; i < 8; ++i) empty(at(grid, 4 + i % 3, 4 + i / 3));
  EXPECT_THAT(failing(judged(name, grid)), IsEmpty());
  empty(at(grid, 6, 6));
  const Verdict verdict = judged(name, grid);
  EXPECT_THAT(failing(verdict), ElementsAre("coverage"));
  EXPECT_TRUE(verdict.rules[0].where[0].position.isApprox(5.5 * grid.cell_m * Vec2::Ones()));
}

TEST(Judge, CellsThatAreNotAskedForAreNoGaps) {
  JudgedGrid grid = good_grid("s44-special");
  for (std::size_t i = 0; i < 9; ++i) {
    empty(at(grid, 4 + i % 3, 4 + i / 3));
    at(grid, 4 + i % 3, 4 + i / 3).asked = false;
  }
  const Verdict verdict = judged("s44-special", grid);
  EXPECT_THAT(failing(verdict), IsEmpty());
  EXPECT_NEAR(verdict.judged_m2, 391 * 0.25, 1e-9);
}

/// A line of soundings every `every` rows of 100 x 100 cells of 1 m, in 10 m of water: 30 m apart.
JudgedGrid lines_every(std::size_t every) {
  JudgedGrid grid = good_grid("s44-1b", 100);
  for (std::size_t i = 0; i < grid.cells.size(); ++i) {
    if ((i / 100) % every != every / 2) empty(grid.cells[i]);
  }
  return grid;
}

TEST(Judge, OrdersWithoutSearchAskForAShareAndForNearness) {
  EXPECT_THAT(failing(judged("s44-1b", lines_every(18))), IsEmpty());  // 6 %, 18 m apart
  JudgedGrid grid = lines_every(18);
  for (std::size_t i = 2000; i < 7000; ++i) empty(grid.cells[i]);
  for (std::size_t i = 9000; i < 9300; ++i) grid.cells[i] = good_grid("s44-1b").cells[0];
  EXPECT_THAT(failing(judged("s44-1b", grid)), ElementsAre("coverage"));  // over 5 %, 50 m gap
  const Verdict sparse = judged("s44-2", lines_every(25));                // 4 %, 25 m apart
  EXPECT_THAT(failing(sparse), ElementsAre("coverage"));
  EXPECT_THAT(sparse.rules[0].figure, HasSubstr("4.00 % of cells, depths 24.0 m apart"));
}

TEST(Judge, TakesGridsOfSeveralCellSizesTogether) {
  std::vector<JudgedGrid> grids(2, good_grid("s44-1a"));
  grids[1].cell_m = 2.0;
  for (JudgedCell& cell : grids[1].cells) cell.depth_m = 50.0F;
  for (JudgedCell& cell : grids[0].cells) cell.accepted = 4;
  const Verdict verdict = judge(criterion("s44-1a"), grids);
  EXPECT_THAT(failing(verdict), ElementsAre("density"));
  EXPECT_NEAR(verdict.rules[1].figure_pct, 80.0, 1e-9);
}

TEST(Judge, ListsTheLargestPlacesOnly) {
  JudgedGrid grid = good_grid("s44-special");
  for (std::size_t row = 0; row < 20; row += 4) {
    for (std::size_t i = 0; i < 2 * (2 + row / 4); ++i) empty(at(grid, i / 2, row + i % 2));
  }
  const Verdict verdict = judge(criterion("s44-special"), std::span(&grid, 1), {.list_at_most = 2});
  EXPECT_EQ(verdict.rules[0].failing_places, 5U);
  ASSERT_EQ(verdict.rules[0].where.size(), 2U);
  EXPECT_DOUBLE_EQ(verdict.rules[0].where[0].area_m2, 12 * 0.25);
}

TEST(Judge, ASurveyWithoutSoundingsFails) {
  JudgedGrid grid = good_grid("s44-special");
  for (JudgedCell& cell : grid.cells) empty(cell);
  const Verdict verdict = judged("s44-special", grid);
  EXPECT_FALSE(verdict.pass);
  for (const JudgedRule& rule : verdict.rules) EXPECT_FALSE(rule.pass) << rule.name;
  EXPECT_FALSE(judged("s44-2", grid).pass);
}

TEST(Judge, RefusesGridsWithNothingToJudge) {
  JudgedGrid grid = good_grid("s44-1a");
  for (JudgedCell& cell : grid.cells) cell.asked = false;
  EXPECT_THROW((void)judged("s44-1a", grid), InvalidInput);
  EXPECT_THROW((void)judge(criterion("s44-1a"), {}), InvalidInput);
}

TEST(JudgedGaps, DistancesAreThoseOfASlowSearch) {
  JudgedGrid grid;
  grid.columns = 23, grid.rows = 17;
  grid.cells.resize(23 * 17);
  std::mt19937 random(5);
  CellMask seen(grid.cells.size());
  for (auto& cell : seen) cell = random() % 40 == 0;
  const std::vector<float> distance = distance_in_cells(seen, grid);
  for (std::size_t i = 0; i < seen.size(); ++i) {
    double best = 1e9;
    for (std::size_t k = 0; k < seen.size(); ++k) {
      if (seen[k] != 0) best = std::min(best, (grid.centre(i) - grid.centre(k)).norm());
    }
    EXPECT_NEAR(distance[i], best, 1e-5);
  }
}

TEST(JudgedGaps, AreInfinitelyFarWhereNothingIsSeen) {
  JudgedGrid grid;
  grid.columns = grid.rows = 3;
  grid.cells.resize(9);
  EXPECT_THAT(distance_in_cells(CellMask(9, 0), grid),
              ::testing::Each(std::numeric_limits<float>::infinity()));
}

}  // namespace
}  // namespace swathplan
