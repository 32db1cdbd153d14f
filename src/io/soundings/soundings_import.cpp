#include "io/soundings/soundings_import.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <tuple>
#include <utility>

#include "io/files/crs.h"
#include "io/files/text.h"
#include "io/files/units.h"
#include "io/grids/no_data_values.h"
#include "io/grids/shoalest_places.h"
#include "io/soundings/geographic_points.h"
#include "io/soundings/lattice.h"
#include "io/soundings/sounding_columns.h"
#include "io/soundings/text_lines.h"
#include "io/soundings/unnamed_columns.h"
#include "mesh/base/error.h"

namespace swathplan {
namespace {

namespace fs = std::filesystem;

/// More lines without numbers than these (or this share of the soundings) are no strays.
constexpr std::size_t kMostStrays = 5;
constexpr double kStrayShare = 0.01;
constexpr std::size_t kMostKeptLines = 50;
constexpr const char* kExample = "<columns>, as in x=3,y=2,z=5 (numbers from 1, or names)";

bool is_comment(std::string_view line) {
  return line.starts_with('#') || line.starts_with("//") || line.starts_with('%') ||
         line.starts_with('!');
}

std::size_t filled(const std::vector<std::string_view>& fields) {
  std::size_t n = fields.size();
  while (n > 0 && fields[n - 1].empty()) --n;
  return n;
}

bool any_number(const std::vector<std::string_view>& fields, const RowStyle& style) {
  return std::any_of(fields.begin(), fields.end(),
                     [&](std::string_view f) { return number_of(f, style).has_value(); });
}

std::string unit_name(double unit_m) {
  if (unit_m == 1.0) return "metres";
  if (unit_m == 0.3048) return "feet";
  if (unit_m == metres_in("us survey foot")) return "US survey feet";
  if (unit_m == 1.8288) return "fathoms";
  return fmt::format("units of {:.7g} m", unit_m);
}

/// Reads rows one after the other; the first lines decide how.
/// True for a column that says which soundings were rejected when they were edited.
bool marks_soundings(std::string_view name) {
  const std::string word = lower(trim(name));
  return word == "rejected" || word == "deleted" || word == "accepted" || word == "flag" ||
         word == "flags" || word == "status" || word == "edit_flag" || word == "outlier";
}

class RowReader {
 public:
  RowReader(const fs::path& path, const SoundingsOptions& options)
      : path_(path), options_(options), choice_(parse_columns(options.columns)) {}

  void read(SurfaceData& data) {
    TextLines lines(path_);
    std::string_view row;
    while (lines.next(row)) {
      line_ = lines.number();
      if (row.empty()) continue;
      if (is_comment(row)) {
        if (style_) {
          const std::size_t first = row.find_first_not_of("#/%!");
          check_same_columns(trim(row.substr(std::min(first, row.size()))));
        } else {
          keep_comment(row);
        }
      } else if (row.starts_with('>')) {
        note_stray(row);  // the head of a segment
      } else if (!style_ && !is_first_row(row)) {
        if (before_.size() == kMostKeptLines) before_.erase(before_.begin());
        before_.emplace_back(line_, row);
        ++lines_before_;
      } else {
        add(row, data);
      }
    }
    if (!style_) refuse_all();
    finish(data);
  }

  /// 'line 7, ...' of the first stray line; empty if there is none.
  [[nodiscard]] const std::string& first_stray() const { return first_stray_; }

 private:
  struct Line {
    std::size_t number;
    std::string text;
    Line(std::size_t n, std::string_view t) : number(n), text(t) {}
  };

  void keep_comment(std::string_view row) {
    const std::size_t first = row.find_first_not_of("#/%!");
    if (first == std::string_view::npos) return;
    if (comments_.size() == kMostKeptLines) comments_.erase(comments_.begin());
    comments_.emplace_back(trim(row.substr(first)));
  }

  static bool is_first_row(std::string_view row) { return style_of(row).has_value(); }

  /// The first row of numbers tells the style. A choice, the header or a comment names the columns.
  void begin(std::string_view row, SurfaceData& data) {
    style_ = style_of(row);
    const std::vector<std::string_view> fields = split_row(row, style_->separator);
    width_ = filled(fields);
    if (choice_.given()) {
      take_choice(fields);
    } else if (!take_header(row)) {
      refuse_unknown_header();
      judge_unnamed(row, false);
    }
    take_units_row();
    note_strays_before();
    for (std::size_t i = 0; i < std::max({columns_.x, columns_.y, columns_.z}); ++i) {
      if (i < fields.size() && !number_of(fields[i], *style_)) text_before_ = true;
    }
    say_columns(data);
    warn_of_units(data);
    data.z_unit_m = options_.z_unit_is_given ? std::nullopt : columns_.z_unit_m;
    data.xy_unit_m = columns_.xy_unit_m;
  }

