// Runs the program over each row of expected.csv, which README.md explains.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <chrono>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "cli/program.h"

namespace swathplan {
namespace {

using testing::HasSubstr;

const std::string kCorpus = SWATHPLAN_SOURCE_DIR "/tests/corpus";
constexpr double kMostSeconds = 20.0;
constexpr long kMostKilobytes = 2L << 20;  // 2 GiB

std::vector<std::string> cut(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, separator);) parts.push_back(part);
  return parts;
}

struct Figure {
  std::string name;  ///< of a member, or the path of one
  double value = 0.0, tolerance = 0.0;
};

struct Row {
  std::string command;
  int code = 0;
  std::vector<Figure> figures;
  std::vector<std::string> words;
};

/// 'name=value~tolerance'
Figure figure_of(const std::string& text) {
  const std::size_t equals = text.find('=');
  const std::size_t wave = text.find('~');
  return {text.substr(0, equals), std::stod(text.substr(equals + 1)),
          std::stod(text.substr(wave + 1))};
}

std::vector<Row> rows() {
  std::vector<Row> all;
  std::ifstream in(kCorpus + "/expected.csv");
  std::string line;
  std::getline(in, line);  // the header
  while (std::getline(in, line)) {
    const auto fields = cut(line, ';');
    Row row{.command = fields.at(0), .code = std::stoi(fields.at(1)), .figures = {}, .words = {}};
    if (fields.size() > 2) {
      for (const std::string& figure : cut(fields[2], '|'))
        row.figures.push_back(figure_of(figure));
    }
    if (fields.size() > 3) row.words = cut(fields[3], '|');
    all.push_back(row);
  }
  return all;
}

void PrintTo(const Row& row, std::ostream* out) { *out << row.command; }

double figure_in(const nlohmann::json& json, const std::string& name) {
  const nlohmann::json::json_pointer path(name.starts_with('/') ? name : "/" + name);
  return json.contains(path) ? json.at(path).get<double>() : std::nan("");
}

class Corpus : public testing::TestWithParam<Row> {};

TEST_P(Corpus, IsReadAsExpected) {
  const Row& row = GetParam();
  const test::Folder folder;
  std::string command = row.command;
  if (const std::size_t at = command.find(" OUT"); at != std::string::npos) {
    command.replace(at + 1, 3, "'" + (folder / "out").string() + "'");
  }
  const auto start = std::chrono::steady_clock::now();
  const auto run = folder.run_in(kCorpus, command);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  EXPECT_EQ(run.code, row.code) << run.err;
  for (const std::string& word : row.words) EXPECT_THAT(run.out + run.err, HasSubstr(word));
  if (row.code != 0) {
    EXPECT_THAT(run.err, HasSubstr("swathplan: "));
    EXPECT_FALSE(std::filesystem::exists(folder / "out")) << "something was written";
  }
  const auto json = row.figures.empty() ? nlohmann::json() : nlohmann::json::parse(run.out);
  for (const Figure& figure : row.figures) {
    EXPECT_NEAR(figure_in(json, figure.name), figure.value, figure.tolerance) << figure.name;
  }
  EXPECT_LT(took.count(), kMostSeconds);
  rusage used{};
  getrusage(RUSAGE_CHILDREN, &used);
  EXPECT_LT(used.ru_maxrss, kMostKilobytes) << "kilobytes of the largest child";
}

INSTANTIATE_TEST_SUITE_P(Rows, Corpus, testing::ValuesIn(rows()));

}  // namespace
}  // namespace swathplan
