#include "io/charts/hazards.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "io/charts/chart_file_internal.h"
#include "io/charts/chart_import.h"
#include "io/charts/hazard_buffers.h"
#include "io/charts/hazard_shapes_internal.h"
#include "io/files/crs.h"
#include "io/files/quiet_gdal.h"
#include "io/files/text.h"
#include "mesh/base/error.h"

namespace swathplan {
namespace {

namespace fs = std::filesystem;

/// Layers of a chart that stand in the water and are not kept off unasked.
constexpr std::array kOtherStructures{"PILPNT", "OFSPLF", "PYLONS", "MORFAC", "FSHFAC",
                                      "MARCUL", "DYKCON", "HULKES", "FLODOC"};

/// Restrictions of S-57 (RESTRN) that keep a boat out: entry prohibited, entry restricted, area to
/// be avoided.
constexpr std::array kNoEntry{7, 8, 14};
/// Kinds of areas (CATREA) that keep a boat out where no restriction is given: safety zones,
/// military areas, minefields.
constexpr std::array kClosedAreas{1, 9, 12, 14};

template <std::size_t N>
bool any_of_list(const std::string& list, const std::array<int, N>& numbers) {
  for (const std::string_view part : split(list, ',')) {
    const std::optional<double> value = to_finite_number(part);
    if (value &&
        std::find(numbers.begin(), numbers.end(), static_cast<int>(*value)) != numbers.end()) {
      return true;
    }
  }
  return false;
}

/// '4,8' also where GDAL writes '(2:4,8)'.
std::string numbers_in(const OGRFeature& feature, const char* field) {
  std::string text = text_in(feature, field);
  const std::size_t colon = text.find(':');
  if (colon != std::string::npos) text.erase(0, colon + 1);
  std::erase_if(text, [](char c) { return c == '(' || c == ')' || c == '"'; });
  return text;
}

/// An area that says nothing of its restrictions is taken as closed.
bool keeps_out(const OGRFeature& area) {
  const std::string restrictions = numbers_in(area, "RESTRN");
  const std::string kinds = numbers_in(area, "CATREA");
  if (!restrictions.empty()) return any_of_list(restrictions, kNoEntry);
  return kinds.empty() || any_of_list(kinds, kClosedAreas);
}

std::string name_of_hazard(const OGRFeature& feature) {
  for (const char* field : {"OBJNAM", "NAME", "name", "title", "label"}) {
    const std::string text = text_in(feature, field);
    if (!text.empty()) return quotable(text);
  }
  return {};
}

/// The areas of a chart that say how good its soundings are (M_QUAL).
class QualityZones {
 public:
  explicit QualityZones(GDALDataset& chart) {
    OGRLayer* layer = layer_named(chart, "M_QUAL");
    if (layer == nullptr) return;
    layer->ResetReading();
    for (const OGRFeatureUniquePtr& feature : *layer) {
      const std::optional<double> zone = number_in(*feature, "CATZOC");
      if (!zone) continue;
      for (auto& rings : shapes_of(feature->GetGeometryRef()).polygons) {
        Box2 box;
        for (const Vec2& p : rings.front()) box.extend(p);
        zones_.push_back({static_cast<int>(*zone), box, std::move(rings)});
      }
    }
  }

  /// The worst zone that one of the places lies in.
  [[nodiscard]] std::optional<int> at(const ChartShapes& shapes) const {
    std::optional<int> worst;
    const auto ask = [&](const Vec2& p) {
      for (const Zone& zone : zones_) {
        if (!holds_point(zone, p)) continue;
        if (!worst || catzoc_m(zone.catzoc) > catzoc_m(*worst)) worst = zone.catzoc;
      }
    };
    for (const auto& rings : shapes.polygons) std::for_each(rings[0].begin(), rings[0].end(), ask);
    for (const auto& line : shapes.lines) std::for_each(line.begin(), line.end(), ask);
    for (const Vec3& p : shapes.points) ask(p.head<2>());
    return worst;
  }

 private:
  struct Zone {
    int catzoc = 0;
    Box2 box;
    std::vector<Ring> rings;
  };
  static bool holds_point(const Zone& zone, const Vec2& p) {
    if ((p.array() < zone.box.min.array()).any() || (p.array() > zone.box.max.array()).any()) {
      return false;
    }
    bool inside = false;
    for (const Ring& ring : zone.rings) {
      for (std::size_t k = 0, before = ring.size() - 1; k < ring.size(); before = k++) {
        const Vec2& a = ring[k];
        const Vec2& b = ring[before];
        if ((a.y() > p.y()) == (b.y() > p.y())) continue;
        if (p.x() < a.x() + (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y())) inside = !inside;
      }
    }
    return inside;
  }
  std::vector<Zone> zones_;
};

std::string crs_of_hazards(OGRLayer& layer) {
  const OGRSpatialReference* crs = layer.GetSpatialRef();
  char* text = nullptr;
  std::string wkt;
  if (crs != nullptr && crs->exportToWkt(&text) == OGRERR_NONE) wkt = parse_crs(text);
  CPLFree(text);
  return wkt;
}

/// One file's hazards.
class HazardReader {
 public:
  HazardReader(const fs::path& path, const std::vector<HazardChoice>& choices, const Frame& frame,
               const Box2& near)
      : path_(path),
        choices_(choices),
        frame_(frame),
        near_(near),
        is_chart_(is_chart(path)),
        file_(open_chart(path, cell_)),
        quality_(*file_),
        zones_(*file_) {}

