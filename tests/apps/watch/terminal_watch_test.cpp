#include "apps/watch/terminal_watch.h"

#include <gtest/gtest.h>

namespace swathplan {
namespace {

Showing searching() {
  Showing s;
  s.phase = "searching";
  s.tried = 12;
  s.of = 36;
  s.best = "97.53 % in 0.87 h, 5664 m";
  s.gone = std::chrono::duration<double>(3723.4);
  s.of_phase = std::chrono::duration<double>(20.0);
  return s;
}

TEST(TerminalLine, SaysPhaseTriedGoneLeftAndBest) {
  EXPECT_EQ(line_of(searching(), 200),
            "searching: 12 of 36 tried | 1:02:03 gone, 0:40 left | best 97.53 % in 0.87 h, 5664 m");
}

TEST(TerminalLine, IsCutBetweenItsPartsAndNeverWithinANumber) {
  const std::string whole = line_of(searching(), 200);
  EXPECT_EQ(line_of(searching(), whole.size()), whole);
  EXPECT_EQ(line_of(searching(), whole.size() - 1),
            "searching: 12 of 36 tried | 1:02:03 gone, 0:40 left | best 97.53 % in 0.87 h");
  EXPECT_EQ(line_of(searching(), 60), "searching: 12 of 36 tried | 1:02:03 gone, 0:40 left");
  Showing reading;
  reading.phase = "reading \xc3\xb6\xc3\xb6\xc3\xb6.tif";
  EXPECT_EQ(line_of(reading, 9), "reading ");  // no half of a character
}

TEST(TerminalLine, SaysWhatIsKnownOnly) {
  Showing s;
  s.phase = "reading harbour.asc";
  s.gone = s.of_phase = std::chrono::duration<double>(0.7);
  EXPECT_EQ(line_of(s, 80), "reading harbour.asc | 0:01 gone");
  s.phase = "scoring";
  s.share = 0.25;
  s.of_phase = std::chrono::duration<double>(15.0);
  EXPECT_EQ(line_of(s, 80), "scoring: 25 % | 0:01 gone, 0:45 left");
}

TEST(TerminalWatch, EndsNothingUnasked) {
  TerminalWatch watch(true);
  const Watch handle(watch);
  handle.phase("searching");
  handle.tried(1, 2, "one");
  handle.share(0.5);
  EXPECT_FALSE(handle.ended());
  EXPECT_FALSE(Watch().ended());
}

}  // namespace
}  // namespace swathplan
