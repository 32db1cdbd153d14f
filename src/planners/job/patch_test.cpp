#include "planners/job/patch_test.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "mesh/plane/area_query.h"
#include "mesh/plane/box.h"

namespace swathplan {
namespace {

// What practice asks of a place (docs/job.md has the sources).
constexpr double kFlatDeg = 2.0;        // roll: slope of the ground below the swath
constexpr double kSmoothShare = 0.02;   // ... and its roughness, share of the depth
constexpr double kRollLengths = 5.0;    // ... and the line's length, depths
constexpr double kSlopeDeg = 10.0;      // pitch, latency, yaw: a slope, over half a depth
constexpr double kObjectShare = 0.05;   // ... or an object that rises this share of the depth
constexpr double kObjectM = 0.5;        // ... and this much
constexpr double kLeastSlopeDeg = 3.0;  // less is no ground for these tests at all
constexpr double kWorkableDeg = 35.0;   // steeper ground is worth no more: it hides itself
constexpr double kSlopeLengths = 4.0;   // length of these lines, depths
constexpr double kNearNadirDeg = 30.0;  // yaw: the outer beams are those between these angles
constexpr double kFarNadirDeg = 60.0;
constexpr double kMostHalfDeg = 65.0;    // half-angle of the fans, as far as the sonar goes
constexpr double kSlowShare = 0.5;       // latency: the slow pass, share of the speed
constexpr double kUsedShare = 0.9;       // of a swath; its rim is poorly sounded
constexpr int kLattice = 48;             // places along the longer side of the site
constexpr std::size_t kMostTried = 300;  // places of each kind that are looked at for room

/// Where a line may lie.
struct PatchPlace {
  Vec2 middle = Vec2::Zero(), course = Vec2::UnitY();
  double length_m = 0.0, depth_m = 0.0, worth = 0.0;
  double slope_deg = 0.0, rough_m = 0.0, known = 0.0;  // roll: what lies below the swath
  double along_deg = 0.0, rise_m = 0.0;                // the others: slope along, object
  double target_m = 0.0;                               // where along the line, from the middle
  [[nodiscard]] Vec2 from() const { return middle - 0.5 * length_m * course; }
  [[nodiscard]] Vec2 to() const { return middle + 0.5 * length_m * course; }
  [[nodiscard]] Vec2 target() const { return middle + target_m * course; }
  [[nodiscard]] Vec2 aside() const { return {course.y(), -course.x()}; }
};

double degrees_of(double gradient) {
  return std::atan(std::abs(gradient)) * 180.0 / std::numbers::pi;
}
double tangent_of(double degrees) { return std::tan(degrees * std::numbers::pi / 180.0); }

class PatchSearch {
 public:
  PatchSearch(const Ground& ground, const PlanOptions& options, const Connector& connector)
      : depths_(*ground.depths),
        connector_(connector),
        options_(options),
        area_(reachable_area(ground)),
        query_(area_),
        half_(Angle::degrees(std::min(kMostHalfDeg, 0.5 * options.sonar.max_opening.deg()))) {
    const Box2 box = extent(area_);
    step_ = box.size().maxCoeff() / kLattice;
    for (double y = box.min.y() + 0.5 * step_; y < box.max.y(); y += step_) {
      for (double x = box.min.x() + 0.5 * step_; x < box.max.x(); x += step_) {
        if (query_.contains({x, y}) && depths_.depth({x, y})) middles_.emplace_back(x, y);
      }
    }
  }

  [[nodiscard]] Angle half() const { return half_; }
  [[nodiscard]] double below(double depth_m) const {
    return std::max(0.5, depth_m - options_.vehicle.draft_m);
  }
  [[nodiscard]] double roll_length(double depth_m) const {
    return std::clamp(2.0 * kRollLengths * depth_m, 40.0, 1000.0);
  }
  [[nodiscard]] double slope_length(double depth_m) const {
    return std::clamp(1.5 * kSlopeLengths * depth_m, 40.0, 600.0);
  }

