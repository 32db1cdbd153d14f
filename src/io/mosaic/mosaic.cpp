#include "io/mosaic/mosaic.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "io/files/crs.h"
#include "io/mosaic/file_date.h"
#include "io/mosaic/zipped.h"
#include "mesh/base/error.h"
#include "mesh/survey_area.h"

namespace swathplan {
namespace {

namespace fs = std::filesystem;

/// Neighbouring tiles end in the middle of their last cells: the gap between is a cell and its
/// diagonal, in cells of the coarser one.
constexpr double kBridge = 1.6;

struct Piece {
  ImportedSeafloor data;
  std::string name, date;
  double ground_m2 = 0.0;
};

/// Places of one local frame in another.
void bring_to(const Frame& own, const Frame& frame, Ring& ring) {
  for (Vec2& p : ring) p = own.to_file(p);
  if (own.crs_wkt != frame.crs_wkt) ring = CrsTransform(own.crs_wkt, frame.crs_wkt)(ring);
  for (Vec2& p : ring) p = frame.to_local(p);
}

/// Brings the piece into the frame of the first one.
void bring_to(const Frame& frame, Piece& piece, const std::string& first) {
  Seafloor& seafloor = piece.data.seafloor;
  const Frame& own = seafloor.frame;
  if (own.crs_wkt.empty() != frame.crs_wkt.empty()) {
    throw InvalidInput(fmt::format(
        "'{}' and '{}' cannot be joined: one has a coordinate reference system and the other has "
        "none; give it with <CRS>",
        first, piece.name));
  }
  std::vector<Vec2> places;
  places.reserve(seafloor.vertices.size());
  for (const Vec3& v : seafloor.vertices) places.push_back(own.to_file(v.head<2>()));
  if (own.crs_wkt != frame.crs_wkt) places = CrsTransform(own.crs_wkt, frame.crs_wkt)(places);
  for (std::size_t i = 0; i < places.size(); ++i) {
    seafloor.vertices[i].head<2>() = frame.to_local(places[i]);
  }
  for (Polygon& polygon : piece.data.land) {
    bring_to(own, frame, polygon.outer);
    for (Ring& hole : polygon.holes) bring_to(own, frame, hole);
  }
  seafloor.frame = frame;
}

void sort_pieces(std::vector<Piece>& pieces, MosaicPriority priority) {
  if (priority == MosaicPriority::finest) {
    std::stable_sort(pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) {
      return a.data.spacing_m < b.data.spacing_m;
    });
  }
  if (priority != MosaicPriority::newest) return;
  for (Piece& piece : pieces) {
    const auto date = file_date(piece.data.file);
    if (!date) {
      throw InvalidInput(fmt::format(
          "<priority> newest: '{}' has no date, neither in the file nor in its name (as "
          "survey_20250923.tif); use <priority> order and name the newest first",
          piece.data.file));
    }
    piece.date = *date;
  }
  std::stable_sort(pieces.begin(), pieces.end(),
                   [](const Piece& a, const Piece& b) { return a.date > b.date; });
}

std::string step_text(std::vector<double> steps) {
  if (steps.empty()) return "they do not overlap, so no step at the seam is known";
  for (double& s : steps) s = std::abs(s);
  std::sort(steps.begin(), steps.end());
  return fmt::format(
      "at {} places of the seam the depths differ by {:.2f} m (median) and up to "
      "{:.2f} m",
      steps.size(), steps[steps.size() / 2], steps.back());
}

std::string parts_text(const std::vector<Piece>& pieces) {
  std::vector<std::string> parts;
  for (const Piece& p : pieces) {
    parts.push_back(fmt::format("{:.0f} m2 from '{}' ({:.3g} m apart{})", p.ground_m2, p.name,
                                p.data.spacing_m, p.date.empty() ? "" : ", of " + p.date));
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

/// A CRS that was typed is that of the files that do not say theirs.
ImportedSeafloor read_piece(const fs::path& file, const ImportOptions& options) {
  if (options.crs.empty()) return import_seafloor(file, options);
  ImportOptions own = options;
  own.crs.clear();
  try {
    ImportedSeafloor data = import_seafloor(file, own);
    if (!data.seafloor.frame.crs_wkt.empty()) return data;
  } catch (const InvalidInput&) {
    // Degrees, perhaps, of which nothing says so: the CRS may tell.
  }
  return import_seafloor(file, options);
}

void merge_words(const Piece& piece, ImportedSeafloor& all) {
  for (const std::string& note : piece.data.notes) {
    all.notes.push_back(fmt::format("'{}': {}", piece.name, note));
  }
  for (const std::string& warning : piece.data.warnings) {
    all.warnings.push_back(fmt::format("'{}': {}", piece.name, warning));
  }
}

}  // namespace

ImportedSeafloor import_mosaic(const std::vector<fs::path>& files, MosaicPriority priority,
                               const ImportOptions& options) {
  std::vector<Piece> pieces;
  for (const fs::path& file : files) {
    pieces.push_back({read_piece(file, options), file.filename().string(), "", 0.0});
  }
  ImportedSeafloor all = pieces.front().data;
  if (pieces.size() == 1) return all;
  const Frame frame = all.seafloor.frame;
  all.notes.clear();
  all.warnings.clear();
  std::vector<std::string> hashes;
  all.nodes = 0;
  for (Piece& piece : pieces) {
    if (&piece != &pieces.front()) bring_to(frame, piece, pieces.front().name);
    hashes.push_back(piece.data.input_hash);
    merge_words(piece, all);
    if (&piece != &pieces.front()) all.land = unite(all.land, piece.data.land);
    all.nodes += piece.data.nodes;
    all.spacing_m = std::min(all.spacing_m, piece.data.spacing_m);
    if (piece.data.kind == "chart") all.kind = "chart";
  }
  all.input_hash = fmt::format("{}", fmt::join(hashes, "+"));
  sort_pieces(pieces, priority);
  Seafloor joined = std::move(pieces.front().data.seafloor);
  pieces.front().ground_m2 = plan_area_m2(joined);
  double coarsest = pieces.front().data.spacing_m;
  std::vector<std::string> seams;
  for (std::size_t i = 1; i < pieces.size(); ++i) {
    coarsest = std::max(coarsest, pieces[i].data.spacing_m);
    Zipped zip = zipped(joined, pieces[i].data.seafloor, kBridge * coarsest);
    pieces[i].ground_m2 = zip.lower_m2;
    seams.push_back(fmt::format("'{}' below the others: {}", pieces[i].name,
                                step_text(std::move(zip.steps_m))));
    joined = std::move(zip.seafloor);
  }
  all.seafloor = std::move(joined);
  if (!all.land.empty()) all.land = subtract(all.land, outline(all.seafloor));
  all.notes.push_back("mosaic, the first counting most: " + parts_text(pieces));
  all.notes.insert(all.notes.end(), seams.begin(), seams.end());
  all.health = assess(all.seafloor);
  return all;
}

}  // namespace swathplan