  /// Names that stand over the columns one by one, or over the first three of them.
  bool take_names(const std::string& names, std::string_view row, bool is_comment_line) {
    for (const char separator : {style_->separator, ';', '\t', ',', ' '}) {
      const std::optional<SoundingColumns> found = named_columns(names, separator);
      if (!found) continue;
      const std::vector<std::string_view> header = split_header(names, separator);
      const std::size_t n = filled(header);
      const bool first_three =
          found->x + found->y + found->z == 3 && std::max({found->x, found->y, found->z}) == 2;
      if (n != width_) {
        if (is_comment_line && (n != 3 || !first_three)) continue;
        const bool longer = n > width_ && style_->separator != ' ';
        if (!first_three && !longer) refuse_width(n, row);
      }
      columns_ = *found;
      header_.assign(header.begin(), header.end());
      if (n < width_) judge_unnamed(row, true);
      return true;
    }
    return false;
  }

  bool take_header(std::string_view row) {
    for (std::size_t i = before_.size(); i-- > 0;) {
      header_line_ = before_[i].text;
      if (!take_names(header_line_, row, false)) continue;
      header_at_ = i;
      return true;
    }
    for (std::size_t i = comments_.size(); i-- > 0;) {
      header_line_ = comments_[i];
      if (take_names(header_line_, row, true)) return true;
    }
    return false;
  }

  /// A line of words, one for each column, is a header.
  [[nodiscard]] bool is_header(const std::string& line) const {
    const std::vector<std::string_view> names = split_header(line, style_->separator);
    return filled(names) == width_ && !any_number(names, *style_);
  }

  void refuse_unknown_header() const {
    for (std::size_t i = before_.size(); i-- > 0;) {
      for (const char separator : {style_->separator, ',', ';', '\t'}) {
        const std::vector<std::string_view> names = split_header(before_[i].text, separator);
        const bool words =
            separator == style_->separator ? is_header(before_[i].text) : filled(names) == width_;
        if (!words || any_number(names, *style_)) continue;
        std::vector<std::string> quoted;
        for (const std::string_view name : names) quoted.push_back(quotable(name, 30));
        throw InvalidInput(
            fmt::format("'{}', line {}: it is not clear which of the columns '{}' are x, y and z; "
                        "say which are meant with {}",
                        path_.string(), before_[i].number, fmt::join(quoted, "', '"), kExample));
      }
    }
  }

  [[noreturn]] void refuse_width(std::size_t names, std::string_view row) const {
    throw InvalidInput(fmt::format(
        "'{}', line {}: '{}' has {} columns, but the header '{}' names {}; say which columns are "
        "meant with {}",
        path_.string(), line_, quotable(row), width_, quotable(header_line_), names, kExample));
  }

  /// Rows without names are x, y, z and perhaps more, if nothing speaks against it.
  void judge_unnamed(std::string_view row, bool named) {
    if (width_ <= 3 && !named) {
      const std::vector<std::string_view> fields = split_row(row, style_->separator);
      const bool three = fields.size() >= 3 &&
                         std::all_of(fields.begin(), fields.begin() + 3,
                                     [&](std::string_view f) { return number_of(f, *style_); });
      if (three) return;
    }
    const UnnamedColumns columns = unnamed();
    if (!named && columns.is_matrix()) {
      throw InvalidInput(
          fmt::format("'{}' looks like a bare matrix of depths, without places; give it a head of "
                      "places and cell size (as Esri ASCII or GeoTIFF), or rows of x, y, z",
                      path_.string()));
    }
    if (!named && columns.angle_parts() > 0) {
      take_angles(columns.angle_parts(), {.x = 1, .y = 0, .z = 2});
      return;
    }
    if (columns.angle_parts() > 0) {
      throw InvalidInput(fmt::format(
          "'{}', line {}: '{}' looks like degrees, minutes and seconds in columns of their own, "
          "but "
          "the header names fewer columns; leave the header out, or turn each angle into one "
          "decimal number with its sign (33 51 36 S is -33.86)",
          path_.string(), line_, quotable(row)));
    }
    if (const std::size_t date = named ? 0 : columns.date_columns(); date > 0) {
      columns_ = {.x = date, .y = date + 1, .z = date + 2};
      date_columns_ = date;
      return;
    }
    const std::string doubt = columns.doubt();
    if (doubt.empty()) return;
    throw InvalidInput(
        fmt::format("'{}', line {}: '{}' has {} columns {}, and {}; say which are meant with {}",
                    path_.string(), line_, quotable(row), width_,
                    named ? "but fewer names" : "without names", doubt, kExample));
  }

