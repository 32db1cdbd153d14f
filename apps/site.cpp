#include "apps/site.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "io/charts/chart_import.h"
#include "io/charts/hazards.h"
#include "io/covered/import_covered.h"
#include "io/files/crs.h"
#include "io/files/lonlat.h"
#include "io/files/unpacked.h"
#include "io/mosaic/mosaic.h"
#include "io/seafloor/area_import.h"
#include "io/water/tide_import.h"
#include "io/water/times.h"
#include "mesh/base/error.h"
#include "mesh/cropped.h"
#include "mesh/plane/area_query.h"
#include "mesh/survey_area.h"
#include "planners/wording.h"

namespace swathplan {
namespace {

/// Areas under this are not worth a note, square metres.
constexpr double kWorthSaying = 1.0;

/// Polygons of very many corners are simplified by this share of the clearance, and by no less than
/// this many metres. Positions are not known better.
constexpr double kRoundingShare = 0.1;
constexpr double kLeastRounding = 0.05;
/// ... or to more, up to this, where so little leaves thousands of corners: the ripples of a
/// digitised shoreline.
constexpr double kMostRounding = 0.5;

/// "3 pieces; the largest: 120 m2 about (x, y), ...", in the file's coordinates.
std::string pieces(Area area, const Frame& frame) {
  constexpr std::size_t kMostPlaces = 3;
  std::sort(area.begin(), area.end(),
            [](const Polygon& a, const Polygon& b) { return area_m2({a}) > area_m2({b}); });
  std::string text = fmt::format("{} piece{}{}", area.size(), area.size() == 1 ? "" : "s",
                                 area.size() == 1 ? ":" : "; the largest:");
  for (std::size_t i = 0; i < std::min(area.size(), kMostPlaces); ++i) {
    if (i > 0 && area_m2({area[i]}) < kWorthSaying) break;
    const Vec2 at = frame.to_file(inner_point({area[i]}));
    text += fmt::format("{} {:.0f} m2 about ({:.1f}, {:.1f})", i > 0 ? "," : "", area_m2({area[i]}),
                        at.x(), at.y());
  }
  return text;
}

/// Notes how much of the survey area the boat cannot sail in, and where the largest pieces are.
void note_cut_off(Site& site) {
  const Area cut = subtract(site.survey_area, site.water);
  site.cut_off_m2 = area_m2(cut);
  if (site.cut_off_m2 < kWorthSaying) return;
  site.notes.push_back(fmt::format(
      "{:.0f} m2 of the survey area ({:.2f} %) lie outside the boat's safe water, in {}. They "
      "still count in the coverage",
      site.cut_off_m2, 100.0 * site.cut_off_m2 / area_m2(site.survey_area),
      pieces(cut, site.seafloor().frame)));
}

/// Notes how much of the water is too shoal for this vehicle.
void note_shoals(Site& site, const SurveyAreaOptions& bounds) {
  const Area shoal = shoal_ground(site.seafloor(), bounds);
  const double shoal_m2 = area_m2(shoal);
  if (shoal_m2 < kWorthSaying) return;
  site.notes.push_back(fmt::format(
      "{:.0f} m2 of water are shoaler than {:.2f} m (draft, squat and margin), in {}. They are no "
      "part of the survey area and do not count in the coverage",
      shoal_m2, bounds.safe_depth_m, pieces(shoal, site.seafloor().frame)));
}

/// The polygons of a file. Shapes that do not count are named in the site's notes.
ImportedArea imported_area(Site& site, const SiteOptions& options,
                           const std::filesystem::path& file, const Box2& data, double clearance_m,
                           Rounding rounding) {
  ImportedArea read =
      import_area(file, site.seafloor().frame,
                  {.data_extent = data,
                   .buffer_m = options.buffer_m,
                   .layers = options.layers,
                   .tolerance_m = std::max(kLeastRounding, kRoundingShare * clearance_m),
                   .most_tolerance_m = kMostRounding,
                   .rounding = rounding});
  for (const std::string& note : read.notes) site.notes.push_back(in_flags(note));
  return read;
}

/// Notes how much of the area that was asked for cannot be planned, since there are no data.
void note_beyond_data(Site& site, const Area& asked) {
  const double beyond_m2 = area_m2(subtract(asked, outline(site.seafloor())));
  if (beyond_m2 < kWorthSaying) return;
  site.notes.push_back(fmt::format(
      "{:.0f} of the area's {:.0f} m2 lie outside the data and are no part of the survey",
      beyond_m2, area_m2(asked)));
}

/// Says that grid north is not true north.
void note_grid_north(Site& site) {
  constexpr double kWorthSayingDeg = 0.05;
  const double deg = site.imported.convergence_deg;
  if (std::abs(deg) < kWorthSayingDeg) return;
  site.notes.push_back(fmt::format(
      "grid north of {} lies {:.2f} degrees {} of true north at the middle of the data; headings "
      "are true (--north grid for the grid's)",
      site.imported.crs_name, std::abs(deg), deg > 0.0 ? "east" : "west"));
}

/// A chart covers far more than a survey: what lies far off the area is left out.
void crop_chart(Site& site, const SiteOptions& options, const Area& asked) {
  if (site.imported.kind != "chart") return;
  Box2 box = extent(asked);
  box.min.array() -= options.chart_margin_m;
  box.max.array() += options.chart_margin_m;
  site.imported.seafloor = cropped(site.imported.seafloor, box);
  if (site.seafloor().faces.empty()) {
    throw InvalidInput(fmt::format(
        "<area> '{}': the chart '{}' shows no water within {:g} m of it, only land or ground that "
        "was never surveyed",
        options.area.string(), site.imported.file, options.chart_margin_m));
  }
  site.notes.push_back(fmt::format(
      "the chart is used up to {:g} m around the area (--chart-margin)", options.chart_margin_m));
}

std::vector<std::filesystem::path> files_of(const SiteOptions& options) {
  std::vector<std::filesystem::path> files{options.file};
  files.insert(files.end(), options.mosaic.begin(), options.mosaic.end());
  return files;
}

bool same_file(const std::filesystem::path& a, const std::filesystem::path& b) {
  std::error_code error;
  return std::filesystem::equivalent(a, b, error);
}

/// A chart that is packed as one with others, laid out for as long as this lives.
class OpenedChart {
 public:
  OpenedChart(std::filesystem::path file, const std::string& layer) : file_(std::move(file)) {
    if (is_packed(file_)) unpacked_.emplace(file_, layer);
  }
  [[nodiscard]] const std::filesystem::path& file() const {
    return unpacked_ ? unpacked_->file() : file_;
  }
  [[nodiscard]] std::string in_words(std::string text) const {
    return unpacked_ ? unpacked_->in_words(std::move(text)) : text;
  }

