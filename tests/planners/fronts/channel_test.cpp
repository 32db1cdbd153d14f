#include "planners/fronts/channel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "mesh/survey_area.h"
#include "mesh/synthetic.h"
#include "planners/fitted/fitted_lines.h"
#include "planners/fronts/field_lines.h"

namespace swathplan {
namespace {

constexpr double kInner = 60.0, kOuter = 84.0;

/// A quarter of a ring about the origin: a bend of 24 m width, or all of the ring.
Ring arc(double radius, double from, double to, int points) {
  Ring ring;
  for (int i = 0; i <= points; ++i) {
    const double angle = from + (to - from) * i / points;
    ring.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return ring;
}

Area bend() {
  Ring ring = arc(kOuter, 0.0, std::numbers::pi / 2.0, 90);
  const Ring back = arc(kInner, std::numbers::pi / 2.0, 0.0, 90);
  ring.insert(ring.end(), back.begin(), back.end());
  return from_rings({ring}, true);
}

struct Water {
  explicit Water(Seafloor floor, const std::optional<Area>& area = {})
      : seafloor(std::move(floor)), depths(seafloor) {
    ground.seafloor = &seafloor;
    ground.depths = &depths;
    ground.survey_area = ground.water = area ? *area : survey_area(seafloor, {});
    raster.emplace(ground, 1e6, 0.5);
    options.resolution_m = 0.25;
    options.sonar.max_opening = Angle::degrees(90.0);
    width = width_field(*raster, options, 1.0);
  }
  [[nodiscard]] std::optional<Banks> banks() const { return banks_of(*raster, ground.survey_area); }
  [[nodiscard]] std::vector<SurveyCurve> lines(int count) const {
    const Banks sides = *banks();
    const BetweenBanks between = between_banks(*raster, width, sides);
    return lines_between(*raster, sides, between, {{0.0F, 1.0F, count}}, 60);
  }
  Seafloor seafloor;
  DepthQuery depths;
  Ground ground;
  PlanOptions options;
  std::optional<WaterRaster> raster;
  std::vector<float> width;
};

TEST(Channel, WideWatersHaveNoBanks) {
  EXPECT_FALSE(Water(flat(60.0, 60.0, 6.0)).banks());
  EXPECT_FALSE(Water(flat(90.0, 60.0, 6.0)).banks());
  EXPECT_FALSE(banks_of(*Water(flat(60.0, 60.0, 6.0)).raster, {}));
}

TEST(Channel, BanksOfACanalAreItsLongSides) {
  const Water canal(flat(200.0, 20.0, 6.0));
  const auto banks = canal.banks();
  ASSERT_TRUE(banks);
  std::set<int> sides;
  for (const SurveyCurve* bank : {&banks->one, &banks->other}) {
    EXPECT_GT(length_m(*bank), 175.0);
    sides.insert(static_cast<int>(std::lround(bank->points[bank->points.size() / 2].y())));
  }
  EXPECT_EQ(sides, (std::set<int>{0, 20}));
}

TEST(Channel, LinesOfABendFollowIt) {
  const Water water(flat(100.0, 100.0, 6.0), bend());
  const auto lines = water.lines(3);
  ASSERT_EQ(lines.size(), 3U);
  std::multiset<int> radii;
  for (const SurveyCurve& line : lines) {
    const Vec2& middle = line.points[line.points.size() / 2];
    radii.insert(static_cast<int>(std::lround(middle.norm())));
    // From end to end, but for the ends themselves.
    EXPECT_NEAR(length_m(line), middle.norm() * std::numbers::pi / 2.0, 8.0);
    for (const Vec2& p : line.points) {
      const bool near_end = p.x() < 15.0 || p.y() < 15.0;
      EXPECT_TRUE(near_end || std::abs(p.norm() - middle.norm()) < 1.0) << p;
    }
  }
  EXPECT_EQ(radii, (std::multiset<int>{64, 72, 80}));
}

TEST(Channel, LinesOfARingAreClosed) {
  Area ring = from_rings(
      {arc(40.0, 0.0, 2.0 * std::numbers::pi, 180), arc(24.0, 0.0, 2.0 * std::numbers::pi, 180)},
      false);
  for (Polygon& polygon : ring) {
    for (Vec2& p : polygon.outer) p += Vec2(50.0, 50.0);
    for (Ring& hole : polygon.holes) {
      for (Vec2& p : hole) p += Vec2(50.0, 50.0);
    }
  }
  const Water water(flat(100.0, 100.0, 6.0), ring);
  const auto lines = water.lines(2);
  ASSERT_EQ(lines.size(), 2U);
  for (const SurveyCurve& line : lines) EXPECT_TRUE(is_closed(line));
  EXPECT_NEAR(length_m(lines[0]) + length_m(lines[1]), 2.0 * std::numbers::pi * 64.0, 6.0);
}

TEST(Channel, ShoalSectionsHaveMoreLines) {
  const Water canal(stepped(240.0, 24.0, 3.0, 10.0));
  const Banks banks = *canal.banks();
  const BetweenBanks between = between_banks(*canal.raster, canal.width, banks);
  const auto sections = sections_of(banks, between, 1.0);
  const bool west_first = banks.along[*canal.raster->cell_at({10.0, 12.0})] < 0.5F;
  const ChannelSection& west = west_first ? sections.front() : sections.back();
  const ChannelSection& east = west_first ? sections.back() : sections.front();
  EXPECT_GT(west.lines, east.lines);
  EXPECT_FLOAT_EQ(sections.back().to, 1.0F);
  std::size_t lines = 0;
  for (std::size_t k = 0; k < sections.size(); ++k) {
    EXPECT_FLOAT_EQ(k > 0 ? sections[k - 1].to : 0.0F, sections[k].from);
    lines += static_cast<std::size_t>(sections[k].lines);
  }
  EXPECT_EQ(lines_between(*canal.raster, banks, between, sections, 60).size(), lines);
}

TEST(Channel, FittedLinesFollowABend) {
  Water water(flat(100.0, 100.0, 6.0), bend());
  const RayScene scene(water.seafloor, Nodata::wall);
  water.ground.scene = &scene;
  water.options.resolution_m = 0.5;
  water.options.lines = LineSource::field;
  const Plan plan = plan_fitted_lines(water.ground, water.options);
  EXPECT_NE(plan.choices[plan.chosen].what.find("along the banks"), std::string::npos);
  EXPECT_GT(plan.choices[plan.chosen].cover_pct, 95.0);
}

}  // namespace
}  // namespace swathplan
