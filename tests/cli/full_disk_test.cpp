#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/program.h"

namespace swathplan {
namespace {

namespace fs = std::filesystem;
using test::dataset;
using test::Folder;
using test::text_of;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

const std::string kPlan =
    "plan " + dataset("shaft.obj") +
    " --planner back-and-forth --hit-only --resolution 0.25 --crs EPSG:32630 -o out ";

/// Runs a line of the shell in the folder; $P is the program.
test::Run in_shell(const Folder& folder, const std::string& line) {
  const std::string command = "cd '" + folder.path().string() +
                              "' && export P='" SWATHPLAN_PROGRAM "' && bash -c '" + line +
                              "' 2>.said </dev/null";
  const int status = std::system(command.c_str());
  test::Run run;
  run.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128;
  run.err = text_of(folder / ".said");
  fs::remove(folder / ".said");
  return run;
}

/// All files below a folder, relative to it.
std::vector<std::string> files_in(const fs::path& folder) {
  std::vector<std::string> files;
  if (!fs::exists(folder)) return files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_directory()) files.push_back(fs::relative(entry.path(), folder).string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::string zigzag(int points) {
  std::string csv = "seq,x_m,y_m\n";
  for (int i = 0; i < points; ++i) {
    csv += std::to_string(i) + "," + std::to_string(10 * i) + "," + std::to_string(9 * (i % 2));
    csv += "\n";
  }
  return csv;
}

TEST(FullDisk, EachExportEndsInASentenceAndLeavesNothing) {
  const Folder folder;
  folder.write("zigzag.csv", zigzag(4000));
  for (const char* format : {"waypoints", "plan", "gpx", "rtz", "kml", "lnw", "dxf"}) {
    const auto run =
        in_shell(folder, std::string("ulimit -f 16; timeout 60 $P export zigzag.csv --crs "
                                     "EPSG:32630 -o out --format ") +
                             format);
    EXPECT_EQ(run.code, 1) << format << run.err;
    EXPECT_THAT(run.err, HasSubstr(std::string("cannot write 'out/zigzag.") + format)) << format;
    EXPECT_THAT(run.err, HasSubstr("no file of this run was written")) << format;
    EXPECT_THAT(files_in(folder / "out"), IsEmpty()) << format;
  }
}

TEST(FullDisk, APlanIsWrittenWholeOrNotAtAll) {
  const Folder folder;
  ASSERT_EQ(folder.run(kPlan + "--export gpx,dxf").code, 0);
  const auto before = files_in(folder / "out");
  const std::string route = text_of(folder / "out" / "route.csv");
  const auto run = in_shell(folder, "ulimit -f 40; timeout 60 $P " + kPlan + "--heading 30");
  EXPECT_EQ(run.code, 1) << run.err;
  EXPECT_THAT(run.err, HasSubstr("cannot write 'out/"));
  EXPECT_THAT(run.err, HasSubstr("no file of this run was written to 'out'"));
  EXPECT_EQ(files_in(folder / "out"), before);
  EXPECT_EQ(text_of(folder / "out" / "route.csv"), route) << "the older plan, all of it";
}

TEST(FullDisk, WhatIsPrintedCountsAsWritten) {
  const Folder folder;
  for (const std::string more : {"--json", ""}) {
    const auto run = in_shell(folder, "timeout 60 $P " + kPlan + more + " >/dev/full");
    EXPECT_EQ(run.code, 1) << run.err;
    EXPECT_THAT(run.err, HasSubstr("cannot write to standard output (No space left on device)"));
    EXPECT_TRUE(fs::exists(folder / "out" / "route.csv"));
  }
  const auto run =
      in_shell(folder, "timeout 60 $P inspect " + dataset("shaft.obj") + " --json >/dev/full");
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.err, HasSubstr("cannot write to standard output"));
}

TEST(ClosedStreams, NobodyToReadTheMessagesDoesNotEndAPlan) {
  const Folder folder;
  for (const char* stream : {"2>&-", "2>/dev/full", "2>&- </dev/null 0<&-"}) {
    fs::remove_all(folder / "out");
    const auto run = in_shell(folder, "timeout 60 $P " + kPlan + ">table " + stream);
    EXPECT_EQ(run.code, 0) << stream;
    EXPECT_THAT(text_of(folder / "table"), HasSubstr("report: ")) << stream;
    EXPECT_THAT(text_of(folder / "out" / "route.csv"), testing::StartsWith("seq,line,"));
  }
  // Wrong input still ends in its own code.
  EXPECT_EQ(in_shell(folder, "timeout 60 $P plan nothing.asc -o out 2>&-").code, 1);
  EXPECT_EQ(in_shell(folder, "timeout 60 $P plan --never 2>/dev/full").code, 2);
}

TEST(ClosedStreams, AClosedStdoutNeverEndsUpInAFile) {
  const Folder folder;
  const auto run = in_shell(folder, "timeout 60 $P " + kPlan + ">&-");
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.err, HasSubstr("cannot write to standard output"));
  for (const auto& entry : fs::directory_iterator(folder / "out")) {
    EXPECT_THAT(text_of(entry.path()), Not(HasSubstr("report: out"))) << entry.path();
  }
}

TEST(ClosedStreams, ABrokenPipeEndsInTheCodeOfAnError) {
  const Folder folder;
  const auto run = in_shell(
      folder, "{ timeout 60 $P " + kPlan + "--json; echo $? >code; } | sleep 0; sleep 0.1");
  EXPECT_EQ(text_of(folder / "code"), "1\n");
  EXPECT_THAT(run.err, HasSubstr("cannot write to standard output (Broken pipe)"));
  EXPECT_TRUE(fs::exists(folder / "out" / "route.csv"));
}

TEST(Outputs, ADeviceIsNotReplaced) {
  const Folder folder;
  const auto run = folder.run("synth flat -o /dev/null");
  EXPECT_NE(run.code, 0);
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  ASSERT_EQ(in_shell(folder, "mkfifo pipe.obj").code, 0);
  const auto piped = folder.run("synth flat -o pipe.obj");
  EXPECT_EQ(piped.code, 1);
  EXPECT_THAT(piped.err, HasSubstr("pipe.obj"));
  EXPECT_TRUE(fs::is_fifo(folder / "pipe.obj"));
}

TEST(Outputs, ARouteIsNotReplacedByAThinnerOneOfItself) {
  const Folder folder;
  folder.write("zigzag.csv", zigzag(5));
  ASSERT_EQ(folder.run("export zigzag.csv --crs EPSG:32630 --format gpx").code, 0);
  const std::string before = text_of(folder / "zigzag.gpx");
  const auto run = folder.run("export zigzag.gpx --format rtz,gpx --tolerance 20");
  EXPECT_EQ(run.code, 2) << run.err;
  EXPECT_THAT(run.err, HasSubstr("would replace 'zigzag.gpx' itself"));
  EXPECT_EQ(text_of(folder / "zigzag.gpx"), before);
  EXPECT_FALSE(fs::exists(folder / "zigzag.rtz"));
}

}  // namespace
}  // namespace swathplan