 private:
  std::filesystem::path file_;
  std::optional<Unpacked> unpacked_;
};

Hazards hazards_in(const std::filesystem::path& file, const std::string& layer,
                   const std::vector<HazardChoice>& how, const Frame& frame, const Box2& near) {
  const OpenedChart chart(file, layer);
  try {
    Hazards hazards = read_hazards(chart.file(), how, frame, near);
    for (auto* texts : {&hazards.notes, &hazards.warnings}) {
      for (std::string& text : *texts) text = chart.in_words(std::move(text));
    }
    return hazards;
  } catch (const InvalidInput& error) {
    throw InvalidInput(chart.in_words(error.what()));
  }
}

/// The hazards of the chart that is the seafloor, and of the files that were named.
void add_hazards(Site& site, const SiteOptions& options) {
  const HazardChoices choices = parse_hazards(options.hazards);
  std::vector<std::filesystem::path> charts;
  if (site.imported.kind == "chart") charts = files_of(options);
  const std::string layer = import_options(options).layer;
  std::erase_if(charts, [&](const std::filesystem::path& file) {
    return !is_chart(OpenedChart(file, layer).file());
  });
  std::map<std::filesystem::path, std::vector<HazardChoice>> by_file;
  for (const std::filesystem::path& chart : charts) {
    if (choices.unasked) by_file[chart].push_back({});
  }
  for (const HazardChoice& choice : choices.list) {
    if (choice.file.empty() && charts.empty()) {
      throw UsageError("hazards", choice.layer,
                       "names a layer of a chart, but the seafloor is none; write FILE:LAYER");
    }
    if (choice.file.empty()) {
      for (const std::filesystem::path& chart : charts) by_file[chart].push_back(choice);
      continue;
    }
    const auto own = std::find_if(
        charts.begin(), charts.end(),
        [&](const std::filesystem::path& chart) { return same_file(choice.file, chart); });
    by_file[own != charts.end() ? *own : choice.file].push_back(choice);
  }
  const Box2 near = extent(site.seafloor());
  for (const auto& [file, how] : by_file) {
    append(site.hazards, hazards_in(file, layer, how, site.seafloor().frame, near));
  }
  std::string text;
  for (const HazardCount& c : site.hazards.counts) {
    if (c.near == 0) continue;
    text +=
        fmt::format("{}{} of {} {} (buffer {})", text.empty() ? "" : ", ", c.near, c.found, c.layer,
                    c.least_buffer_m == c.most_buffer_m
                        ? fmt::format("{:.4g} m", c.most_buffer_m)
                        : fmt::format("{:.4g} to {:.4g} m", c.least_buffer_m, c.most_buffer_m));
  }
  if (!site.hazards.counts.empty()) {
    site.notes.push_back("hazards kept off here: " + (text.empty() ? "none" : text));
  }
  for (const std::string& note : site.hazards.notes) site.notes.push_back(in_flags(note));
  site.imported.warnings.insert(site.imported.warnings.end(), site.hazards.warnings.begin(),
                                site.hazards.warnings.end());
}

/// What is found in an area that holds nothing to survey.
std::string what_is_there(const Site& site, const SurveyAreaOptions& bounds) {
  const double whole_m2 = area_m2(*bounds.limit);
  const Area charted = intersect(*bounds.limit, outline(site.seafloor()));
  const Area kept_off = intersect(charted, bounds.no_go);
  return fmt::format(
      "of its {:.0f} m2 {:.0f} are charted water, of which {:.0f} lie within the buffers of land, "
      "shore and no-go areas; the rest of the water is shoaler than {:.2f} m (draft, squat and "
      "margin)",
      whole_m2, area_m2(charted), area_m2(kept_off), bounds.safe_depth_m);
}

/// Reads an area. An error about it names its file.
Area limited_area(const Site& site, const SurveyAreaOptions& bounds,
                  const std::filesystem::path& file) {
  try {
    return survey_area(site.seafloor(), bounds);
  } catch (const InvalidInput& e) {
    if (site.imported.kind == "chart") {
      throw InvalidInput(fmt::format("<area> '{}' holds no water to survey: {}", file.string(),
                                     what_is_there(site, bounds)));
    }
    throw InvalidInput(fmt::format("<area> '{}': {}", file.string(), e.what()));
  }
}

/// What must not be sailed over, known from the data or typed.
Area known_land(const Site& site) {
  if (site.imported.land.empty()) return site.no_go;
  return site.no_go.empty() ? site.imported.land : unite(site.imported.land, site.no_go);
}

/// The strip along the data's outer edge, `margin_m` wide. Holes in the data count as land.
Area beyond_the_edge(const Seafloor& seafloor, double margin_m) {
  Area filled;
  for (const Polygon& polygon : outline(seafloor)) filled.push_back({polygon.outer, {}});
  return subtract(offset(filled, margin_m), filled);
}

}  // namespace

namespace {

bool serves(const Route& route, const Area& part) {
  const AreaQuery query(part);
  for (std::size_t i = 0; i + 1 < route.waypoints.size(); ++i) {
    const Waypoint& w = route.waypoints[i];
    if (is_survey(w.kind) &&
        query.inside_length(w.position, route.waypoints[i + 1].position) > 0.0) {
      return true;
    }
  }
  return false;
}

std::string title(const AreaPart& part, const Site& site) {
  const bool degrees = is_geographic(site.imported.file_crs_wkt);
  const Vec2 at = in_file_of(site.imported, inner_point(part.area));
  const std::string place = fmt::format("({0:.{2}f}, {1:.{2}f})", at.x(), at.y(), degrees ? 6 : 1);
  return part.name.empty() ? "the one about " + place
                           : fmt::format("'{}' about {}", part.name, place);
}

}  // namespace

std::string unserved_note(const Site& site, const Route& route) {
  std::vector<std::string> names;
  for (const AreaPart& part : site.parts) {
    if (part.area.empty() || serves(route, part.area)) continue;
    const double whole_m2 = area_m2(part.area);
    const double surveyed_m2 = area_m2(intersect(part.area, site.survey_area));
    if (site.covered && surveyed_m2 < kWorthSaying) continue;  // covered before
    names.push_back(fmt::format("{} ({:.0f} of {:.0f} m2 are survey area, {:.0f} m2 safe water)",
                                title(part, site), surveyed_m2, whole_m2,
                                area_m2(intersect(part.area, site.water))));
  }
  if (names.empty()) return {};
  return fmt::format("{} of {} polygons of the area {} no survey line: {}", names.size(),
                     site.parts.size(), names.size() == 1 ? "has" : "have", fmt::join(names, "; "));
}

namespace {

bool is_near_data(const std::vector<Vec2>& points, const Site& site) {
  Box2 box = extent(site.seafloor());
  const double reach = std::max(100.0, box.size().norm());
  box.min.array() -= reach;
  box.max.array() += reach;
  Box2 of_route;
  for (const Vec2& p : points) of_route.extend(p);
  return !(of_route.min.array() > box.max.array()).any() &&
         !(of_route.max.array() < box.min.array()).any();
}

/// True if the route would meet the data with longitude and latitude exchanged.
bool is_near_if_swapped(const std::vector<Vec2>& points, const Site& site) {
  const LonLat degrees(site.seafloor().frame);
  if (!degrees.known()) return false;
  try {
    std::vector<Vec2> lonlat = degrees.from_local(points);
    for (Vec2& p : lonlat) {
      p = {p.y(), p.x()};
      if (std::abs(p.y()) > 90.0) return false;
    }
    return is_near_data(degrees.to_local(lonlat), site);
  } catch (const InvalidInput&) {
    return false;  // some place has no counterpart
  }
}

}  // namespace

void check_meets_data(const Route& route, const Site& site, const std::filesystem::path& file) {
  const std::vector<Vec2> points = positions(route.waypoints);
  if (is_near_data(points, site)) return;
  if (is_near_if_swapped(points, site)) {
    throw InvalidInput(fmt::format(
        "'{}': the route lies outside the seafloor's data, but with latitude and longitude "
        "exchanged it would meet them: the file has them in the wrong order; exchange them there",
        file.string()));
  }
  throw InvalidInput(fmt::format(
      "'{}': the route lies outside the seafloor's data; check that both are in the same CRS "
      "(lon_deg,lat_deg or the coordinates of the seafloor's file)",
      file.string()));
}

ImportedSeafloor imported_seafloor(const SiteOptions& options) {
  if (options.mosaic.empty()) return import_seafloor(options.file, import_options(options));
  const MosaicPriority priority = options.priority == "newest"  ? MosaicPriority::newest
                                  : options.priority == "order" ? MosaicPriority::order
                                                                : MosaicPriority::finest;
  return import_mosaic(files_of(options), priority, import_options(options));
}

std::unique_ptr<Site> load_site(const SiteOptions& options, const Vehicle& vehicle,
                                const Watch& watch) {
  auto site = std::make_unique<Site>();
  watch.phase(fmt::format("reading {}", options.file.filename().string()));
  site->imported = imported_seafloor(options);
  watch.phase("working out areas and safe water");
  SurveyAreaOptions bounds;
  bounds.safe_depth_m = safe_depth_m(vehicle);
  const Box2 data = extent(site->seafloor());
  if (!options.area.empty()) {
    ImportedArea asked =
        imported_area(*site, options, options.area, data, vehicle.clearance_m, Rounding::within);
    bounds.limit = std::move(asked.area);
    if (asked.parts.size() > 1) site->parts = std::move(asked.parts);
    crop_chart(*site, options, *bounds.limit);
    note_beyond_data(*site, *bounds.limit);
  }
  site->depths = std::make_unique<DepthQuery>(site->seafloor());
  add_hazards(*site, options);
  const auto kept_off = [&](const std::filesystem::path& file, bool to_be_seen) {
    Area area = united_area(site->hazards, to_be_seen);
    if (file.empty()) return area;
    Area typed =
        imported_area(*site, options, file, data, vehicle.clearance_m, Rounding::around).area;
    return area.empty() ? typed : unite(area, typed);
  };
  site->no_go = bounds.no_go = kept_off(options.no_go, false);
  site->keep_off = kept_off(options.keep_off, true);
  site->land = known_land(*site);
  site->survey_area = bounds.limit ? limited_area(*site, bounds, options.area)
                                   : survey_area(site->seafloor(), bounds);
  SurveyAreaOptions anywhere = bounds;
  anywhere.limit.reset();
  Area sailable = bounds.limit ? survey_area(site->seafloor(), anywhere) : site->survey_area;
  if (options.run_out_margin_m > 0.0) {
    const Area strip = beyond_the_edge(site->seafloor(), options.run_out_margin_m);
    sailable = subtract(unite(sailable, strip), site->land);
  }
  if (!site->keep_off.empty()) sailable = subtract(sailable, site->keep_off);
  site->water = offset(sailable, -vehicle.clearance_m);
  if (site->water.empty()) {
    throw InvalidInput(
        fmt::format("no water is left {:g} m off walls, shoals and no-go areas; lower --clearance",
                    vehicle.clearance_m));
  }
  note_grid_north(*site);
  note_shoals(*site, bounds);
  note_cut_off(*site);
  return site;
}

namespace {

CoveredOptions covered_how(const Site& site, const RayScene& scene, const CoveredChoice& choice,
                           const Survey& survey, const std::vector<std::string>& layers) {
  CoveredOptions how;
  how.whole = site.ground(&scene);
  how.sonar = survey.sonar;
  how.vehicle = survey.vehicle;
  how.scoring = survey.scoring;
  how.logged_only = survey.planning.counted == Counted::logged;
  how.track_swath_m = choice.swath_m;
  if (choice.opening_deg) {
    const Angle half = Angle::degrees(*choice.opening_deg / 2.0);
    how.track_fan = FanAngles{half, half};
  }
  how.layers = layers;
  return how;
}

void note_rest(Site& site, const Survey& survey) {
  const double whole_m2 = area_m2(site.survey_area);
  const double rest_m2 = area_m2(site.rest.area);
  const auto before = static_cast<double>(site.covered->covered_cells());
  const double share = 100.0 * before / static_cast<double>(site.covered->cells());
  const std::string gaps =
      site.rest.gaps == 0
          ? ""
          : fmt::format(
                "; {} of it, {:.1f} m2, {} narrower than {} cells or smaller than {:g} m2 "
                "and left as {}",
                counted(site.rest.gaps, "gap"), site.rest.gaps_m2,
                site.rest.gaps == 1 ? "is" : "are", kNarrowestRest, survey.scoring.holiday_m2,
                site.rest.gaps == 1 ? "it is" : "they are");
  if (site.rest.area.empty()) {
    throw InvalidInput(
        fmt::format("the survey area is covered already ({:.2f} % of its cells{}): nothing is left",
                    share, gaps));
  }
  site.notes.push_back(fmt::format(
      "{:.2f} % of the survey area ({:.0f} m2) were covered before{}. The rest, {:.0f} m2 in {}, "
      "is what figures and holidays are of, unless they say 'whole'",
      share, whole_m2, gaps, rest_m2, counted(site.rest.area.size(), "piece")));
}

}  // namespace

void take_off_covered(Site& site, const CoveredChoice& choice, const Survey& survey,
                      const std::vector<std::string>& layers) {
  if (choice.files.empty()) return;
  const auto wanted = static_cast<std::uint32_t>(std::ceil(survey.planning.soundings));
  auto before = std::make_shared<CoveredBefore>(site.survey_area, survey.scoring.resolution_m,
                                                std::max(1U, wanted));
  const RayScene scene(site.seafloor(), survey.scoring.nodata);
  const CoveredOptions how = covered_how(site, scene, choice, survey, layers);
  for (const std::string& file : choice.files) {
    add_covered(file, site.seafloor().frame, how, *before, site.notes);
  }
  site.covered = before;
  site.rest = before->rest(survey.scoring.holiday_m2);
  note_rest(site, survey);
  site.survey_area = site.rest.area;
}

void take_tide(Site& site, const WaterChoice& choice, const SiteOptions& options) {
  if (!choice.depart.empty()) {
    site.departure_s = time_of(choice.depart);
    if (!site.departure_s) {
      throw UsageError(fmt::format("--depart '{}' is no time; write it as 2026-05-01T06:30 (UTC)",
                                   choice.depart));
    }
  }
  if (choice.tide.empty()) return;
  ImportedTide read = import_tide(choice.tide);
  site.notes.insert(site.notes.end(), read.notes.begin(), read.notes.end());
  std::vector<TideHeight> rows = read.tide.rows();
  const double first = rows.front().time_s;
  const double last = rows.back().time_s;
  if (site.departure_s && (*site.departure_s < first || *site.departure_s > last)) {
    throw UsageError(fmt::format("--depart {} lies outside the table of '{}' ({} to {})",
                                 time_text(*site.departure_s), choice.tide.string(),
                                 time_text(first), time_text(last)));
  }
  // Depths count from the level that the survey is planned at.
  for (TideHeight& row : rows) row.height_m -= options.water_level_m;
  site.tide = std::make_shared<Tide>(std::move(rows));
}

}  // namespace swathplan
