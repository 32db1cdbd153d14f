#include "io/results/adaptive_study.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <fstream>
#include <iterator>

#include "mesh/base/error.h"
#include "temporary_folder.h"

namespace swathplan {
namespace {

/// A study of five cells whose figures are the cell's number and its square; counts its runs.
struct Squares {
  std::atomic<int> runs = 0;
  [[nodiscard]] Study study(const std::string& settings = "step 1") {
    return {"squares", settings, {"number", "square"}, 5, [this](std::size_t cell) {
              ++runs;
              const auto n = static_cast<double>(cell);
              return std::vector<double>{n, n * n};
            }};
  }
};

struct Looking final : Watcher {
  void phase(const std::string&) override {}
  void share(double done) override { most = std::max(most, done); }
  void tried(std::size_t, std::size_t, const std::string&) override {}
  [[nodiscard]] bool ended() const override { return most >= until; }
  double most = 0.0, until = 2.0;
};

std::string written(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

TEST(AdaptiveStudy, WritesTheRowsInTheOrderOfTheCells) {
  const test::TemporaryFolder folder;
  Squares squares;
  Looking looking;
  const auto rows = run_study(squares.study(), folder.path(), Watch(looking));
  ASSERT_EQ(rows.size(), 5U);
  EXPECT_EQ(rows[3], (std::vector<double>{3.0, 9.0}));
  EXPECT_EQ(looking.most, 1.0);
  EXPECT_EQ(written(folder.path() / "squares.csv"),
            "number,square\r\n0,0\r\n1,1\r\n2,4\r\n3,9\r\n4,16\r\n");
}

TEST(AdaptiveStudy, ResumesAtTheJournalAndRunsATornLineAgain) {
  const test::TemporaryFolder folder;
  Squares squares;
  (void)run_study(squares.study(), folder.path(), {});
  const std::string csv = written(folder.path() / "squares.csv");
  std::string journal = written(folder.path() / "squares.journal");
  journal.resize(journal.rfind('\n'));  // the last line lost its end
  std::ofstream(folder.path() / "squares.journal", std::ios::binary) << journal;
  squares.runs = 0;
  (void)run_study(squares.study(), folder.path(), {});
  EXPECT_EQ(squares.runs, 1);
  EXPECT_EQ(written(folder.path() / "squares.csv"), csv);
}

TEST(AdaptiveStudy, OneThatIsEndedKeepsWhatIsDoneAndGoesOnFromThere) {
  const test::TemporaryFolder folder;
  Squares squares;
  Looking looking;
  looking.until = 0.4;
  Study study = squares.study();
  study.cells = 2000;  // more than threads
  try {
    (void)run_study(study, folder.path(), Watch(looking));
    FAIL() << "the study was not ended";
  } catch (const EndedEarly& e) {
    EXPECT_NE(std::string(e.what()).find(" of 2000 cells of the study are done"), std::string::npos)
        << e.what();
  }
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "squares.csv"));
  const int before = squares.runs;
  EXPECT_GE(before, 800);
  (void)run_study(study, folder.path(), {});
  EXPECT_EQ(squares.runs, 2000);
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "squares.csv"));
}

TEST(AdaptiveStudy, RefusesTheJournalOfOtherSettings) {
  const test::TemporaryFolder folder;
  Squares squares;
  (void)run_study(squares.study(), folder.path(), {});
  EXPECT_THROW((void)run_study(squares.study("step 2"), folder.path(), {}), UsageError);
}

}  // namespace
}  // namespace swathplan
