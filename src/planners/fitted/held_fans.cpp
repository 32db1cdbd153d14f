#include "planners/fitted/held_fans.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "coverage/route/ping_clock.h"

namespace swathplan {
namespace {

/// Of a line's metres this share has the angle that it asks for: one jagged place of a raster does
/// not open the fan of a whole line.
constexpr double kServedShare = 0.95;
/// The speed serves this share of a line's metres by depth.
constexpr double kDepthShare = 0.75;
constexpr double kSpeedStep = 0.1;
/// Long lines are looked at in so many pieces.
constexpr double kMostPieces = 48.0;

/// Pairs of a value and the metres that it holds for.
using Weighted = std::vector<std::pair<double, double>>;

/// The value that `share` of the metres do not exceed.
double percentile(Weighted values, double share) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  double total = 0.0;
  for (const auto& [value, metres] : values) total += metres;
  double sum = 0.0;
  for (const auto& [value, metres] : values) {
    sum += metres;
    if (sum >= share * total) return value;
  }
  return values.back().first;
}

Angle whole_degrees(double radians, const Sonar& sonar) {
  // A hair over a whole degree is not the next one.
  constexpr double kDust = 1e-6;
  const double degrees = std::ceil(Angle::radians(radians).deg() - kDust);
  return std::min(Angle::degrees(std::max(degrees, 1.0)), sonar.max_opening / 2.0);
}

/// Middle of the segment from waypoint i on.
Vec2 middle(const std::vector<Waypoint>& line, std::size_t i) {
  return 0.5 * (line[i].position + line[i + 1].position);
}

/// Waypoints beyond the area take the fan of the nearest one in it along the line.
void carry_fans_out(std::vector<Waypoint>& line, const AreaQuery& area) {
  std::optional<FanAngles> last;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    if (area.contains(middle(line, i))) {
      if (!last)
        std::for_each(line.begin(), line.begin() + static_cast<std::ptrdiff_t>(i),
                      [&](Waypoint& w) { w.fan = line[i].fan; });
      last = line[i].fan;
    } else if (last) {
      line[i].fan = last;
    }
  }
  line.back().fan = line[line.size() - 2].fan;
}

double speed_for(const FanAngles& fan, double below_m, double soundings,
                 const PlanOptions& options) {
  const Angle wider = std::max(fan.port, fan.starboard);
  const double cosine = cos(wider);
  const double gaps = options.sonar.beams - 1;
  const double spacing =
      (fan.port.rad() + fan.starboard.rad()) * below_m / (gaps * cosine * cosine);
  const double interval = ping_interval_s(options.sonar, options.pings,
                                          std::min(below_m / cosine, options.sonar.max_range_m));
  const double cell = options.resolution_m;
  return std::min({options.vehicle.speed_mps, cell / interval,
                   cell * cell / (soundings * std::max(spacing, 1e-9) * interval)});
}

/// A stretch of a line that is not divided between legs.
struct Piece {
  std::size_t begin = 0, end = 0;  ///< of waypoints; the last one is where the next piece begins
  double metres = 0.0;             ///< inside the area
  double port = 0.0, starboard = 0.0, below_m = 0.0;
};

/// What the metres of a stretch inside the area ask for.
struct Asked {
  Weighted port, starboard, depths;
};

class LineHolder {
 public:
  LineHolder(std::vector<Waypoint>& line, const WaterRaster& raster, const AreaQuery& area,
             const PlanOptions& options, double edge_share)
      : line_(line), raster_(raster), area_(area), options_(options), edge_share_(edge_share) {}

  void hold() {
    std::vector<std::size_t> ends{line_.size() - 1};
    if (options_.angles == Angles::line && !options_.opening_angle) ends = leg_ends();
    std::size_t begin = 0;
    for (const std::size_t end : ends) {
      hold_leg(begin, end);
      begin = end;
    }
    line_.back().fan = line_[line_.size() - 2].fan;
    line_.back().speed_mps = line_[line_.size() - 2].speed_mps;
  }

 private:
  [[nodiscard]] Asked asked(std::size_t begin, std::size_t end) const {
    Asked result;
    for (std::size_t i = begin; i < end; ++i) {
      const Vec2 p = middle(line_, i);
      if (!line_[i].fan || !area_.contains(p)) continue;
      const double metres = (line_[i + 1].position - line_[i].position).norm();
      result.port.emplace_back(line_[i].fan->port.rad(), metres);
      result.starboard.emplace_back(line_[i].fan->starboard.rad(), metres);
      if (const auto depth = raster_.depth_near(p)) result.depths.emplace_back(*depth, metres);
    }
    return result;
  }
  [[nodiscard]] double below(const Weighted& depths) const {
    return std::max(percentile(depths, kDepthShare) - options_.vehicle.draft_m, 0.1);
  }