  Hazards read() {
    for (const HazardChoice& choice : choices_) check_layer(choice);
    for (OGRLayer* layer : file_->GetLayers()) {
      if (const std::optional<HazardChoice> how = how_to_take(layer->GetName())) {
        read_layer(*layer, *how);
      }
    }
    if (is_chart_) note_others();
    if (forbid_other_ > 0) {
      found_.notes.push_back(fmt::format(
          "{} restricted areas (RESARE) forbid other things than entry, as anchoring or "
          "discharging: they are not kept off",
          forbid_other_));
    }
    return std::move(found_);
  }

 private:
  void check_layer(const HazardChoice& choice) const {
    if (choice.layer.empty() || layer_named(*file_, choice.layer) != nullptr) return;
    if (hazard_class(choice.layer) != nullptr && is_chart_) return;  // the cell holds none
    std::vector<std::string> names;
    for (OGRLayer* layer : file_->GetLayers()) names.emplace_back(quotable(layer->GetName()));
    throw InvalidInput(fmt::format("'{}' has no layer '{}' to keep off; it has {}", path_.string(),
                                   quotable(choice.layer), fmt::join(names, ", ")));
  }

  /// The last choice that names the layer; else that of all layers; else, for a chart, its class.
  [[nodiscard]] std::optional<HazardChoice> how_to_take(const std::string& layer) const {
    const auto last = [&](auto fits) -> const HazardChoice* {
      const auto found = std::find_if(choices_.rbegin(), choices_.rend(), fits);
      return found == choices_.rend() ? nullptr : &*found;
    };
    const HazardChoice* named =
        last([&](const HazardChoice& c) { return lower(c.layer) == lower(layer); });
    const HazardChoice* all = last([](const HazardChoice& c) { return c.layer.empty(); });
    const bool one_by_one = !choices_.empty() && all == nullptr;
    if (named != nullptr) return named->off ? std::nullopt : std::optional(*named);
    if (one_by_one) return std::nullopt;
    if (is_chart_ && hazard_class(layer) == nullptr) return std::nullopt;
    return all != nullptr ? std::optional(*all) : std::optional(HazardChoice{});
  }

  void read_layer(OGRLayer& layer, const HazardChoice& how) {
    const std::string name = layer.GetName();
    const HazardClass* row = hazard_class(name);
    if (!how.buffer_m && (!is_chart_ || row == nullptr)) {
      throw UsageError("hazards", fmt::format("{}:{}", path_.string(), quotable(name)),
                       "say how much room is wanted around it, as in FILE:LAYER=20");
    }
    HazardCount count;
    count.layer = name;
    count.to_be_seen = row != nullptr && row->to_be_seen;
    const std::string crs = crs_of_hazards(layer);
    const std::optional<CrsTransform> to_frame = way_to_frame(crs);
    layer.ResetReading();
    for (const OGRFeatureUniquePtr& feature : layer) {
      ChartShapes shapes = shapes_of(feature->GetGeometryRef());
      if (row != nullptr && name == "RESARE" && !how.buffer_m && !keeps_out(*feature)) {
        ++forbid_other_;
        continue;
      }
      ++count.found;
      if (shapes.empty()) {
        ++count.without_place;
        continue;
      }
      take_feature(*feature, std::move(shapes), row, how, to_frame, count);
    }
    if (count.found == 0) return;
    say_without_place(count);
    found_.counts.push_back(count);
  }

  [[nodiscard]] std::optional<CrsTransform> way_to_frame(const std::string& crs) const {
    if (frame_.crs_wkt.empty()) {
      throw InvalidInput(fmt::format(
          "the hazards of '{}' cannot be placed: the seafloor has no coordinate reference system; "
          "give it with <CRS>",
          path_.string()));
    }
    if (crs.empty() || crs == frame_.crs_wkt) return std::nullopt;
    return std::optional<CrsTransform>(std::in_place, crs, frame_.crs_wkt);
  }