  /// The flattest deep place, best first as far as room goes.
  [[nodiscard]] std::optional<PatchPlace> flat() const {
    std::vector<PatchPlace> places;
    each_line([&](double d) { return roll_length(d); },
              [&](PatchPlace& place) {
                look_below_swath(place);
                const double steep = place.slope_deg / (0.5 * kFlatDeg);
                const double rough = place.rough_m / (0.5 * kSmoothShare * place.depth_m);
                place.worth = place.depth_m * place.known * place.known /
                              (1.0 + steep * steep + rough * rough);
                places.push_back(place);
              });
    return first_with_room(places, [](const PatchPlace&) { return true; });
  }

  /// Lines over slopes and objects, the best first.
  [[nodiscard]] std::vector<PatchPlace> steep() const {
    std::vector<PatchPlace> places;
    each_line([&](double d) { return slope_length(d); },
              [&](PatchPlace& place) {
                look_along(place);
                if (!is_ground_for_slopes(place)) return;
                place.worth = worth_of_slope(place);
                places.push_back(place);
              });
    best_first(places);
    return places;
  }

  template <class Accept>
  [[nodiscard]] std::optional<PatchPlace> first_with_room(std::vector<PatchPlace>& places,
                                                          Accept accept) const {
    best_first(places);
    std::size_t tried = 0;
    for (const PatchPlace& place : places) {
      if (++tried > kMostTried) break;
      if (accept(place) && has_room(place, 0.0)) return place;
    }
    return std::nullopt;
  }

  /// Whether the line, moved `aside_m` to starboard, lies in the water with room to turn onto it.
  [[nodiscard]] bool has_room(const PatchPlace& place, double aside_m) const {
    const Vec2 shift = aside_m * place.aside();
    return in_water(place.from() + shift, place.to() + shift) &&
           connector_.has_room({place.from() + shift, place.to() + shift});
  }

  /// How far beside a slope or object two lines may lie, so that the outer beams of both see it.
  [[nodiscard]] std::optional<double> beside(const PatchPlace& place) const {
    const double d = below(place.depth_m);
    const double most = kUsedShare * d * tan(half_);
    for (const double share : {1.0, 0.85, 1.2, 0.7, 1.4, 0.6}) {
      const double offset = share * d;
      if (offset > most || !has_room(place, offset) || !has_room(place, -offset)) continue;
      if (!target_seen(place)) continue;
      return offset;
    }
    return std::nullopt;
  }

 private:
  static bool is_ground_for_slopes(const PatchPlace& p) {
    return p.along_deg >= kLeastSlopeDeg || p.rise_m >= std::max(0.2, 0.02 * p.depth_m);
  }
  static double worth_of_slope(const PatchPlace& p) {
    const double slope = tangent_of(std::min(p.along_deg, kWorkableDeg));
    const double object = 0.5 * std::min(1.0, p.rise_m / std::max(kObjectM, 0.1 * p.depth_m));
    // A slope aside moves the nadir beam up or down with every metre off the line.
    return p.depth_m * (slope + object) / (1.0 + p.slope_deg / kSlopeDeg);
  }

  static void best_first(std::vector<PatchPlace>& places) {
    std::stable_sort(places.begin(), places.end(),
                     [](const PatchPlace& a, const PatchPlace& b) { return a.worth > b.worth; });
  }

  [[nodiscard]] bool in_water(const Vec2& a, const Vec2& b) const {
    constexpr double kDust = 1e-6;
    return query_.inside_length(a, b) >= (b - a).norm() - kDust;
  }

  [[nodiscard]] bool target_seen(const PatchPlace& p) const {
    return depths_.depth(p.target()).has_value();
  }

  template <class Length, class Use>
  void each_line(Length length, Use use) const {
    for (const Vec2& middle : middles_) {
      PatchPlace place;
      place.middle = middle;
      place.depth_m = *depths_.depth(middle);
      for (int k = 0; k < kPatchHeadings; ++k) {
        const double azimuth = std::numbers::pi * k / kPatchHeadings;
        place.course = {std::sin(azimuth), std::cos(azimuth)};
        place.length_m = length(place.depth_m);
        if (in_water(place.from(), place.to())) use(place);
      }
    }
  }