  /// What all rows say of columns without names.
  [[nodiscard]] UnnamedColumns unnamed() const {
    UnnamedColumns columns;
    TextLines lines(path_);
    std::string_view line;
    while (lines.next(line)) {
      if (lines.number() < line_ || line.empty() || is_comment(line)) continue;
      if (line.starts_with('>')) continue;
      const std::vector<std::string_view> fields = split_row(line, style_->separator);
      // Strays say nothing about the columns.
      const auto numbers = std::count_if(fields.begin(), fields.end(), [&](std::string_view f) {
        return number_of(f, *style_).has_value();
      });
      if (numbers >= 3 || lines.number() == line_) columns.add(fields, *style_);
    }
    return columns;
  }

  /// Two angles of so many columns each begin the rows. Each counts as one column from now on.
  void take_angles(std::size_t parts, const SoundingColumns& columns) {
    angle_parts_ = parts;
    columns_ = columns;
    columns_.lon_lat = true;
  }

  /// Columns that were chosen by the first column of each angle.
  void take_chosen_angles() {
    const std::size_t parts = unnamed().angle_parts();
    const auto& c = columns_;
    const bool first_of_each = std::min(c.x, c.y) == 0 && std::max(c.x, c.y) == parts;
    if (parts == 0 || !first_of_each || c.z < 2 * parts) return;
    SoundingColumns chosen = c;
    chosen.x = c.x == 0 ? 0 : 1;
    chosen.y = 1 - chosen.x;
    chosen.z = c.z - 2 * parts + 2;
    take_angles(parts, chosen);
  }

  /// The fields of a row, an angle's columns as one field; none if there are too few.
  [[nodiscard]] std::vector<std::string_view> fields_of(std::string_view row) {
    std::vector<std::string_view> fields = split_row(row, style_->separator);
    if (angle_parts_ == 0) return fields;
    if (fields.size() <= 2 * angle_parts_) return {};
    for (std::size_t k = 0; k < angles_.size(); ++k) {
      angles_.at(k).clear();
      for (std::size_t i = 0; i < angle_parts_; ++i) {
        angles_.at(k).append(fields[k * angle_parts_ + i]).append(" ");
      }
      if (style_->decimal_comma) std::replace(angles_.at(k).begin(), angles_.at(k).end(), ',', '.');
    }
    fields.erase(fields.begin(), fields.begin() + static_cast<std::ptrdiff_t>(2 * angle_parts_));
    fields.insert(fields.begin(), angles_.begin(), angles_.end());
    return fields;
  }

  void take_choice(const std::vector<std::string_view>& row) {
    for (std::size_t i = before_.size(); i-- > 0 && header_.empty();) {
      for (const char separator : {style_->separator, ',', ';', '\t'}) {
        const auto names = split_header(before_[i].text, separator);
        if (filled(names) != width_ && !named_in(names)) continue;
        header_line_ = before_[i].text;
        const auto own = split_header(header_line_, separator);
        header_.assign(own.begin(), own.end());
        header_at_ = i;
        break;
      }
    }
    for (std::size_t i = comments_.size(); i-- > 0 && header_.empty();) {
      if (!named_in(split_header(comments_[i], style_->separator))) continue;
      header_line_ = comments_[i];
      const auto own = split_header(header_line_, style_->separator);
      header_.assign(own.begin(), own.end());
    }
    columns_ = {};
    columns_.x = chosen(choice_.x, row);
    columns_.y = chosen(choice_.y, row);
    columns_.z = chosen(choice_.z, row);
    if (columns_.x == columns_.y || columns_.x == columns_.z || columns_.y == columns_.z) {
      throw UsageError("columns", options_.columns, "must name three different columns");
    }
    const ColumnName x = name_at(columns_.x);
    const ColumnName y = name_at(columns_.y);
    const ColumnName z = name_at(columns_.z);
    const std::optional<FieldAngle> angle = angle_of(row[columns_.x]);
    columns_.lon_lat = choice_.lon_lat || (x.in_degrees && y.in_degrees) || angle.has_value();
    columns_.z_is_depth = choice_.z_is_depth || z.is_depth;
    columns_.z_unit_m = z.unit_m;
    if (!columns_.lon_lat && x.unit_m == y.unit_m) columns_.xy_unit_m = x.unit_m;
    constexpr std::size_t kFewestOfAngles = 5;
    if (header_.empty() && width_ >= kFewestOfAngles) take_chosen_angles();
  }

