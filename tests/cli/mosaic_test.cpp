// Several files of one seafloor on the command line.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/program.h"

namespace swathplan {
namespace {

using test::Folder;
using test::json_of;
using testing::AllOf;
using testing::HasSubstr;

/// A coarse grid 8 m deep of 2024, and a finer one 7 m deep of 2023 in its middle.
class MosaicRun : public testing::Test {
 protected:
  MosaicRun() {
    write_grid("bay_2024-05-01.asc", 0, 5, 24, 8.0);
    write_grid("basin_20230501.asc", 40, 1, 40, 7.0);
  }
  void write_grid(const std::string& name, int corner, int cell, int count, double depth) const {
    const auto text = [](auto value) { return std::to_string(value); };
    std::string grid = "ncols " + text(count) + "\nnrows " + text(count) + "\nxllcorner " +
                       text(corner) + "\nyllcorner " + text(corner) + "\ncellsize " + text(cell) +
                       "\n";
    for (int i = 0; i < count * count; ++i)
      grid += text(-depth) + (i % count == count - 1 ? "\n" : " ");
    folder.write(name, grid);
  }
  [[nodiscard]] test::Run plan(const std::string& how) const {
    return folder.run(
        "plan bay_2024-05-01.asc --planner back-and-forth --resolution 1 --beams 64 "
        "--hit-only --mosaic basin_20230501.asc " +
        how + " -o out");
  }
  Folder folder;
};

TEST_F(MosaicRun, TheFinestOrTheNewestCountsAndTheSeamIsSaid) {
  const auto finest = plan("--priority finest");
  ASSERT_EQ(finest.code, 0) << finest.err;
  EXPECT_THAT(
      finest.err,
      AllOf(HasSubstr("mosaic, the first counting most: 1521 m2 from"),
            HasSubstr("from 'basin_20230501.asc' (1 m apart)"),
            HasSubstr("of the seam the depths differ by 1.00 m (median) and up to 1.00 m")));
  // No slit along the seam stops the boat: the lines run over both.
  EXPECT_EQ(json_of(folder / "out" / "score.json")["infeasible_legs"], 0);
  const auto newest = plan("--priority newest");
  ASSERT_EQ(newest.code, 0) << newest.err;
  EXPECT_THAT(newest.err,
              HasSubstr("mosaic, the first counting most: 13225 m2 from 'bay_2024-05-01.asc' (5 m "
                        "apart, of 20240501)"));
}

TEST_F(MosaicRun, WhatCannotBeJoinedIsRefusedByItsName) {
  std::filesystem::copy_file(folder / "basin_20230501.asc", folder / "basin.asc");
  const auto undated = plan("--priority newest --mosaic basin.asc");
  EXPECT_EQ(undated.code, 1);
  EXPECT_THAT(undated.err, AllOf(HasSubstr("--priority newest: 'basin.asc' has no date"),
                                 HasSubstr("--priority order")));
  const auto missing = plan("--mosaic nothing.asc");
  EXPECT_EQ(missing.code, 1);
  EXPECT_THAT(missing.err, HasSubstr("nothing.asc"));
  folder.write("text.asc", "no grid\n");
  const auto text = plan("--mosaic text.asc");
  EXPECT_EQ(text.code, 1);
  EXPECT_THAT(text.err, HasSubstr("text.asc"));
  const auto oldest = plan("--priority oldest");
  EXPECT_EQ(oldest.code, 2);
  EXPECT_THAT(oldest.err, HasSubstr("--priority"));
}

}  // namespace
}  // namespace swathplan
