#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "io/covered/covered_raster_internal.h"
#include "io/files/crs.h"
#include "io/files/text.h"

namespace swathplan {
namespace {

enum class CellMeaning { soundings, mask, values };

/// Names of bands that count soundings.
bool is_count_name(const std::string& band) {
  const std::string name = lower(band);
  constexpr std::array kNames = {"soundings per cell", "density",  "hit count",
                                 "num_soundings",      "num_hits", "count"};
  return std::any_of(kNames.begin(), kNames.end(),
                     [&](const char* known) { return name.find(known) != std::string::npos; });
}

CellMeaning meaning_of(const GridCells& cells) {
  if (is_count_name(cells.band)) return CellMeaning::soundings;
  if (!cells.counts) return CellMeaning::values;
  double other = 0.0;
  for (const double value : cells.values) {
    if (std::isnan(value) || value == 0.0 || value == other) continue;
    if (other != 0.0) return CellMeaning::soundings;
    other = value;
  }
  return CellMeaning::mask;
}

/// Places between local metres and the raster.
class RasterPlaces {
 public:
  RasterPlaces(const GridCells& cells, const Frame& frame) : cells_(cells), frame_(frame) {
    if (cells.crs_wkt.empty() || frame.crs_wkt.empty() || cells.crs_wkt == frame.crs_wkt) return;
    from_frame_.emplace(frame.crs_wkt, cells.crs_wkt);
    to_frame_.emplace(cells.crs_wkt, frame.crs_wkt);
  }

  [[nodiscard]] std::vector<Vec2> local(std::vector<Vec2> in_raster) const {
    if (to_frame_) in_raster = (*to_frame_)(in_raster);
    for (Vec2& p : in_raster) p = frame_.to_local(p);
    return in_raster;
  }
  [[nodiscard]] std::vector<Vec2> in_raster(std::vector<Vec2> local) const {
    for (Vec2& p : local) p = frame_.to_file(p);
    return from_frame_ ? (*from_frame_)(local) : local;
  }

  /// Of a corner of cells; centres are at halves.
  [[nodiscard]] Vec2 place(double column, double row) const {
    const auto& t = cells_.transform;
    return {t[0] + column * t[1] + row * t[2], t[3] + column * t[4] + row * t[5]};
  }
  [[nodiscard]] std::optional<double> value(const Vec2& in_raster) const {
    const auto& t = cells_.transform;
    const double det = t[1] * t[5] - t[2] * t[4];
    const Vec2 off = in_raster - Vec2(t[0], t[3]);
    const double c = (off.x() * t[5] - off.y() * t[2]) / det;
    const double r = (off.y() * t[1] - off.x() * t[4]) / det;
    if (!(c >= 0.0 && r >= 0.0 && c < static_cast<double>(cells_.columns) &&
          r < static_cast<double>(cells_.rows))) {
      return std::nullopt;
    }
    const double found =
        cells_.values[static_cast<std::size_t>(r) * cells_.columns + static_cast<std::size_t>(c)];
    return std::isnan(found) ? std::nullopt : std::optional(found);
  }

  /// Side of a cell of the raster at its middle, metres.
  [[nodiscard]] double cell_m() const {
    const double c = std::floor(0.5 * static_cast<double>(cells_.columns));
    const double r = std::floor(0.5 * static_cast<double>(cells_.rows));
    const auto corner = local({place(c, r), place(c + 1, r), place(c, r + 1)});
    const Vec2 a = corner[1] - corner[0];
    const Vec2 b = corner[2] - corner[0];
    return std::sqrt(std::abs(a.x() * b.y() - a.y() * b.x()));
  }

 private:
  const GridCells& cells_;
  const Frame& frame_;
  std::optional<CrsTransform> from_frame_, to_frame_;
};

void add_value(double value, CellMeaning meaning, std::size_t cell, CoveredBefore& before) {
  if (meaning == CellMeaning::values || (meaning == CellMeaning::mask && value > 0.0)) {
    before.cover(cell);
  } else if (meaning == CellMeaning::soundings && value >= 1.0) {
    before.add(cell, static_cast<std::uint32_t>(std::min(value, 65535.0)));
  }
}

/// Each cell of the survey looks up the raster's cell at its centre.
void look_up(const RasterPlaces& places, CellMeaning meaning, CoveredBefore& before) {
  const CoverageGrid& grid = before.grid();
  std::vector<Vec2> centres;
  std::vector<std::size_t> cells;
  for (std::uint32_t r = 0; r < grid.rows(); ++r) {
    centres.clear();
    cells.clear();
    for (std::uint32_t c = 0; c < grid.columns(); ++c) {
      const std::size_t i = std::size_t{r} * grid.columns() + c;
      if (!grid.counts(i)) continue;
      cells.push_back(i);
      centres.push_back(grid.centre(c, r));
    }
    const std::vector<Vec2> there = places.in_raster(centres);
    for (std::size_t k = 0; k < cells.size(); ++k) {
      if (const auto value = places.value(there[k])) add_value(*value, meaning, cells[k], before);
    }
  }
}

/// The raster's cells are finer: each falls into one of the survey.
void pour_in(const GridCells& cells, const RasterPlaces& places, CellMeaning meaning,
             CoveredBefore& before) {
  std::vector<Vec2> centres(cells.columns);
  for (std::size_t r = 0; r < cells.rows; ++r) {
    for (std::size_t c = 0; c < cells.columns; ++c) {
      centres[c] = places.place(static_cast<double>(c) + 0.5, static_cast<double>(r) + 0.5);
    }
    const std::vector<Vec2> local = places.local(centres);
    for (std::size_t c = 0; c < cells.columns; ++c) {
      const double value = cells.values[r * cells.columns + c];
      if (std::isnan(value)) continue;
      if (const auto cell = before.cell_at(local[c])) add_value(value, meaning, *cell, before);
    }
  }
}

}  // namespace

std::string add_raster(const GridCells& cells, const Frame& frame, CoveredBefore& before,
                       Box2& where) {
  // Cells that are as large as the survey's, but for rounding, are looked up.
  constexpr double kAsLarge = 0.99;
  const RasterPlaces places(cells, frame);
  const CellMeaning meaning = meaning_of(cells);
  const auto columns = static_cast<double>(cells.columns);
  const auto rows = static_cast<double>(cells.rows);
  for (const Vec2& corner : places.local({places.place(0, 0), places.place(columns, 0),
                                          places.place(0, rows), places.place(columns, rows)})) {
    where.extend(corner);
  }
  if (places.cell_m() < kAsLarge * before.grid().resolution_m()) {
    pour_in(cells, places, meaning, before);
  } else {
    look_up(places, meaning, before);
  }
  switch (meaning) {
    case CellMeaning::soundings:
      return "soundings a cell";
    case CellMeaning::mask:
      return "cells that are not 0";
    case CellMeaning::values:
      break;
  }
  return "cells with a value";
}

}  // namespace swathplan