  [[nodiscard]] bool named_in(const std::vector<std::string_view>& names) const {
    if (to_number(choice_.x) || to_number(choice_.y) || to_number(choice_.z)) return false;
    return find_column(choice_.x, names) && find_column(choice_.y, names) &&
           find_column(choice_.z, names);
  }

  [[nodiscard]] ColumnName name_at(std::size_t column) const {
    return column < header_.size() ? column_name(header_[column]) : ColumnName{};
  }

  [[nodiscard]] std::size_t chosen(const std::string& wanted,
                                   const std::vector<std::string_view>& row) const {
    const std::optional<std::size_t> at = find_column(wanted, {header_.begin(), header_.end()});
    if (!at) {
      throw InvalidInput(fmt::format(
          "'{}' has no column '{}'; {}", path_.string(), quotable(wanted),
          header_.empty() ? std::string("it names no columns: give <columns> by number, from 1 on")
                          : fmt::format("its columns are '{}'", fmt::join(header_, "', '"))));
    }
    if (*at >= row.size()) {
      throw InvalidInput(fmt::format("'{}', line {}: '{}' has {} columns, so there is no column {}",
                                     path_.string(), line_, quotable(row.front()), row.size(),
                                     *at + 1));
    }
    return *at;
  }

  /// A line of units under the header: 'm,m,ft'.
  void take_units_row() {
    if (!header_at_) return;
    for (std::size_t i = *header_at_ + 1; i < before_.size(); ++i) {
      const auto units = split_header(before_[i].text, style_->separator);
      if (units.size() <= std::max({columns_.x, columns_.y, columns_.z})) continue;
      // A word that is a unit alone counts, as the unit of a name would.
      const auto unit = [&](std::size_t at) {
        std::string text(units[at]);
        std::erase_if(text, [](char c) { return std::string_view("()[]{}").find(c) < 6; });
        return column_name("unit (" + text + ")");
      };
      const ColumnName x = unit(columns_.x);
      const ColumnName y = unit(columns_.y);
      const ColumnName z = unit(columns_.z);
      if (!z.unit_m && !x.unit_m && !x.in_degrees) continue;
      units_at_ = i;
      if (z.unit_m) columns_.z_unit_m = z.unit_m;
      if (x.in_degrees && y.in_degrees) columns_.lon_lat = true;
      if (!columns_.lon_lat && x.unit_m && x.unit_m == y.unit_m) columns_.xy_unit_m = x.unit_m;
      return;
    }
  }

  void note_strays_before() {
    for (std::size_t i = 0; i < before_.size(); ++i) {
      if (i == header_at_ || i == units_at_) {
        --lines_before_;
      } else if (first_stray_.empty()) {
        first_stray_ = fmt::format("line {}, '{}'", before_[i].number, quotable(before_[i].text));
      }
    }
    strays_ += lines_before_;
  }

  [[nodiscard]] std::string title(std::size_t column) const {
    return column < header_.size()
               ? fmt::format("'{}' (column {})", quotable(header_[column], 30), column + 1)
               : fmt::format("column {}", column + 1);
  }

