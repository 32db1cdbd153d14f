#include "apps/job/job_request.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "io/files/crs.h"
#include "mesh/base/error.h"
#include "planners/job/berth_place.h"

namespace swathplan {
namespace {

std::optional<double> whole_text_number(std::string_view text) {
  double value = 0.0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc() && stop == text.data() + text.size();
  return whole && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

/// 'X,Y'; empty for any other text.
std::optional<Vec2> two_numbers(const std::string& text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos) return std::nullopt;
  const auto x = whole_text_number(std::string_view(text).substr(0, comma));
  const auto y = whole_text_number(std::string_view(text).substr(comma + 1));
  return x && y ? std::optional(Vec2(*x, *y)) : std::nullopt;
}

/// '06:30' as hours; empty for any other text.
std::optional<double> time_of_day(std::string_view text) {
  const std::size_t colon = text.find(':');
  const auto hours = whole_text_number(text.substr(0, colon));
  const auto minutes = colon == std::string_view::npos ? std::optional(0.0)
                                                       : whole_text_number(text.substr(colon + 1));
  if (!hours || !minutes || *hours < 0.0 || *minutes < 0.0 || *minutes >= 60.0) return {};
  const double time = *hours + *minutes / 60.0;
  return time <= 24.0 ? std::optional(time) : std::nullopt;
}

Daylight daylight_of(const std::string& text) {
  const std::size_t dash = text.find('-');
  const auto from = time_of_day(std::string_view(text).substr(0, dash));
  const auto to =
      dash == std::string::npos ? from : time_of_day(std::string_view(text).substr(dash + 1));
  if (!from || !to || !(*from < *to)) {
    throw UsageError(fmt::format(
        "--daylight '{}'; must be two times of one day, the earlier first, as in '06:00-18:00'",
        text));
  }
  return {*from, *to};
}

/// The longest sortie that everything given allows, and a note where the vehicle binds.
void set_longest_sortie(const JobChoice& typed, const Vehicle& vehicle, JobRequest& request) {
  std::vector<double> hours;
  if (typed.sortie_h) hours.push_back(*typed.sortie_h);
  if (!typed.daylight.empty()) {
    request.job.daylight = daylight_of(typed.daylight);
    hours.push_back(request.job.daylight->to_h - request.job.daylight->from_h);
  }
  if (typed.battery_wh) {
    if (!vehicle.power_w) {
      throw UsageError(
          fmt::format("--battery {:g}; say with --power what the vehicle draws under way, in watts",
                      *typed.battery_wh));
    }
    hours.push_back(*typed.battery_wh / *vehicle.power_w);
  }
  if (hours.empty()) return;
  const double asked = *std::min_element(hours.begin(), hours.end());
  if (asked > vehicle.endurance_h) {
    request.notes.push_back(
        fmt::format("sorties are no longer than the vehicle's endurance of {:g} h (--endurance)",
                    vehicle.endurance_h));
  }
  request.job.longest_sortie_s = 3600.0 * std::min(asked, vehicle.endurance_h);
}

void set_beside(const JobChoice& typed, const std::optional<double>& spacing_m,
                JobRequest& request) {
  if (typed.beside.empty()) {
    if (typed.beside_lines) {
      throw UsageError("--beside-lines without --beside; say beside what");
    }
    return;
  }
  if (!spacing_m) {
    throw UsageError("--beside without --spacing; say how many metres lines lie apart");
  }
  if (!typed.keep.empty()) {
    throw UsageError("--keep and --beside exclude each other; give one of them");
  }
  request.beside_xy = two_numbers(typed.beside);
  request.beside = {.to_each_side = typed.beside_lines.value_or(1), .spacing_m = *spacing_m};
}

Vec2 placed_in(const Site& site, const Vec2& in_file, const char* flag, const std::string& text) {
  try {
    return local_of(site.imported, in_file);
  } catch (const InvalidInput& e) {
    throw UsageError(fmt::format("{} {}: {}", flag, text, e.what()));
  }
}

std::string place_text(const Site& site, const Vec2& local) {
  const Vec2 at = in_file_of(site.imported, local);
  const int decimals = is_geographic(site.imported.file_crs_wkt) ? 6 : 1;
  return fmt::format("{0:.{2}f},{1:.{2}f}", at.x(), at.y(), decimals);
}

}  // namespace

bool JobRequest::any() const {
  return berth_xy || job.cross_share > 0.0 || job.patch_test || job.longest_sortie_s ||
         job.boats > 1;
}

JobRequest job_request(const JobChoice& typed, const std::optional<double>& spacing_m,
                       const Vehicle& vehicle) {
  JobRequest request;
  request.berth_text = typed.berth;
  if (!typed.berth.empty()) {
    request.berth_xy = two_numbers(typed.berth);
    if (!request.berth_xy) {
      throw UsageError(fmt::format(
          "--berth '{}'; must be X,Y in the coordinates of the seafloor file, as in '150,20'",
          typed.berth));
    }
  }
  request.job.cross_share = typed.cross_lines_pct.value_or(0.0) / 100.0;
  request.job.patch_test = typed.patch_test;
  request.job.boats = typed.boats;
  set_longest_sortie(typed, vehicle, request);
  set_beside(typed, spacing_m, request);
  check(request.job);
  return request;
}

std::optional<Vec2> berth_in(const Site& site, const JobRequest& request, const Vehicle& vehicle,
                             std::vector<std::string>& notes) {
  if (!request.berth_xy) return std::nullopt;
  const Vec2 berth = placed_in(site, *request.berth_xy, "--berth", request.berth_text);
  const BerthPlace found = berth_place(berth, site.ground(nullptr), vehicle);
  if (found.lies == BerthPlace::Lies::in_safe_water) return found.place;
  if (found.lies == BerthPlace::Lies::off_it) {
    constexpr double kOtherCoordinates = 100e3;
    throw UsageError(fmt::format(
        "--berth {}: no boat lies there: it is on land, off the data, in water shoaler than {:g} m "
        "or in a no-go area; the nearest safe water is {:.1f} m away, at {}{}",
        request.berth_text, safe_depth_m(vehicle), found.apart_m, place_text(site, found.place),
        found.apart_m > kOtherCoordinates ? "; give it in the coordinates of the seafloor's file"
                                          : ""));
  }
  notes.push_back(fmt::format(
      "the berth {} lies nearer to a wall, a shoal or a no-go area than --clearance {:g} allows: "
      "the route begins and ends {:.1f} m off it, at {}",
      request.berth_text, vehicle.clearance_m, found.apart_m, place_text(site, found.place)));
  return found.place;
}

GivenShapes shapes_beside(const Site& site, const JobChoice& typed, const JobRequest& request) {
  if (request.beside_xy) {
    return {{}, {placed_in(site, *request.beside_xy, "--beside", typed.beside)}, {}};
  }
  ImportedShapes read = import_shapes(typed.beside, site.seafloor().frame);
  return {std::move(read.lines), std::move(read.points), std::move(read.polygons)};
}

}  // namespace swathplan
