#include <algorithm>

#include "coverage/tracing/footprint.h"

namespace swathplan {

namespace {

inline std::uint32_t flagged(std::uint32_t word, std::uint32_t flags) {
  const std::uint32_t in_area = (word & CoverageGrid::kInArea) != 0 ? ~0U : 0U;
  return word | (flags & in_area);
}

SWATHPLAN_EVERY_CPU
void mark_across(std::uint32_t* words, std::size_t n, std::int32_t cell, const std::int32_t* low,
                 const std::int32_t* high, std::uint32_t flags) {
  for (std::size_t i = 0; i < n; ++i) {
    words[i] = flagged(words[i], ((low[i] <= cell) & (cell <= high[i])) ? flags : 0U);
  }
}

SWATHPLAN_EVERY_CPU
void mark_along(std::uint32_t* words, std::size_t n, std::uint32_t flags) {
  for (std::size_t i = 0; i < n; ++i) words[i] = flagged(words[i], flags);
}

void mark_row(std::int32_t row, std::int32_t low, std::int32_t high, std::uint32_t flags,
              CoverageGrid& grid) {
  low = std::max(low, 0);
  high = std::min(high, static_cast<std::int32_t>(grid.columns()) - 1);
  if (low > high) return;
  mark_along(grid.words().data() + static_cast<std::size_t>(row) * grid.columns() +
                 static_cast<std::size_t>(low),
             static_cast<std::size_t>(high - low) + 1, flags);
}

template <class Visit>
void rows_of_band(std::int32_t low, std::int32_t high, Bands bands, std::uint32_t band,
                  const CoverageGrid& grid, Visit visit) {
  low = std::max(low, 0);
  high = std::min(high, static_cast<std::int32_t>(grid.rows()) - 1);
  for (std::int32_t row = low; row <= high; ++row) {
    if (bands.of_row(static_cast<std::uint32_t>(row)) == band) visit(row);
  }
}

void mark_columns(const SweptPatch& patch, Bands bands, std::uint32_t band, CoverageGrid& grid) {
  const std::int32_t low = *std::min_element(patch.low.begin(), patch.low.end());
  const std::int32_t high = *std::max_element(patch.high.begin(), patch.high.end());
  rows_of_band(low, high, bands, band, grid, [&](std::int32_t row) {
    mark_across(grid.words().data() + static_cast<std::size_t>(row) * grid.columns() +
                    static_cast<std::size_t>(patch.first_line),
                patch.low.size(), row, patch.low.data(), patch.high.data(), patch.flags);
  });
  for (const LineCells& more : patch.more) {
    rows_of_band(more.low, more.high, bands, band, grid,
                 [&](std::int32_t row) { mark_row(row, more.line, more.line, patch.flags, grid); });
  }
}

void mark_rows(const SweptPatch& patch, Bands bands, std::uint32_t band, CoverageGrid& grid) {
  const auto lines = static_cast<std::int32_t>(patch.low.size());
  rows_of_band(patch.first_line, patch.first_line + lines - 1, bands, band, grid,
               [&](std::int32_t row) {
                 const auto i = static_cast<std::size_t>(row - patch.first_line);
                 mark_row(row, patch.low[i], patch.high[i], patch.flags, grid);
               });
  for (const LineCells& more : patch.more) {
    if (bands.of_row(static_cast<std::uint32_t>(more.line)) == band) {
      mark_row(more.line, more.low, more.high, patch.flags, grid);
    }
  }
}

}  // namespace

void mark_band(const SweptPatch& patch, Bands bands, std::uint32_t band, CoverageGrid& grid) {
  if (patch.by_columns) {
    mark_columns(patch, bands, band, grid);
  } else {
    mark_rows(patch, bands, band, grid);
  }
}

}  // namespace swathplan
