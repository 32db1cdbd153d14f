#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "mesh/base/watch.h"

namespace swathplan {

/// A Monte Carlo study: a list of cells. Each cell gives one row of figures. The row does not
/// depend on the order of work.
struct Study {
  std::string name;                  ///< of its files: NAME.csv, NAME.journal
  std::string settings;              ///< one line; a study is resumed only with the same
  std::vector<std::string> columns;  ///< of the figures, with units in their names
  std::size_t cells = 0;
  std::function<std::vector<double>(std::size_t cell)> run;  ///< thread-safe, as many as columns
};

/// Runs the cells that the folder's journal does not hold yet, on all cores that the caller allows.
/// Then it writes NAME.csv with all rows in the order of the cells. The same settings give the same
/// bytes, however often the study was interrupted and on however many threads it ran. Each finished
/// cell is appended to NAME.journal at once. If an interruption tore the last line, its cell is run
/// again. The watch is told the share of cells done. If it ends the study, no further cell begins.
/// @throws EndedEarly then, with what is done and kept; UsageError if the journal belongs to other
/// settings; InvalidInput if a file cannot be written or the journal is no journal.
[[nodiscard]] std::vector<std::vector<double>> run_study(const Study& study,
                                                         const std::filesystem::path& folder,
                                                         const Watch& watch = {});

}  // namespace swathplan