  void take_feature(const OGRFeature& feature, ChartShapes shapes, const HazardClass* row,
                    const HazardChoice& how, const std::optional<CrsTransform>& to_frame,
                    HazardCount& count) {
    Hazard hazard;
    hazard.layer = count.layer;
    hazard.to_be_seen = count.to_be_seen;
    if (how.buffer_m) {
      hazard.buffer_m = *how.buffer_m;
      hazard.accuracy_from = "typed";
    } else {
      const PositionAccuracy accuracy =
          position_accuracy({quality_.posacc_m(feature), quality_.quapos(feature),
                             row->is_danger ? zones_.at(shapes) : std::nullopt, cell_.scale},
                            row->is_danger);
      hazard.accuracy_m = accuracy.metres;
      hazard.accuracy_from = accuracy.from;
      hazard.buffer_m = row->base_m + accuracy.metres;
    }
    for_each_position(shapes, [&](std::vector<Vec2>& places) {
      if (to_frame) places = (*to_frame)(places);
      for (Vec2& p : places) p = frame_.to_local(p);
    });
    if (!comes_near(shapes, hazard.buffer_m)) return;
    clip_polygons(shapes, window(hazard.buffer_m + kWindowRoom));
    hazard.area = intersect(area_around(shapes, hazard.buffer_m), rectangle(window(kWindowRoom)));
    if (hazard.area.empty()) return;
    hazard.name = name_of_hazard(feature);
    count.least_buffer_m =
        count.near == 0 ? hazard.buffer_m : std::min(count.least_buffer_m, hazard.buffer_m);
    count.most_buffer_m = std::max(count.most_buffer_m, hazard.buffer_m);
    ++count.near;
    found_.list.push_back(std::move(hazard));
  }

  [[nodiscard]] Box2 window(double room) const {
    return {near_.min.array() - room, near_.max.array() + room};
  }
  static Area rectangle(const Box2& b) {
    return {{{b.min, {b.max.x(), b.min.y()}, b.max, {b.min.x(), b.max.y()}}, {}}};
  }
  [[nodiscard]] bool comes_near(const ChartShapes& shapes, double buffer_m) const {
    const Box2 box = extent(shapes);
    const Box2 wide = window(buffer_m + kWindowRoom);
    return (box.min.array() <= wide.max.array()).all() &&
           (box.max.array() >= wide.min.array()).all();
  }

  void say_without_place(const HazardCount& count) {
    if (count.without_place == 0) return;
    if (count.without_place == count.found) {
      throw InvalidInput(fmt::format(
          "none of the {} hazards in layer {} of '{}' has a position: they cannot be kept off; get "
          "the file anew, or leave the layer out with <hazards> {}=off",
          count.found, count.layer, path_.string(), count.layer));
    }
    found_.warnings.push_back(fmt::format(
        "{} of {} hazards in layer {} of '{}' have no position: they cannot be kept off",
        count.without_place, count.found, count.layer, path_.filename().string()));
  }

  void note_others() {
    std::vector<std::string> others;
    for (const char* name : kOtherStructures) {
      OGRLayer* layer = layer_named(*file_, name);
      if (layer == nullptr || how_to_take(name)) continue;
      const std::size_t here = count_near(*layer);
      if (here > 0) others.push_back(fmt::format("{} {}", here, name));
    }
    if (others.empty()) return;
    found_.notes.push_back(
        fmt::format("the chart shows {} here, which are not kept off unasked; <hazards> {}=20 does",
                    fmt::join(others, ", "), others.front().substr(others.front().find(' ') + 1)));
  }

  std::size_t count_near(OGRLayer& layer) const {
    const std::optional<CrsTransform> to_frame = way_to_frame(crs_of_hazards(layer));
    std::size_t here = 0;
    layer.ResetReading();
    for (const OGRFeatureUniquePtr& feature : layer) {
      ChartShapes shapes = shapes_of(feature->GetGeometryRef());
      if (shapes.empty()) continue;
      for_each_position(shapes, [&](std::vector<Vec2>& places) {
        if (to_frame) places = (*to_frame)(places);
        for (Vec2& p : places) p = frame_.to_local(p);
      });
      here += comes_near(shapes, 0.0) ? 1 : 0;
    }
    return here;
  }

  static constexpr double kWindowRoom = 10.0;  ///< metres, so that no cut shows in what is near

  const fs::path& path_;
  const std::vector<HazardChoice>& choices_;
  const Frame& frame_;
  const Box2& near_;
  bool is_chart_;
  ChartCell cell_;
  GDALDatasetUniquePtr file_;
  SpatialQuality quality_;
  QualityZones zones_;
  Hazards found_;
  std::size_t forbid_other_ = 0;
};

}  // namespace

Hazards read_hazards(const fs::path& file, const std::vector<HazardChoice>& choices,
                     const Frame& frame, const Box2& near) {
  const QuietGdal quiet;
  return HazardReader(file, choices, frame, near).read();
}

void append(Hazards& hazards, Hazards more) {
  const auto move_to = [](auto& to, auto& from) {
    to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
  };
  move_to(hazards.list, more.list);
  move_to(hazards.counts, more.counts);
  move_to(hazards.notes, more.notes);
  move_to(hazards.warnings, more.warnings);
}

Area united_area(const Hazards& hazards, bool to_be_seen) {
  std::vector<Ring> rings;
  for (const Hazard& hazard : hazards.list) {
    if (hazard.to_be_seen != to_be_seen) continue;
    for (const Polygon& polygon : hazard.area) {
      rings.push_back(polygon.outer);
      rings.insert(rings.end(), polygon.holes.begin(), polygon.holes.end());
    }
  }
  return from_rings(rings, true);
}

}  // namespace swathplan
