#include "planners/passing/sparse_lines.h"

#include <algorithm>

#include "planners/fronts/fitted_straight.h"
#include "planners/fronts/rate_width.h"
#include "planners/passing/paced_lines.h"
#include "planners/rows/survey_lines.h"

namespace swathplan {
namespace {

constexpr double kSparseDirectionStepDeg = 15.0;
constexpr std::size_t kSparseDirections = 3;
/// Of the distance allowed: a boat wanders, and the lines of a slant outline end early.
constexpr double kSparseShares[] = {0.95, 0.8, 0.65, 0.5, 0.35, 0.2, 0.0};

double mean_depth(const WaterRaster& raster) {
  double sum = 0.0;
  std::size_t cells = 0;
  for (std::size_t i = 0; i < raster.size(); ++i) {
    if (!raster.in_area(i)) continue;
    sum += raster.depth(i);
    ++cells;
  }
  return cells > 0 ? sum / static_cast<double>(cells) : 0.0;
}

std::vector<SurveyCurve> rows(LineWorkshop& shop, const std::vector<float>& width, Angle azimuth) {
  std::vector<SurveyCurve> lines =
      fitted_straight_lines(shop.raster(), width, shop.survey_area(), shop.lines_in(),
                            {.azimuth = azimuth, .inset_m = 0.0});
  std::erase_if(lines, [&](const SurveyCurve& line) {
    return line.points.size() < 2 || length_m(line) < shop.options().least_line_m;
  });
  return lines;
}

std::vector<Angle> directions(LineWorkshop& shop, const std::vector<float>& width) {
  if (shop.options().heading) return {*shop.options().heading};
  std::vector<Angle> all{best_azimuth(shop.ground().survey_area, width.empty() ? 1.0 : 25.0)};
  for (double deg = 0.0; deg < 180.0; deg += kSparseDirectionStepDeg) {
    all.push_back(Angle::degrees(deg));
  }
  std::vector<std::pair<double, std::size_t>> metres;
  for (std::size_t k = 0; k < all.size(); ++k) {
    double sum = 0.0;
    for (const SurveyCurve& line : rows(shop, width, all[k])) {
      sum += length_m(line) + 4.0 * shop.options().vehicle.turn_radius_m;
    }
    if (sum > 0.0) metres.emplace_back(sum, k);
  }
  std::sort(metres.begin(), metres.end());
  std::vector<Angle> best;
  for (std::size_t k = 0; k < std::min(kSparseDirections, metres.size()); ++k) {
    best.push_back(all[metres[k].second]);
  }
  return best;
}

}  // namespace

std::optional<SparsePlan> sparse_lines(const SurveyJudge& judge, LineWorkshop& shop) {
  const PlanOptions& how = shop.options();
  const std::vector<float> swath = rate_width_field(shop.raster(), how, 1.0, 0.0);
  const double apart = depths_apart_m(mean_depth(shop.raster()));
  ScoreOptions scoring;
  scoring.resolution_m = how.resolution_m;
  scoring.pings = how.pings;
  scoring.threads = how.threads;
  const auto wider = [&](double share) {
    std::vector<float> width = swath;
    for (float& w : width) w += w > 0.0F ? static_cast<float>(share * apart) : 0.0F;
    return width;
  };
  std::optional<SparsePlan> best;
  double seconds = 0.0;
  for (const Angle azimuth : directions(shop, wider(kSparseShares[0]))) {
    for (const double share : kSparseShares) {
      const std::vector<float> width = wider(share);
      const std::vector<SurveyCurve> lines = rows(shop, width, azimuth);
      if (lines.empty()) continue;
      BuiltRoute built = shop.build(lines, width, {.overlap_m = 0.5 * how.resolution_m});
      pace_lines(built.route, judge, how, 1.0);
      if (built.route.waypoints.size() < 2) continue;
      const double takes = sailing_s(built.route);
      if (best && best->verdict.pass && takes >= seconds) break;
      Verdict verdict = judge.judge(built.route, how.sonar, how.vehicle, scoring).verdict;
      const bool passes = verdict.pass;
      if (!best || passes || !best->verdict.pass) {
        best = SparsePlan{std::move(built), std::move(verdict), share};
        seconds = takes;
      }
      if (passes) break;
    }
  }
  return best;
}

}  // namespace swathplan