  void say_columns(SurfaceData& data) const {
    if (header_.empty() && width_ <= 3 && !choice_.given()) return;
    if (angle_parts_ > 0) return say_angles(data);
    if (date_columns_ > 0) {
      data.notes.push_back(fmt::format("columns 1 to {} hold {}", date_columns_,
                                       date_columns_ > 3 ? "a date and a time" : "a date"));
    }
    std::string text = fmt::format("x is {}, y is {}, z is {}", title(columns_.x),
                                   title(columns_.y), title(columns_.z));
    if (columns_.lon_lat) text += "; x and y are longitude and latitude";
    if (columns_.xy_unit_m && *columns_.xy_unit_m != 1.0) {
      text += fmt::format("; x and y are in {}", unit_name(*columns_.xy_unit_m));
    }
    if (columns_.z_is_depth) text += "; z is a depth";
    if (columns_.z_unit_m && options_.z_unit_is_given) {
      text += "; z has the given unit, not that of its name";
    } else if (columns_.z_unit_m && *columns_.z_unit_m != 1.0) {
      text +=
          fmt::format("; z is in {} and was converted to metres", unit_name(*columns_.z_unit_m));
    }
    for (const auto& name : header_) {
      if (!marks_soundings(name)) continue;
      data.warnings.push_back(fmt::format(
          "the column '{}' is not looked at: soundings that it rejects are part of the seafloor; "
          "leave them out of the file",
          quotable(name, 30)));
    }
    std::vector<std::string> aside;
    for (const std::string& name : columns_.passed_over) aside.push_back(quotable(name, 30));
    if (!aside.empty()) text += fmt::format("; '{}' not used", fmt::join(aside, "', '"));
    if (!choice_.given()) text += "; choose others with <columns>";
    data.notes.push_back(text);
  }

  void say_angles(SurfaceData& data) const {
    const auto columns = [&](std::size_t angle) {
      return fmt::format("{} to {}", angle * angle_parts_ + 1, (angle + 1) * angle_parts_);
    };
    const std::string text = fmt::format(
        "columns {} are the latitude and {} the longitude, in degrees{} and north and east where "
        "they have no sign; z is column {}",
        columns(columns_.y), columns(columns_.x),
        angle_parts_ == 3 ? ", minutes and seconds," : " and minutes,",
        columns_.z + 2 * angle_parts_ - 1);
    if (choice_.given()) {
      data.notes.push_back(text);
    } else {
      data.warnings.push_back(fmt::format(
          "{}: the file does not say so; if it is otherwise, name the first column of each with "
          "<columns>, as in lon=1,lat={},z={}",
          text, angle_parts_ + 1, 2 * angle_parts_ + 1));
    }
  }

  /// Logs that begin with a date give the latitude first. Degrees are told from metres as
  /// everywhere: places far from zero that lie closer together than they are deep.
  void place_log(SurfaceData& data) const {
    if (date_columns_ == 0 || data.vertices.empty() || columns_.lon_lat) return;
    Vec3 low = data.vertices.front();
    Vec3 high = low;
    for (const Vec3& v : data.vertices) {
      low = low.cwiseMin(v);
      high = high.cwiseMax(v);
    }
    const double size = (high - low).head<2>().norm();
    const double deepest = std::max(std::abs(low.z()), std::abs(high.z()));
    const Vec2 middle = 0.5 * (low + high).head<2>();
    const bool degrees = middle.cwiseAbs().maxCoeff() <= 180.0 &&
                         middle.cwiseAbs().minCoeff() <= 90.0 && deepest > 2.0 * size &&
                         middle.cwiseAbs().minCoeff() > 2.0 * size;
    if (!degrees) return;
    for (Vec3& v : data.vertices) std::swap(v.x(), v.y());
    data.crs_wkt = wgs84_crs();
    data.warnings.push_back(fmt::format(
        "columns {} and {} look like degrees behind a date: taken as latitude and longitude, as "
        "logs have them; if it is otherwise, give <columns> lon={},lat={},z={}",
        date_columns_ + 1, date_columns_ + 2, date_columns_ + 1, date_columns_ + 2,
        date_columns_ + 3));
  }

  void add(std::string_view row, SurfaceData& data) {
    if (!style_) begin(row, data);
    const std::vector<std::string_view> fields = fields_of(row);
    const std::size_t needed = std::max({columns_.x, columns_.y, columns_.z});
    const bool shifted = text_before_ && filled(fields) > std::max(width_, needed + 1);
    if (fields.size() <= needed || shifted) return add_stray(row, fields);
    const std::optional<double> x = place(fields[columns_.x], 'E', 'W');
    const std::optional<double> y = place(fields[columns_.y], 'N', 'S');
    const std::optional<double> z = number_of(fields[columns_.z], *style_);
    const bool no_depth = fields[columns_.z].empty() || (z && std::isnan(*z));
    if (x && y && std::isfinite(*x) && std::isfinite(*y) && no_depth) {
      ++without_depth_;
      return;
    }
    if (!x || !y || !z) return add_stray(row, fields);
    const Vec3 p(*x, *y, *z);
    if (options_.nodata && p.z() == *options_.nodata) return;
    if (!p.allFinite()) {
      throw InvalidInput(
          fmt::format("'{}', line {}: '{}' holds a number that is not finite; remove the line",
                      path_.string(), line_, quotable(row)));
    }
    if (p.head<2>().cwiseAbs().maxCoeff() > kLargestCoordinate) {
      throw InvalidInput(
          fmt::format("'{}', line {}: '{}' holds a coordinate beyond {:g}, which no map has; mend "
                      "or remove the line",
                      path_.string(), line_, quotable(row), kLargestCoordinate));
    }
    data.vertices.push_back(p);
  }

