#include <cpl_string.h>
#include <cpl_vsi.h>
#include <fmt/format.h>
#include <ogrsf_frmts.h>

#include <algorithm>

#include "io/files/child_process.h"
#include "io/files/gdal_at_home.h"
#include "io/files/quiet_gdal.h"
#include "io/files/text.h"
#include "io/route/route_planar.h"
#include "mesh/base/error.h"

namespace swathplan {
namespace {

/// Lines of text: the layer, a tab, then x and y of each point. A geometry that is no line gives
/// an empty one.
void add_lines(const OGRGeometry* geometry, const std::string& layer, std::string& out) {
  if (geometry == nullptr || geometry->IsEmpty()) return;
  const OGRwkbGeometryType type = wkbFlatten(geometry->getGeometryType());
  if (type == wkbMultiLineString || type == wkbGeometryCollection) {
    for (const OGRGeometry* part : *geometry->toGeometryCollection()) add_lines(part, layer, out);
  } else if (type == wkbLineString) {
    out += layer + "\t";
    for (const OGRPoint& p : *geometry->toLineString()) {
      out += fmt::format("{} {} ", p.getX(), p.getY());
    }
    out += "\n";
  } else {
    out += "\n";
  }
}

/// Reads a drawing with GDAL. Runs in a child process: its reader is not to be trusted.
std::string drawing_lines(std::string_view text) {
  register_gdal();
  const QuietGdal quiet;
  const std::string name = "/vsimem/route.dxf";
  std::string bytes(text);
  VSIFCloseL(VSIFileFromMemBuffer(name.c_str(), reinterpret_cast<GByte*>(bytes.data()),
                                  bytes.size(), FALSE));
  const char* const drivers[] = {"DXF", nullptr};
  const GDALDatasetUniquePtr drawing(
      GDALDataset::Open(name.c_str(), GDAL_OF_VECTOR, drivers, nullptr, nullptr));
  OGRLayer* layer = drawing ? drawing->GetLayer(0) : nullptr;
  if (layer == nullptr) throw InvalidInput(fmt::format("GDAL cannot read it{}", quiet.why()));
  std::string out;
  for (const auto& feature : *layer) {
    std::string of = feature->GetFieldAsString("Layer");
    std::replace_if(
        of.begin(), of.end(), [](char c) { return c == '\t' || c == '\n'; }, ' ');
    add_lines(feature->GetGeometryRef(), of, out);
  }
  return out;
}

void add_drawn(std::string_view row, ForeignRoute& route) {
  const std::size_t tab = row.find('\t');
  const auto kind = leg_kind(lower(trim(row.substr(0, tab))));
  if (kind && *kind != LegKind::end) route.names_kinds = true;
  const auto numbers = split(row.substr(tab + 1), ' ');
  std::vector<ForeignPoint>& points = route.parts.emplace_back();
  for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) {
    points.push_back({.place = Vec2(to_number(numbers[i]).value_or(0.0),
                                    to_number(numbers[i + 1]).value_or(0.0)),
                      .kind = kind && *kind != LegKind::end ? *kind : LegKind::line,
                      .line = std::nullopt,
                      .speed_mps = std::nullopt});
  }
}

}  // namespace

ForeignRoute parse_route_dxf(std::string_view text, const std::string& file) {
  const ChildResult child = run_in_child([&] { return drawing_lines(text); });
  if (child.end != ChildEnd::done) {
    throw InvalidInput(fmt::format(
        "'{}' cannot be read as a drawing ({}): save it as DXF (ASCII) with plain polylines", file,
        child.end == ChildEnd::failed ? child.text : "its reader failed on it"));
  }
  ForeignRoute route{.in_degrees = false, .parts = {}, .notes = {}};
  std::size_t others = 0;
  for (const std::string_view row : split(child.text, '\n')) {
    if (row.empty()) {
      ++others;
    } else {
      add_drawn(row, route);
    }
  }
  --others;  // after the last line end
  if (route.parts.empty()) {
    throw InvalidInput(fmt::format("'{}' is no route: the drawing holds no line", file));
  }
  if (others > 0) {
    route.notes.push_back(fmt::format("{} drawn things that are no lines were left out", others));
  }
  route.notes.emplace_back(
      "a drawing names no coordinate reference system: that of the seafloor's file was taken");
  return route;
}

}  // namespace swathplan
