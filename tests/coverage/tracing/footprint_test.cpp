// Footprints against a loop over all beams and all cells.

#include <gtest/gtest.h>

#include "coverage/scenes.h"
#include "mesh/synthetic.h"

namespace swathplan {
namespace {

using testing::route_through;
using testing::TestGround;

/// One footprint in the plane of its ping, metres.
struct Piece {
  double left, right, half_along;
};

/// The rule as score.h states it, in double precision.
std::vector<Piece> pieces(const Ping& ping, const RayScene& scene, const Sonar& sonar,
                          double draft) {
  const auto angles = beam_angles_rad(sonar, ping.fan);
  const Vec2 starboard(ping.course.y(), -ping.course.x());
  std::vector<Eigen::Vector3f> beams;
  for (const double a : angles) {
    beams.push_back(
        Vec3(std::sin(a) * starboard.x(), std::sin(a) * starboard.y(), -std::cos(a)).cast<float>());
  }
  std::vector<RayHit> hits(beams.size());
  scene.trace({ping.position.x(), ping.position.y(), -draft}, beams, hits);
  std::vector<Piece> result;
  double before = -1e9;
  for (std::size_t i = 0; i < hits.size(); ++i) {
    const RayHit& h = hits[i];
    if (!(h.range_m > 0)) continue;
    const double at = h.range_m * std::sin(angles[i]);
    if (at <= before) continue;
    const double facing = std::abs(h.nx * beams[i].x() + h.ny * beams[i].y() + h.nz * beams[i].z());
    const double size = h.range_m * std::min(5.76, h.nz / facing);
    const std::size_t l = std::max<std::size_t>(i, 1);
    const std::size_t r = std::min(i + 1, hits.size() - 1);
    const double width = sonar.beam_width_across.rad();
    Piece p{at - 0.5 * size * std::max(width, angles[l] - angles[l - 1]),
            at + 0.5 * size * std::max(width, angles[r] - angles[r - 1]),
            h.range_m * tan(sonar.beam_width_along / 2.0)};
    if (!result.empty() && result.back().right > p.left) {
      p.left = std::clamp(0.5 * (before + at), p.left, result.back().right);
      result.back().right = p.left;
    }
    before = at;
    result.push_back(p);
  }
  return result;
}

/// 1 covered, 0 not, -1 too near an edge for floats to be asked.
class Expected {
 public:
  explicit Expected(const CoverageGrid& grid) : grid_(grid), state_(grid.words().size(), 0) {}

  void add(const Ping& ping, const std::vector<Piece>& all) {
    const Vec2 starboard(ping.course.y(), -ping.course.x());
    double longest = 0.0;
    for (const Piece& p : all) longest = std::max(longest, p.half_along);
    for (std::size_t i = 0; i < state_.size(); ++i) {
      if (state_[i] == 1) continue;
      const Vec2 d = grid_.centre(static_cast<std::uint32_t>(i % grid_.columns()),
                                  static_cast<std::uint32_t>(i / grid_.columns())) -
                     ping.position;
      if (std::abs(d.dot(ping.course)) > longest + kNear) continue;  // no piece is that long
      for (const Piece& p : all) add(i, d.dot(ping.course), d.dot(starboard), p);
    }
  }
  [[nodiscard]] const std::vector<int>& state() const { return state_; }

 private:
  static constexpr double kNear = 1e-4;  // metres

  void add(std::size_t i, double u, double v, const Piece& p) {
    const double room = std::min({p.half_along - std::abs(u), v - p.left, p.right - v});
    if (room > kNear) state_[i] = 1;
    if (std::abs(room) <= kNear && state_[i] == 0) state_[i] = -1;
  }

