#include "io/seafloor/soundings_import.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numeric>
#include <string>
#include <tuple>

#include "io/files/crs.h"
#include "io/files/text.h"
#include "io/seafloor/lattice_internal.h"
#include "io/seafloor/sounding_columns.h"
#include "mesh/base/error.h"

namespace swathplan {
namespace {

namespace fs = std::filesystem;

bool is_comment(std::string_view line) {
  return line.starts_with('#') || line.starts_with("//") || line.starts_with('%') ||
         line.starts_with('!');
}

/// Reads rows one after the other; the first lines decide how.
class RowReader {
 public:
  RowReader(const fs::path& path, std::optional<double> nodata) : path_(path), nodata_(nodata) {}

  void read(SurfaceData& data) {
    std::ifstream in(path_, std::ios::binary);
    std::string text;
    for (line_ = 1; std::getline(in, text); ++line_) {
      std::string_view row = trim(text);
      if (line_ == 1 && row.starts_with("\xEF\xBB\xBF")) row.remove_prefix(3);
      if (row.empty()) continue;
      if (is_comment(row)) {
        comment_ = trim(row.substr(row.find_first_not_of("#/%!") == std::string_view::npos
                                       ? row.size()
                                       : row.find_first_not_of("#/%!")));
      } else if (!style_ && header_.empty() && !style_of(row)) {
        header_ = row;
      } else {
        add(row, data);
      }
    }
    if (columns_.z_is_depth) data.z_is_depth = true;
    if (columns_.lon_lat) data.crs_wkt = wgs84_crs();
  }

 private:
  /// The first row of numbers tells the style; the header or the last comment names the columns.
  void begin(std::string_view row, SurfaceData& data) {
    for (const char separator : {';', '\t', ',', ' '}) {
      for (const std::string& names : {header_, comment_}) {
        const std::optional<SoundingColumns> found = named_columns(names, separator);
        if (!found || style_) continue;
        columns_ = *found;
        style_ = RowStyle{separator, separator == ';' && row.find(',') != std::string_view::npos};
      }
    }
    if (style_) return;
    style_ = style_of(row);
    if (!style_) refuse(row);
    if (!header_.empty()) {
      data.notes.push_back(
          fmt::format("the column names '{}' are not known: columns 1, 2, 3 are taken as x, y, z",
                      quotable(header_)));
    }
  }

  void add(std::string_view row, SurfaceData& data) {
    if (!style_) begin(row, data);
    const std::vector<std::string_view> fields = split(row, style_->separator);
    if (fields.size() <= std::max({columns_.x, columns_.y, columns_.z})) refuse(row);
    const Vec3 p(number(fields[columns_.x], row), number(fields[columns_.y], row),
                 number(fields[columns_.z], row));
    if (nodata_ && p.z() == *nodata_) return;
    if (!p.allFinite()) {
      throw InvalidInput(
          fmt::format("'{}', line {}: '{}' holds a number that is not finite; remove "
                      "the line",
                      path_.string(), line_, quotable(row)));
    }
    data.vertices.push_back(p);
  }

  double number(std::string_view field, std::string_view row) const {
    std::string text(field);
    if (style_->decimal_comma) std::replace(text.begin(), text.end(), ',', '.');
    const std::optional<double> value = to_number(text);
    if (!value) refuse(row);
    return *value;
  }

  [[noreturn]] void refuse(std::string_view row) const {
    throw InvalidInput(fmt::format(
        "'{}', line {}: '{}' is no row of x, y, z; soundings need three numbers a line, separated "
        "by space, tab, comma or semicolon",
        path_.string(), line_, quotable(row)));
  }

  const fs::path& path_;
  std::optional<double> nodata_;
  std::size_t line_ = 0;
  std::string header_, comment_;
  SoundingColumns columns_;
  std::optional<RowStyle> style_;
};

/// Points at the same place to the last bit become one, the shoalest; the order stays.
void merge_places(SurfaceData& data, bool z_down) {
  std::vector<std::uint32_t> order(data.vertices.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto key = [&](std::uint32_t i) {
    const Vec3& v = data.vertices[i];
    return std::tuple(v.x(), v.y(), z_down ? v.z() : -v.z(), i);
  };
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return key(a) < key(b); });
  std::vector<bool> keep(data.vertices.size(), false);
  for (std::size_t i = 0; i < order.size(); ++i) {
    keep[order[i]] =
        i == 0 || data.vertices[order[i]].head<2>() != data.vertices[order[i - 1]].head<2>();
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < data.vertices.size(); ++i) {
    if (keep[i]) data.vertices[kept++] = data.vertices[i];
  }
  if (kept < data.vertices.size()) {
    data.notes.push_back(
        fmt::format("{} soundings lie at the same place as another: the shoalest was kept",
                    data.vertices.size() - kept));
  }
  data.vertices.resize(kept);
}

}  // namespace

SurfaceData read_soundings(const fs::path& path, bool z_positive_down,
                           std::optional<double> nodata) {
  SurfaceData data;
  data.format = lower(path.extension().string()) == ".csv" ? "CSV" : "XYZ";
  RowReader(path, nodata).read(data);
  if (data.z_is_depth && std::all_of(data.vertices.begin(), data.vertices.end(),
                                     [](const Vec3& v) { return v.z() <= 0.0; })) {
    data.z_is_depth = false;
    data.notes.emplace_back("the depth column holds no positive value: taken as heights, z up");
  }
  merge_places(data, z_positive_down || data.z_is_depth);
  if (data.vertices.size() < 3) {
    throw InvalidInput(
        fmt::format("'{}' holds {} soundings at different places; a surface needs "
                    "at least three",
                    path.string(), data.vertices.size()));
  }
  join_lattice(data);
  return data;
}

}  // namespace swathplan
