#include "coverage/standards/criteria.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh/base/error.h"

namespace swathplan {

namespace {

constexpr double kAnyDepth = std::numeric_limits<double>::infinity();

constexpr std::string_view kS44 = "IHO S-44, edition 6.1.0, table 1";
constexpr std::string_view kNoaa = "NOAA practice, as HydrOffice QC Tools codes it";
constexpr std::string_view kStrikes =
    "three by three strikes, a rule of practice; the standard names no number";
constexpr std::string_view kHalfFeature = "half of the feature's size, as S-44 annex D recommends";
constexpr std::string_view kAsOrder1a = "as Order 1a, since the order names none";
constexpr std::string_view kCoarsest = "the coarsest that QC Tools allows at the depth";

// S-44 annex D gives five soundings in 95 % of the nodes as an example; QC Tools asks for the same.
constexpr DensityRule kFiveIn95{5, 95.0};
constexpr double kWithin95 = 95.0;
// A gap as large as the feature: two cells of half its size.
constexpr int kFeatureCells = 2;

// Half of a cube of 2 m down to 40 m, then of a tenth of the depth where the range begins.
std::vector<CellRange> cells_of_order_1() {
  return {{40.0, 1.0},   {80.0, 2.0},    {160.0, 4.0},     {320.0, 8.0},
          {640.0, 16.0}, {1280.0, 32.0}, {kAnyDepth, 64.0}};
}

std::vector<Criterion> s44() {
  const FeatureRule half_metre{0.5, kAnyDepth, 0.0, 3, 3, kStrikes};
  const FeatureRule one_metre{1.0, kAnyDepth, 0.0, 3, 3, kStrikes};
  const FeatureRule two_metres{2.0, 40.0, 0.1, 3, 3, kStrikes};
  return {{"s44-exclusive",
           "IHO S-44 Exclusive Order",
           kS44,
           {{kAnyDepth, 0.15, 0.0075, 1.0, 0.0}},
           kWithin95,
           {{kAnyDepth, 0.25}},
           kHalfFeature,
           half_metre,
           200.0,
           200.0,
           "200 % coverage and feature search",
           GapRule::box,
           kFeatureCells,
           kFiveIn95},
          {"s44-special",
           "IHO S-44 Special Order",
           kS44,
           {{kAnyDepth, 0.25, 0.0075, 2.0, 0.0}},
           kWithin95,
           {{kAnyDepth, 0.5}},
           kHalfFeature,
           one_metre,
           100.0,
           100.0,
           "100 % coverage and feature search",
           GapRule::box,
           kFeatureCells,
           kFiveIn95},
          {"s44-1a",
           "IHO S-44 Order 1a",
           kS44,
           {{kAnyDepth, 0.5, 0.013, 5.0, 0.05}},
           kWithin95,
           cells_of_order_1(),
           kHalfFeature,
           two_metres,
           0.0,
           100.0,
           "100 % feature search, coverage up to 100 %",
           GapRule::box,
           kFeatureCells,
           kFiveIn95},
          {"s44-1b",
           "IHO S-44 Order 1b",
           kS44,
           {{kAnyDepth, 0.5, 0.013, 5.0, 0.05}},
           kWithin95,
           cells_of_order_1(),
           kAsOrder1a,
           std::nullopt,
           5.0,
           0.0,
           "5 % coverage, depths no farther apart than 3 x mean depth or 25 m",
           GapRule::spread,
           0,
           std::nullopt},
          {"s44-2",
           "IHO S-44 Order 2",
           kS44,
           {{kAnyDepth, 1.0, 0.023, 20.0, 0.1}},
           kWithin95,
           cells_of_order_1(),
           kAsOrder1a,
           std::nullopt,
           5.0,
           0.0,
           "5 % coverage, depths no farther apart than 3 x mean depth or 25 m",
           GapRule::spread,
           0,
           std::nullopt}};
}

std::vector<Criterion> noaa() {
  // TVU as Order 1 to 100 m, as Order 2 beyond, and THU as Order 1: nominal, as commonly quoted.
  const std::vector<UncertaintyLimit> limits{{100.0, 0.5, 0.013, 5.0, 0.05},
                                             {kAnyDepth, 1.0, 0.023, 5.0, 0.05}};
  const auto cells = [](double first) {
    return std::vector<CellRange>{
        {20.0, first}, {40.0, 2.0 * first}, {80.0, 4.0}, {160.0, 8.0}, {kAnyDepth, 16.0}};
  };
  std::vector<CellRange> fine = cells(0.5);
  std::vector<CellRange> coarse = cells(1.0);
  return {{"noaa-object-detection", "NOAA object detection", kNoaa, limits, kWithin95,
           std::move(fine), kCoarsest, std::nullopt, 100.0, 0.0,
           "no holiday: 3 empty cells in a row or column", GapRule::row, 3, kFiveIn95},
          {"noaa-complete-coverage", "NOAA complete coverage", kNoaa, limits, kWithin95,
           std::move(coarse), kCoarsest, std::nullopt, 100.0, 0.0, "no holiday: 3 x 3 empty cells",
           GapRule::box, 3, kFiveIn95}};
}

template <class Range>
const Range& at_depth(const std::vector<Range>& ranges, double depth_m) {
  for (const Range& range : ranges) {
    if (depth_m <= range.to_depth_m) return range;
  }
  return ranges.back();
}

}  // namespace

const std::vector<Criterion>& criteria() {
  static const std::vector<Criterion> all = [] {
    std::vector<Criterion> rows = s44();
    for (Criterion& row : noaa()) rows.push_back(std::move(row));
    return rows;
  }();
  return all;
}

const Criterion& criterion(std::string_view name) {
  std::vector<std::string_view> names;
  for (const Criterion& row : criteria()) {
    if (row.name == name) return row;
    names.push_back(row.name);
  }
  throw UsageError("criteria", std::string(name),
                   fmt::format("must be one of {}", fmt::join(names, ", ")));
}

double tvu_limit_m(const Criterion& criterion, double depth_m) {
  const UncertaintyLimit& limit = at_depth(criterion.limits, depth_m);
  const double part = limit.b * depth_m;
  return std::sqrt(limit.a_m * limit.a_m + part * part);
}

double thu_limit_m(const Criterion& criterion, double depth_m) {
  const UncertaintyLimit& limit = at_depth(criterion.limits, depth_m);
  return limit.thu_m + limit.thu_share * depth_m;
}

double cell_m(const Criterion& criterion, double depth_m) {
  return at_depth(criterion.cells, depth_m).cell_m;
}

std::optional<double> feature_m(const Criterion& criterion, double depth_m) {
  if (!criterion.features) return std::nullopt;
  const FeatureRule& rule = *criterion.features;
  return depth_m <= rule.shoal_m ? rule.cube_m : rule.share_of_depth * depth_m;
}

int lines_asked(const Criterion& criterion) {
  return std::max(criterion.coverage_pct, criterion.search_pct) > 100.0 ? 2 : 1;
}

double share_asked_pct(const Criterion& criterion) {
  return std::min(100.0, std::max(criterion.coverage_pct, criterion.search_pct));
}

}  // namespace swathplan