  /// A number, or in columns of degrees an angle of one of two hemispheres.
  [[nodiscard]] std::optional<double> place(std::string_view field, char plus, char minus) const {
    const std::optional<double> number = number_of(field, *style_);
    if (number || !columns_.lon_lat) return number;
    const std::optional<FieldAngle> angle = angle_of(field);
    if (!angle) return {};
    const char h = angle->hemisphere;
    if (h != ' ' && h != plus && h != minus) return {};
    return angle->degrees;
  }

  [[nodiscard]] bool is_own_header(std::string_view text) const {
    return !header_.empty() && text == header_line_;
  }

  /// Comments and titles may name a unit that no column does.
  void warn_of_units(SurfaceData& data) const {
    if (options_.z_unit_is_given || columns_.z_unit_m) return;
    std::vector<std::string> texts = comments_;
    for (const Line& line : before_) texts.push_back(line.text);
    for (const std::string& text : texts) {
      const std::string unit = foreign_unit_in(text);
      if (unit.empty() || is_own_header(text)) continue;
      data.warnings.push_back(fmt::format(
          "'{}' speaks of {}, but z is taken as metres; if the depths are not, set <z unit>",
          quotable(text), unit));
      return;
    }
  }

  /// Files that were put one behind the other may have columns of different orders and units.
  void check_same_columns(std::string_view row) const {
    if (row.empty() || is_own_header(row)) return;
    for (const char separator : {style_->separator, ',', ';', '\t', ' '}) {
      // A sentence may hold the words 'east', 'north' and 'depth' too.
      if (filled(split_header(row, separator)) != width_) continue;
      const std::optional<SoundingColumns> named = named_columns(row, separator);
      if (!named) continue;
      const auto places = [](const SoundingColumns& c) {
        return std::tuple(c.x, c.y, c.z, c.z_is_depth, c.lon_lat, c.z_unit_m.value_or(1.0),
                          c.xy_unit_m.value_or(1.0));
      };
      if (!choice_.given() && places(*named) == places(columns_)) return;
      throw InvalidInput(fmt::format(
          "'{}', line {}: '{}' names the columns from here on, not as those before: these are two "
          "files in one; split it there, or give both the same columns",
          path_.string(), line_, quotable(row)));
    }
  }

  void note_stray(std::string_view row) {
    ++strays_;
    if (first_stray_.empty()) first_stray_ = fmt::format("line {}, '{}'", line_, quotable(row));
  }

  /// A line of words is skipped. A line with numbers that make no sounding is refused: it may be
  /// half a sounding.
  void add_stray(std::string_view row, const std::vector<std::string_view>& fields) {
    const bool begins_as_number =
        !row.empty() &&
        std::string_view("0123456789+-.,;").find(row.front()) != std::string_view::npos;
    const auto numbers = std::count_if(fields.begin(), fields.end(), [&](std::string_view f) {
      return number_of(f, *style_).has_value();
    });
    if (begins_as_number || numbers >= 2) refuse(row);
    check_same_columns(row);
    if (++words_ == 1) first_words_ = line_;
    note_stray(row);
  }

  [[noreturn]] void refuse(std::string_view row) const {
    throw InvalidInput(
        fmt::format("'{}', line {}: '{}' is no row of x, y, z; soundings need three numbers a "
                    "line, separated by space, tab, comma or semicolon",
                    path_.string(), line_, quotable(row)));
  }

  [[noreturn]] void refuse_all() const {
    const std::string first = before_.empty()
                                  ? "all of it are comments"
                                  : fmt::format("line {} is '{}'", before_.front().number,
                                                quotable(before_.front().text));
    throw InvalidInput(
        fmt::format("'{}' holds no row of x, y, z ({}); soundings need three numbers a line, "
                    "separated by space, tab, comma or semicolon",
                    path_.string(), first));
  }

