#include "coverage/holidays.h"

#include <gtest/gtest.h>

#include <functional>

#include "coverage/scenes.h"

namespace swathplan {
namespace {

/// Rows from the north: '#' hit, '.' empty, 'f' empty under a footprint, ' ' outside the area,
/// 'u' hit but not logged.
CoverageGrid drawn(const std::vector<std::string>& rows) {
  const auto columns = static_cast<double>(rows.front().size());
  CoverageGrid grid(testing::rectangle(0, 0, 0.5 * columns, 0.5 * static_cast<double>(rows.size())),
                    0.5);
  for (std::size_t r = 0; r < rows.size(); ++r) {
    for (std::size_t c = 0; c < rows[r].size(); ++c) {
      std::uint32_t& word = grid.words()[(rows.size() - 1 - r) * rows[r].size() + c];
      const char sign = rows[r][c];
      if (sign == ' ') word = 0;
      if (sign == '#') word |= 1U | 1U << CoverageGrid::kLoggedShift;
      if (sign == 'u') word |= 1U;
      if (sign == 'f') word |= CoverageGrid::kFootprint;
    }
  }
  return grid;
}

TEST(Holidays, NoneInAFullGrid) {
  const Holidays h = find_holidays(drawn({"####", "####"}), {});
  EXPECT_EQ(h.count, 0U);
  EXPECT_EQ(h.largest_m2, 0.0);
  EXPECT_TRUE(h.list.empty());
}

TEST(Holidays, AreConnectedBySidesNotByCorners) {
  const Holidays h = find_holidays(drawn({"######",  //
                                          "#.##.#",  //
                                          "#..#.#",  //
                                          "###.##",  //
                                          "######"}),
                                   {});
  ASSERT_EQ(h.count, 3U);
  EXPECT_EQ(h.list[0].cells, 3U);
  EXPECT_NEAR(h.list[0].area_m2, 0.75, 1e-12);
  EXPECT_NEAR(h.total_m2, 6 * 0.25, 1e-12);
  EXPECT_NEAR(h.largest_m2, 0.75, 1e-12);
  EXPECT_EQ(h.list[0].box.min, Vec2(0.5, 1.0));
  EXPECT_EQ(h.list[0].box.max, Vec2(1.5, 2.0));
  EXPECT_EQ(h.list[2].cells, 1U);
}

TEST(Holidays, ArmsThatMeetLaterAreOneGap) {
  const Holidays h = find_holidays(drawn({"#########",  //
                                          "#.......#",  //
                                          "#.#.#.#.#",  //
                                          "#.#.#.#.#",  //
                                          "#########"}),
                                   {});
  ASSERT_EQ(h.count, 1U);
  EXPECT_EQ(h.list[0].cells, 15U);
  const Holidays spiral = find_holidays(drawn({"#########",  //
                                               "#.......#",  //
                                               "#.#####.#",  //
                                               "#.#.###.#",  //
                                               "#.#.....#",  //
                                               "#.#######",  //
                                               "#.......#",  //
                                               "#########"}),
                                        {});
  EXPECT_EQ(spiral.count, 1U);
}

TEST(Holidays, ThePositionIsACellOfTheGap) {
  // The centroid of this ring is not empty.
  const Holidays h = find_holidays(drawn({"#######",  //
                                          "#.....#",  //
                                          "#.###.#",  //
                                          "#.###.#",  //
                                          "#.....#",  //
                                          "#######"}),
                                   {});
  ASSERT_EQ(h.list.size(), 1U);
  const Vec2 p = h.list[0].position;
  EXPECT_NEAR(p.y(), 0.75, 1e-12);  // the southern one of the two nearest cells
  EXPECT_NEAR(p.x(), 1.75, 1e-12);
}

TEST(Holidays, HaveACause) {
  const Holidays h = find_holidays(drawn({"##########",  //
                                          "#ff#..## .",  //
                                          "#f##.f## #",  //
                                          "#.##.###.#",  //
                                          "#######..#",  //
                                          "##########"}),
                                   {});
  ASSERT_EQ(h.count, 4U);
  EXPECT_EQ(h.list[0].cause, HolidayCause::between_lines);  // 4 cells, 1 of them under a footprint
  EXPECT_EQ(h.list[1].cells, 4U);
  EXPECT_EQ(h.list[2].cause, HolidayCause::edge);  // below the cell outside
  EXPECT_EQ(h.list[3].cause, HolidayCause::edge);
  std::size_t beams = 0;
  for (const Holiday& gap : h.list) beams += gap.cause == HolidayCause::between_beams;
  EXPECT_EQ(beams, 1U);
  EXPECT_EQ(name(HolidayCause::between_beams), "between_beams");
}

TEST(Holidays, OneThatIsAPartOfTheAreaOfItsOwnHasNoLine) {
  const Holidays h = find_holidays(drawn({"##### ....",  //
                                          "#..## ....",  //
                                          "#..#. ....",  //
                                          "##### ...."}),
                                   {});
  ASSERT_EQ(h.list.size(), 3U);
  EXPECT_EQ(h.list[0].cause, HolidayCause::no_line);
  EXPECT_EQ(h.list[1].cause, HolidayCause::between_lines);
  EXPECT_EQ(h.list[2].cause, HolidayCause::edge);
  EXPECT_EQ(name(HolidayCause::no_line), "no_line");
  EXPECT_EQ(find_holidays(drawn({"fff", "fff"}), {}).list[0].cause, HolidayCause::between_beams);
}

TEST(Holidays, SmallOnesAreCountedButNotListedAndTheListHasAnEnd) {
  const CoverageGrid grid = drawn({".#.#..#...", "##########", "....#.#.#.", "##########"});
  const Holidays large = find_holidays(grid, {.smallest_m2 = 0.5});
  EXPECT_EQ(large.count, 8U);
  ASSERT_EQ(large.list.size(), 3U);
  EXPECT_EQ(large.list[0].cells, 4U);
  const Holidays two = find_holidays(grid, {.list_at_most = 2});
  EXPECT_EQ(two.count, 8U);
  ASSERT_EQ(two.list.size(), 2U);
  EXPECT_EQ(two.list[1].cells, 3U);
}

TEST(Holidays, LoggedOnlyTakesWhatWasNotLoggedAsEmpty) {
  const CoverageGrid grid = drawn({"##uu##", "##..##"});
  EXPECT_EQ(find_holidays(grid, {}).list.at(0).cells, 2U);
  EXPECT_EQ(find_holidays(grid, {.logged_only = true}).list.at(0).cells, 4U);
}

TEST(Holidays, GetOutlinesTheLargestFirst) {
  const CoverageGrid grid = drawn({"######",  //
                                   "#.##.#",  //
                                   "#..#.#",  //
                                   "###.##",  //
                                   "######"});
  EXPECT_TRUE(find_holidays(grid, {}).list[0].outline.outer.empty());
  const Holidays all = find_holidays(grid, {.outline_corners = 100});
  EXPECT_EQ(all.list[0].outline.outer.size(), 6U);
  for (const Holiday& gap : all.list) EXPECT_NEAR(area_m2({gap.outline}), gap.area_m2, 1e-12);
  const Holidays some = find_holidays(grid, {.outline_corners = 6});
  EXPECT_FALSE(some.list[0].outline.outer.empty());
  EXPECT_TRUE(some.list[1].outline.outer.empty());
}

TEST(Holidays, AgreeWithAFloodFillOnRandomGrids) {
  std::mt19937 random(9);
  for (int trial = 0; trial < 30; ++trial) {
    std::vector<std::string> rows(23, std::string(31, '#'));
    for (std::string& row : rows) {
      for (char& sign : row) {
        if (random() % 100 < 45U) sign = '.';
        if (random() % 100 < 5U) sign = ' ';
      }
    }
    std::vector<std::size_t> sizes;
    std::function<std::size_t(std::size_t, std::size_t)> flood = [&](std::size_t r, std::size_t c) {
      if (r >= rows.size() || c >= rows[r].size() || rows[r][c] != '.') return std::size_t{0};
      rows[r][c] = 'x';
      return 1 + flood(r + 1, c) + flood(r - 1, c) + flood(r, c + 1) + flood(r, c - 1);
    };
    const CoverageGrid grid = drawn(rows);
    for (std::size_t r = 0; r < rows.size(); ++r) {
      for (std::size_t c = 0; c < rows[r].size(); ++c) {
        if (const std::size_t n = flood(r, c); n > 0) sizes.push_back(n);
      }
    }
    std::sort(sizes.rbegin(), sizes.rend());
    const Holidays h = find_holidays(grid, {});
    ASSERT_EQ(h.count, sizes.size());
    for (std::size_t i = 0; i < sizes.size(); ++i) EXPECT_EQ(h.list[i].cells, sizes[i]);
    for (const Holiday& gap : h.list) {
      const auto c = static_cast<std::size_t>(gap.position.x() / 0.5);
      const auto r = static_cast<std::size_t>(gap.position.y() / 0.5);
      EXPECT_EQ(grid.soundings(r * 31 + c), 0U);
      EXPECT_TRUE(grid.counts(r * 31 + c));
    }
  }
}

}  // namespace
}  // namespace swathplan