  /// Fits a plane to the depths below the swath of the whole line.
  void look_below_swath(PatchPlace& place) const {
    constexpr int kAlong = 10, kAcross = 4;
    const double reach = kUsedShare * below(place.depth_m) * tan(half_);
    std::vector<Vec3> found;  // along, across, depth
    int asked = 0;
    for (int i = -kAlong; i <= kAlong; ++i) {
      for (int j = -kAcross; j <= kAcross; ++j) {
        const double s = 0.5 * place.length_m * i / kAlong;
        const double t = reach * j / kAcross;
        ++asked;
        const auto depth = depths_.depth(place.middle + s * place.course + t * place.aside());
        if (depth) found.emplace_back(s, t, *depth);
      }
    }
    place.known = static_cast<double>(found.size()) / asked;
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Vec3 right = Vec3::Zero();
    for (const Vec3& p : found) {
      const Vec3 row(1.0, p.x(), p.y());
      normal += row * row.transpose();
      right += p.z() * row;
    }
    const Vec3 plane = normal.ldlt().solve(right);
    if (found.size() < 4 || !plane.allFinite()) {
      place.known = 0.0;
      return;
    }
    double squares = 0.0;
    for (const Vec3& p : found) {
      const double off = p.z() - plane[0] - plane[1] * p.x() - plane[2] * p.y();
      squares += off * off;
    }
    place.rough_m = std::sqrt(squares / static_cast<double>(found.size()));
    place.slope_deg = degrees_of(std::hypot(plane[1], plane[2]));
  }

  /// The steepest half depth and the highest rise in the middle part of the line, near nadir.
  void look_along(PatchPlace& place) const {
    const double span = std::max(1.0, 0.5 * place.depth_m);
    const double step = 0.5 * span;
    const double reach = 0.3 * place.length_m;
    double best = 0.0;
    for (double s = -reach; s <= reach; s += step) {
      const Vec2 at = place.middle + s * place.course;
      const auto here = depths_.depth(at);
      const auto before = depths_.depth(at - 0.5 * span * place.course);
      const auto after = depths_.depth(at + 0.5 * span * place.course);
      const auto port = depths_.depth(at - 0.5 * span * place.aside());
      const auto starboard = depths_.depth(at + 0.5 * span * place.aside());
      if (!here || !before || !after || !port || !starboard) continue;
      PatchPlace found = place;
      found.along_deg = degrees_of((*after - *before) / span);
      found.rise_m = std::max(0.0, std::min(*before, *after) - *here);
      found.slope_deg = degrees_of((*starboard - *port) / span);
      found.target_m = s;
      const double worth = worth_of_slope(found);
      if (worth <= best) continue;
      best = worth;
      place = found;
    }
  }

  const DepthQuery& depths_;
  const Connector& connector_;
  const PlanOptions& options_;
  Area area_;
  AreaQuery query_;
  Angle half_;
  double step_ = 1.0;
  std::vector<Vec2> middles_;
};

PatchCondition condition(std::string what, std::string asks, std::string figure, bool met) {
  return {std::move(what), std::move(asks), std::move(figure), met};
}

PatchCondition slope_condition(const PatchPlace& p) {
  const double object = std::max(kObjectM, kObjectShare * p.depth_m);
  return condition("slope along the line, over half a depth, or an object",
                   fmt::format("at least {:g} degrees, or a rise of {:.1f} m", kSlopeDeg, object),
                   fmt::format("{:.1f} degrees, a rise of {:.1f} m", p.along_deg, p.rise_m),
                   p.along_deg >= kSlopeDeg || p.rise_m >= object);
}

PatchCondition length_condition(const PatchPlace& p, double depths) {
  return condition("length of the line", fmt::format("at least {:g} depths", depths),
                   fmt::format("{:.1f} depths ({:.0f} m)", p.length_m / p.depth_m, p.length_m),
                   p.length_m >= depths * p.depth_m);
}

std::string object_or_slope(const PatchPlace& p) {
  return p.along_deg >= kSlopeDeg || p.rise_m < kObjectM
             ? fmt::format("a slope of {:.1f} degrees in {:.1f} m of water", p.along_deg, p.depth_m)
             : fmt::format("an object that rises {:.1f} m in {:.1f} m of water", p.rise_m,
                           p.depth_m);
}

/// Puts passes into the plan, numbered in sailing order.
class PatchBuilder {
 public:
  PatchBuilder(const PlanOptions& options, Angle half, int first_number)
      : options_(options), half_(half), next_(first_number) {}