  const CoverageGrid& grid_;
  std::vector<int> state_;
};

void compare(const TestGround& g, const Route& route, const Sonar& sonar, double resolution,
             double spacing) {
  ScoreOptions options;
  options.resolution_m = resolution;
  options.pings.spacing_m = spacing;
  const Vehicle vehicle;
  const ScoredRoute scored = score(route, g.ground, sonar, vehicle, options);
  Expected expected(scored.grid);
  PingWalker walker(route, sonar, {.spacing_m = spacing}, {});
  std::vector<Ping> pings;
  while (walker.next(100, pings)) {
    for (const Ping& p : pings) expected.add(p, pieces(p, g.scene, sonar, vehicle.draft_m));
  }
  std::size_t covered = 0;
  std::size_t unsure = 0;
  for (std::size_t i = 0; i < expected.state().size(); ++i) {
    const int state = expected.state()[i];
    covered += state == 1;
    unsure += state == -1;
    if (state == -1 || !scored.grid.counts(i)) continue;
    EXPECT_EQ(scored.grid.footprint(i), state == 1) << i;
  }
  EXPECT_GT(covered, expected.state().size() / 20);
  EXPECT_LT(covered, expected.state().size());
  EXPECT_LT(unsure, expected.state().size() / 100 + 2);
}

Route star(const Vec2& centre, double reach, double half_deg) {
  std::vector<Vec2> points;
  for (const double azimuth : {0.0, 200.0, 45.0, 230.0, 90.0, 285.0, 130.0}) {
    const double a = Angle::degrees(azimuth).rad();
    points.push_back(centre + reach * Vec2(std::sin(a), std::cos(a)));
  }
  return route_through(points, {Angle::degrees(half_deg), Angle::degrees(half_deg * 0.8)});
}

TEST(Footprint, MatchesALoopOverAllBeamsOnAFlatFloor) {
  const TestGround g(flat(60, 60, 10), Nodata::wall, testing::rectangle(5, 5, 55, 55));
  Sonar sonar;
  sonar.beams = 32;
  compare(g, star({30, 30}, 12, 25), sonar, 0.31, 0.7);
}

TEST(Footprint, MatchesALoopOverAllBeamsOnASlope) {
  const TestGround g(tilted(60, 60, 5, Angle::degrees(35)), Nodata::wall,
                     testing::rectangle(5, 5, 55, 55));
  Sonar sonar;
  sonar.beams = 48;
  compare(g, star({30, 30}, 12, 35), sonar, 0.23, 1.3);
}

TEST(Footprint, MatchesALoopOverAllBeamsOverWallsAndHoles) {
  const TestGround g(testing::rough_floor(40, 0.15, 4, {0, 0}), Nodata::wall,
                     testing::rectangle(0, 0, 39, 39));
  Sonar sonar;
  sonar.beams = 64;
  compare(g, star({20, 20}, 12, 55), sonar, 0.17, 1.1);
}

TEST(Footprint, DoesNotBridgeAShadow) {
  // East of the step lie 30 m of shadow (see the ray tests): no footprint in its middle.
  const TestGround g(stepped(200, 100, 5, 20), Nodata::open, testing::rectangle(0, 0, 200, 100));
  const Route route = route_through({{90, 20}, {90, 80}}, {Angle::degrees(70), Angle::degrees(80)});
  Vehicle vehicle;
  vehicle.draft_m = 0;
  const ScoredRoute s = score(route, g.ground, {}, vehicle, {});
  const auto covered = [&](double x) {
    return s.grid.footprint(500 * std::size_t{s.grid.columns()} +
                            static_cast<std::size_t>(x / 0.1));
  };
  EXPECT_TRUE(covered(95));
  EXPECT_FALSE(covered(110));
  EXPECT_FALSE(covered(120));
  EXPECT_TRUE(covered(135));
}

TEST(Footprint, ASinglePassOverFlatGroundLeavesNoGapBetweenBeams) {
  const TestGround g(flat(100, 100, 5), Nodata::wall, testing::rectangle(38, 30, 62, 70));
  const double half = std::atan(12.8 / 4.7) * 180 / M_PI;
  Sonar narrow;
  narrow.beam_width_across = Angle::degrees(0.01);
  const Score s =
      score(route_through({{50, 20}, {50, 80}}, {Angle::degrees(half), Angle::degrees(half)}),
            g.ground, narrow, {}, {})
          .score;
  EXPECT_LT(s.all.hit_pct, 90);
  EXPECT_EQ(s.all.footprint_pct, 100.0);
}

}  // namespace
}  // namespace swathplan