  void finish(SurfaceData& data) const {
    const double limit = std::max(static_cast<double>(kMostStrays),
                                  kStrayShare * static_cast<double>(data.vertices.size()));
    if (static_cast<double>(words_) > limit) {
      throw InvalidInput(
          fmt::format("'{}', line {}: {} lines among the soundings hold no three numbers, the "
                      "first of them this one; is it a file of soundings?",
                      path_.string(), first_words_, words_));
    }
    if (strays_ > 0) {
      data.notes.push_back(fmt::format("{} that {} no sounding {} skipped: the first is {}",
                                       strays_ == 1 ? "1 line" : fmt::format("{} lines", strays_),
                                       strays_ == 1 ? "holds" : "hold",
                                       strays_ == 1 ? "was" : "were", first_stray_));
    }
    if (without_depth_ > 0) {
      data.notes.push_back(
          fmt::format("{} without a depth (empty or NaN) {} skipped",
                      without_depth_ == 1 ? "1 row" : fmt::format("{} rows", without_depth_),
                      without_depth_ == 1 ? "was" : "were"));
    }
    if (columns_.z_is_depth) data.z_is_depth = true;
    if (columns_.lon_lat) data.crs_wkt = wgs84_crs();
    place_log(data);
  }

  const fs::path& path_;
  const SoundingsOptions& options_;
  ColumnChoice choice_;
  std::size_t line_ = 0;
  std::vector<Line> before_;           ///< lines before the first row of numbers
  std::vector<std::string> comments_;  ///< before the first row of numbers
  std::size_t lines_before_ = 0;
  std::string header_line_;
  std::vector<std::string> header_;  ///< names of the columns; empty: none
  std::optional<std::size_t> header_at_, units_at_;
  SoundingColumns columns_;
  std::optional<RowStyle> style_;
  std::size_t width_ = 0;              ///< columns of the first row
  std::size_t date_columns_ = 0;       ///< before x, y and z, in rows without names
  std::size_t angle_parts_ = 0;        ///< columns of each of two angles; 0: angles are one column
  std::array<std::string, 2> angles_;  ///< of the row that is being read
  bool text_before_ = false;  ///< words stand before z: a further field would shift the columns
  std::size_t strays_ = 0, words_ = 0, first_words_ = 0, without_depth_ = 0;
  std::string first_stray_;
};

/// Leaves out soundings of -9999 and the like that lie far outside all others, and says so.
void drop_fill_values(SurfaceData& data) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  std::map<double, std::size_t> suspects;
  for (const Vec3& v : data.vertices) {
    if (no_data_sign(v.z()) != NoDataSign::none) {
      ++suspects[v.z()];
    } else {
      low = std::min(low, v.z());
      high = std::max(high, v.z());
    }
  }
  if (low > high) return;
  const std::size_t all = data.vertices.size();
  for (const auto& [value, count] : suspects) {
    const SuspectValue suspect{value, count, all, low, high};
    if (is_worth_a_word(suspect)) {
      data.warnings.push_back(no_data_warning(suspect, "soundings"));
    }
    if (is_no_data(suspect)) {
      std::erase_if(data.vertices, [v = value](const Vec3& p) { return p.z() == v; });
    }
  }
}

}  // namespace

SurfaceData read_soundings(const fs::path& path, const SoundingsOptions& options) {
  SurfaceData data;
  data.format = lower(path.extension().string()) == ".csv" ? "CSV" : "XYZ";
  RowReader reader(path, options);
  reader.read(data);
  drop_fill_values(data);
  if (data.z_is_depth && std::all_of(data.vertices.begin(), data.vertices.end(),
                                     [](const Vec3& v) { return v.z() <= 0.0; })) {
    data.z_is_depth = false;
    data.notes.emplace_back("the depth column holds no positive value: taken as heights, z up");
  }
  if (!data.crs_wkt.empty()) mend_geographic_points(data);
  keep_shoalest_places(data, options.z_positive_down || data.z_is_depth);
  if (data.vertices.size() < 3) {
    throw InvalidInput(
        fmt::format("'{}' holds {} soundings at different places; a surface needs at least three{}",
                    path.string(), data.vertices.size(),
                    reader.first_stray().empty() ? "" : "; skipped: " + reader.first_stray()));
  }
  join_lattice(data);
  return data;
}

}  // namespace swathplan