  void hold_leg(std::size_t begin, std::size_t end) {
    const Asked here = asked(begin, end);
    FanAngles held;
    if (here.port.empty()) {
      held = line_[begin].fan.value_or(
          FanAngles{options_.sonar.max_opening / 4.0, options_.sonar.max_opening / 4.0});
    } else {
      held = {whole_degrees(percentile(here.port, kServedShare), options_.sonar),
              whole_degrees(percentile(here.starboard, kServedShare), options_.sonar)};
    }
    if (options_.opening_angle) {
      held = {*options_.opening_angle / 2.0, *options_.opening_angle / 2.0};
    }
    const double most =
        speed_for(held, below(here.depths), edge_share_ * options_.soundings, options_);
    const double speed = std::clamp(std::floor(most / kSpeedStep + 1e-6) * kSpeedStep,
                                    options_.least_speed_mps, options_.vehicle.speed_mps);
    for (std::size_t i = begin; i < end; ++i) {
      if (options_.angles == Angles::line || options_.opening_angle) line_[i].fan = held;
      line_[i].speed_mps = speed;
    }
  }

  [[nodiscard]] std::vector<Piece> pieces() const {
    double length = 0.0;
    for (std::size_t i = 0; i + 1 < line_.size(); ++i) {
      length += (line_[i + 1].position - line_[i].position).norm();
    }
    const double least = std::max(options_.least_line_m, length / kMostPieces);
    std::vector<Piece> result;
    double metres = 0.0;
    std::size_t begin = 0;
    for (std::size_t i = 0; i + 1 < line_.size(); ++i) {
      const double step = (line_[i + 1].position - line_[i].position).norm();
      metres += step;
      length -= step;
      // What is left must make a leg by itself.
      const bool last = i + 2 == line_.size();
      if (!last && (metres < least || length < least)) continue;
      const Asked here = asked(begin, i + 1);
      Piece piece{begin, i + 1, 0.0, 0.0, 0.0, below(here.depths)};
      for (const auto& [angle, m] : here.port) piece.metres += m;
      piece.port = percentile(here.port, kServedShare);
      piece.starboard = percentile(here.starboard, kServedShare);
      result.push_back(piece);
      begin = i + 1;
      metres = 0.0;
    }
    return result;
  }

  /// Seconds of pinging that a fan takes for each sounding, but for what it has in common with
  /// another fan over the same depth.
  [[nodiscard]] double seconds_a_sounding(double port, double starboard, double below_m) const {
    const double range = below_m / std::cos(std::max(port, starboard));
    return (port + starboard) * ping_interval_s(options_.sonar, options_.pings,
                                                std::min(range, options_.sonar.max_range_m));
  }

  /// Seconds' worth of soundings that pieces first to last lose by one fan for all of them.
  [[nodiscard]] double lost_s(const std::vector<Piece>& all, std::size_t first,
                              std::size_t last) const {
    Weighted ports, starboards;
    for (std::size_t k = first; k <= last; ++k) {
      ports.emplace_back(all[k].port, all[k].metres);
      starboards.emplace_back(all[k].starboard, all[k].metres);
    }
    const double port = percentile(ports, kServedShare);
    const double starboard = percentile(starboards, kServedShare);
    double lost = 0.0;
    for (std::size_t k = first; k <= last; ++k) {
      const Piece& piece = all[k];
      const double own = seconds_a_sounding(piece.port, piece.starboard, piece.below_m);
      const double held = seconds_a_sounding(port, starboard, piece.below_m);
      if (held > own) lost += (1.0 - own / held) * piece.metres / options_.vehicle.speed_mps;
    }
    return lost;
  }

  /// The legs that lose least, each change counted: where each one ends.
  [[nodiscard]] std::vector<std::size_t> leg_ends() const {
    const std::vector<Piece> all = pieces();
    std::vector<double> cost(all.size() + 1, std::numeric_limits<double>::infinity());
    std::vector<std::size_t> from(all.size() + 1, 0);
    cost[0] = 0.0;
    for (std::size_t end = 1; end <= all.size(); ++end) {
      for (std::size_t begin = 0; begin < end; ++begin) {
        const double here = cost[begin] + kSecondsOfChange + lost_s(all, begin, end - 1);
        if (here < cost[end]) {
          cost[end] = here;
          from[end] = begin;
        }
      }
    }
    std::vector<std::size_t> ends;
    for (std::size_t k = all.size(); k > 0; k = from[k]) ends.push_back(all[k - 1].end);
    std::reverse(ends.begin(), ends.end());
    return ends;
  }

  std::vector<Waypoint>& line_;
  const WaterRaster& raster_;
  const AreaQuery& area_;
  const PlanOptions& options_;
  double edge_share_;
};

}  // namespace

void hold_fans(std::vector<std::vector<Waypoint>>& lines, const WaterRaster& raster,
               const AreaQuery& survey_area, const PlanOptions& options, double edge_share) {
  for (std::vector<Waypoint>& line : lines) {
    if (line.size() < 2) continue;
    LineHolder(line, raster, survey_area, options, edge_share).hold();
    if (options.angles == Angles::ping) carry_fans_out(line, survey_area);
  }
}

}  // namespace swathplan
