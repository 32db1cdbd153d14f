#include "io/results/adaptive_study.h"

#include <fmt/format.h>

#include <charconv>
#include <fstream>
#include <mutex>
#include <string_view>

#include "io/files/atomic_file.h"
#include "mesh/base/error.h"
#include "mesh/base/parallel.h"

namespace swathplan {
namespace {

using Rows = std::vector<std::vector<double>>;

std::string heading(const Study& study) {
  return fmt::format("swathplan study {} | {}", study.name, study.settings);
}

// 'cell,figure,figure,...' or nothing if the line is not whole.
bool read_line(std::string_view line, const Study& study, Rows& rows) {
  std::vector<double> numbers;
  while (!line.empty()) {
    const auto comma = line.find(',');
    const std::string_view field = line.substr(0, comma);
    double value = 0.0;
    const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
    if (error != std::errc() || end != field.data() + field.size()) return false;
    numbers.push_back(value);
    line = comma == std::string_view::npos ? std::string_view() : line.substr(comma + 1);
  }
  if (numbers.size() != study.columns.size() + 1) return false;
  if (!(numbers[0] >= 0.0) || numbers[0] >= static_cast<double>(study.cells)) return false;
  rows[static_cast<std::size_t>(numbers[0])].assign(numbers.begin() + 1, numbers.end());
  return true;
}

Rows read_journal(const std::filesystem::path& path, const Study& study) {
  Rows rows(study.cells);
  std::ifstream in(path);
  std::string line;
  if (!in || !std::getline(in, line)) return rows;
  if (line != heading(study)) {
    throw UsageError(
        fmt::format("{} belongs to another study or other settings ({}); choose "
                    "another output folder or remove it",
                    path.string(), line.substr(0, 200)));
  }
  while (std::getline(in, line)) {
    // A line without its end was torn by the interruption; what follows it was never written.
    if (in.eof() || !read_line(line, study, rows)) break;
  }
  return rows;
}

std::string line_of(std::size_t cell, const std::vector<double>& row) {
  std::string line = fmt::format("{}", cell);
  for (const double v : row) line += fmt::format(",{}", v);
  return line + "\n";
}

// The journal is written anew on each start, so that a torn line does not stay in its middle.
std::ofstream open_journal(const std::filesystem::path& path, const Study& study,
                           const Rows& rows) {
  std::string text = heading(study) + "\n";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!rows[i].empty()) text += line_of(i, rows[i]);
  }
  write_text_atomically(path, text);
  std::ofstream out(path, std::ios::app);
  if (!out) throw InvalidInput(fmt::format("{} cannot be written", path.string()));
  return out;
}

std::string csv_of(const Study& study, const Rows& rows) {
  std::string text;
  for (std::size_t i = 0; i < study.columns.size(); ++i) {
    text += (i > 0 ? "," : "") + study.columns[i];
  }
  text += "\r\n";
  for (const auto& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i)
      text += fmt::format("{}{}", i > 0 ? "," : "", row[i]);
    text += "\r\n";
  }
  return text;
}

}  // namespace

std::vector<std::vector<double>> run_study(const Study& study, const std::filesystem::path& folder,
                                           const Watch& watch) {
  std::filesystem::create_directories(folder);
  const auto journal_path = folder / (study.name + ".journal");
  Rows rows = read_journal(journal_path, study);
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].empty()) open.push_back(i);
  }
  std::ofstream journal = open_journal(journal_path, study, rows);
  std::mutex mutex;
  std::size_t done = rows.size() - open.size();
  for_each_index(std::size_t{0}, open.size(), [&](std::size_t k) {
    if (watch.ended()) return;
    std::vector<double> row = study.run(open[k]);
    const std::lock_guard lock(mutex);
    journal << line_of(open[k], row) << std::flush;
    if (!journal) {
      throw InvalidInput(
          fmt::format("{} cannot be written; is the disk full?", journal_path.string()));
    }
    rows[open[k]] = std::move(row);
    ++done;
    watch.share(static_cast<double>(done) / static_cast<double>(rows.size()));
  });
  if (done < rows.size()) {
    throw EndedEarly(fmt::format(
        "ended early: {} of {} cells of the study are done and kept in '{}'; the same command goes "
        "on from there",
        done, rows.size(), journal_path.string()));
  }
  write_text_atomically(folder / (study.name + ".csv"), csv_of(study, rows));
  return rows;
}

}  // namespace swathplan