  int pass(const Vec2& from, const Vec2& to, double speed_mps) {
    Waypoint w;
    w.kind = LegKind::patch;
    w.line = next_;
    w.fan = FanAngles{half_, half_};
    w.speed_mps = speed_mps;
    JobLine line{{w, w}, {}};
    line.points[0].position = from;
    line.points[1].position = to;
    plan_.lines.push_back(std::move(line));
    return next_++;
  }
  void use(PatchTest& test, int number) const {
    for (const JobLine& line : plan_.lines) {
      if (line.points[0].line != number) continue;
      test.lines.push_back(number);
      test.passes.emplace_back(line.points[0].position, line.points[1].position);
      test.speeds_mps.push_back(line.points[0].speed_mps);
    }
  }
  void add(PatchTest test) { plan_.tests.push_back(std::move(test)); }
  [[nodiscard]] double speed() const { return options_.vehicle.speed_mps; }
  [[nodiscard]] PatchTestPlan plan() { return std::move(plan_); }

 private:
  const PlanOptions& options_;
  Angle half_;
  int next_;
  PatchTestPlan plan_;
};

PatchTest nowhere(const std::string& name, const std::string& why) {
  PatchTest test;
  test.name = name;
  test.reason = why;
  return test;
}

const char* const kNoSlope =
    "no line of the length that it takes crosses a slope of 3 degrees or an object and has room to "
    "turn: choose ground with a slope of 10 to 20 degrees";

void add_latency_and_pitch(const PatchSearch& search, const std::optional<PatchPlace>& place,
                           PatchBuilder& builder) {
  if (!place) {
    builder.add(nowhere("latency", kNoSlope));
    builder.add(nowhere("pitch", kNoSlope));
    return;
  }
  const double slow = kSlowShare * builder.speed();
  const int up = builder.pass(place->from(), place->to(), builder.speed());
  const int back = builder.pass(place->to(), place->from(), builder.speed());
  const int again = builder.pass(place->from(), place->to(), slow);
  const double slope = tangent_of(std::min(place->along_deg, kWorkableDeg));
  PatchTest latency;
  latency.name = "latency";
  latency.depth_m = place->depth_m;
  latency.reason =
      fmt::format("over {}: 0.1 s of latency moves the depths of the two passes {:.3f} m apart",
                  object_or_slope(*place), 0.1 * (builder.speed() - slow) * slope);
  builder.use(latency, up);
  builder.use(latency, again);
  latency.conditions = {slope_condition(*place), length_condition(*place, kSlopeLengths),
                        condition("speeds of the passes", "one at most half of the other",
                                  fmt::format("{:g} and {:g} m/s", builder.speed(), slow), true)};
  PatchTest pitch;
  pitch.name = "pitch";
  pitch.depth_m = place->depth_m;
  pitch.reason = fmt::format(
      "over {}: 1 degree of pitch moves the depths of the two passes {:.2f} m apart",
      object_or_slope(*place), 2.0 * search.below(place->depth_m) * tangent_of(1.0) * slope);
  builder.use(pitch, up);
  builder.use(pitch, back);
  pitch.conditions = {slope_condition(*place), length_condition(*place, kSlopeLengths),
                      condition("slope across the line", "at most that along it",
                                fmt::format("{:.1f} degrees", place->slope_deg),
                                place->slope_deg <= place->along_deg)};
  builder.add(std::move(latency));
  builder.add(std::move(pitch));
}

void add_roll(const PatchSearch& search, const std::optional<PatchPlace>& place,
              PatchBuilder& builder) {
  if (!place) {
    builder.add(
        nowhere("roll", "no straight line of ten depths lies in safe water with room to turn"));
    return;
  }
  PatchTest roll;
  roll.name = "roll";
  roll.depth_m = place->depth_m;
  const double edge = search.below(place->depth_m) * tan(search.half());
  roll.reason = fmt::format(
      "flat ground in {:.1f} m of water: 0.1 degrees of roll move the depths at the swath's edge "
      "{:.3f} m apart",
      place->depth_m, 2.0 * edge * tangent_of(0.1));
  builder.use(roll, builder.pass(place->from(), place->to(), builder.speed()));
  builder.use(roll, builder.pass(place->to(), place->from(), builder.speed()));
  roll.conditions = {
      condition("slope below the swath", fmt::format("at most {:g} degrees", kFlatDeg),
                fmt::format("{:.2f} degrees", place->slope_deg), place->slope_deg <= kFlatDeg),
      condition("roughness below the swath",
                fmt::format("at most {:g} % of the depth", 100.0 * kSmoothShare),
                fmt::format("{:.2f} %", 100.0 * place->rough_m / place->depth_m),
                place->rough_m <= kSmoothShare * place->depth_m),
      condition("swath on known ground", "at least 95 %",
                fmt::format("{:.0f} %", 100 * place->known), place->known >= 0.95),
      length_condition(*place, kRollLengths)};
  builder.add(std::move(roll));
}

void add_yaw(const PatchSearch& search, const std::optional<PatchPlace>& place, double offset,
             PatchBuilder& builder) {
  if (!place) {
    builder.add(nowhere("yaw",
                        "no slope or object has room for a line on either side of it, so near that "
                        "the outer beams of both see it"));
    return;
  }
  const Vec2 aside = offset * place->aside();
  PatchTest yaw;
  yaw.name = "yaw";
  yaw.depth_m = place->depth_m;
  const double d = search.below(place->depth_m);
  const double angle = std::atan(offset / d) * 180.0 / std::numbers::pi;
  const double slope = tangent_of(std::min(place->along_deg, kWorkableDeg));
  yaw.reason = fmt::format(
      "on either side of {}, {:.0f} m off it: 1 degree of yaw moves the depths of the two passes "
      "{:.2f} m apart",
      object_or_slope(*place), offset, 2.0 * offset * tangent_of(1.0) * slope);
  builder.use(yaw, builder.pass(place->from() - aside, place->to() - aside, builder.speed()));
  builder.use(yaw, builder.pass(place->from() + aside, place->to() + aside, builder.speed()));
  yaw.conditions = {slope_condition(*place), length_condition(*place, kSlopeLengths),
                    condition("angle from nadir at which both passes see it",
                              fmt::format("{:g} to {:g} degrees", kNearNadirDeg, kFarNadirDeg),
                              fmt::format("{:.0f} degrees", angle),
                              angle >= kNearNadirDeg && angle <= kFarNadirDeg),
                    condition("swaths of the passes", "overlap at it",
                              fmt::format("{:.1f} m", 2.0 * (d * tan(search.half()) - offset)),
                              d * tan(search.half()) > offset)};
  builder.add(std::move(yaw));
}

}  // namespace

bool PatchTest::met() const {
  return !conditions.empty() && std::all_of(conditions.begin(), conditions.end(),
                                            [](const PatchCondition& c) { return c.met; });
}

PatchTestPlan patch_test(const Ground& ground, const PlanOptions& options,
                         const Connector& connector, int first_number) {
  const PatchSearch search(ground, options, connector);
  PatchBuilder builder(options, search.half(), first_number);
  std::vector<PatchPlace> steep = search.steep();
  const auto slope = search.first_with_room(steep, [](const PatchPlace&) { return true; });
  add_latency_and_pitch(search, slope, builder);
  add_roll(search, search.flat(), builder);
  double offset = 0.0;
  const auto beside = search.first_with_room(steep, [&](const PatchPlace& place) {
    const auto found = search.beside(place);
    if (found) offset = *found;
    return found.has_value();
  });
  add_yaw(search, beside, offset, builder);
  return builder.plan();
}

}  // namespace swathplan
