#include "planners/adaptive/accordion_scan.h"

#include <cmath>
#include <numbers>

#include "mesh/base/error.h"
#include "mesh/base/random.h"

namespace swathplan {
namespace {

constexpr int kDraws = 1000;
// A ray to an object's top may end on the facet in front of it.
constexpr double kSightSlack = 0.3;
// The gap filler reaches this far beyond the nadir gap. Near the gap's edge the side-scan image is
// steep, shadows are short, and half an object may be cut off.
constexpr double kFillerOverlap = 3.0;

DroppedObject object_of_kind(int kind) {
  switch (kind % 3) {
    case 0:
      return {.shape = ObjectShape::sphere, .size_m = 1.0, .length_m = 1.0};
    case 1:
      return {.shape = ObjectShape::cylinder, .size_m = 0.6, .length_m = 2.0};
    default:
      return {.shape = ObjectShape::box, .size_m = 0.8, .length_m = 1.2};
  }
}

SideScanSonar sonar_for(const AccordionOptions& options, const ScanWorld& world, int track) {
  SideScanSonar sonar = world.sonar;
  sonar.range_m = sonar_range_m(options);
  sonar.nadir_gap_m = options.nadir_gap_m;
  sonar.seed = mixed_seed(world.sonar.seed, static_cast<std::uint64_t>(track));
  return sonar;
}

Vec2 end_of(const SurveyBox& box, const SurveyTrack& track, bool start) {
  return box_point(box, track.across_m, track.outbound == start ? 0.0 : box.length_m);
}

// Box coordinates of a place: across and along.
Vec2 in_box(const SurveyBox& box, const Vec2& p) {
  const Vec2 origin = box_point(box, 0.0, 0.0);
  const Vec2 across = box_point(box, 1.0, 0.0) - origin;
  const Vec2 along = box_point(box, 0.0, 1.0) - origin;
  return {(p - origin).dot(across), (p - origin).dot(along)};
}

bool in_sight(const RayScene& scene, const Vec3& eye, const Vec3& target) {
  const Vec3 way = target - eye;
  const Eigen::Vector3f direction = way.normalized().cast<float>();
  RayHit hit;
  scene.trace(eye, {&direction, 1}, {&hit, 1});
  return hit.range_m > 0.0F && hit.range_m > way.norm() - kSightSlack;
}

}  // namespace

std::vector<DroppedObject> dropped_objects(const SurveyBox& box, int count, double margin_m,
                                           const DepthQuery& depths, std::uint64_t seed) {
  if (2.0 * margin_m >= std::min(box.width_m, box.length_m)) {
    throw InvalidInput("the box is too small to drop objects inside its margin; widen it");
  }
  SeededNumbers numbers(mixed_seed(seed, 11));
  std::vector<DroppedObject> objects;
  int misses = 0;
  while (static_cast<int>(objects.size()) < count) {
    const double across = margin_m + (box.width_m - 2.0 * margin_m) * numbers.uniform();
    const double along = margin_m + (box.length_m - 2.0 * margin_m) * numbers.uniform();
    const double turn = numbers.uniform();
    const Vec2 at = box_point(box, across, along);
    const auto depth = depths.depth(at);
    if (!depth) {
      if (++misses >= kDraws) {
        throw InvalidInput("no seafloor was found in the box to drop objects on; move the box");
      }
      continue;
    }
    misses = 0;
    DroppedObject object = object_of_kind(static_cast<int>(objects.size()));
    object.base = {at.x(), at.y(), -*depth};
    object.heading = Angle::radians(std::numbers::pi * turn);
    objects.push_back(object);
  }
  return objects;
}

AccordionState sail(const AccordionOptions& options, const ScanWorld& world,
                    const std::function<void(const ScannedTrack&)>& each) {
  AccordionState state = start_accordion(options);
  CostMapOptions cost = world.cost;
  cost.threshold = options.threshold;
  while (const auto track = next_track(state)) {
    const SideScanSonar sonar = sonar_for(options, world, track->number);
    const Vec2 from = end_of(world.box, *track, true);
    const Vec2 to = end_of(world.box, *track, false);
    const bool port_back = port_looks_back(world.box, *track);
    ScannedTrack scanned{
        *track, side_scan_image(*world.scene, from, to, world.depth_below, sonar), {}};
    scanned.observation = cost_maps(scanned.image, port_back, cost);
    if (world.fill_nadir && options.nadir_gap_m > 0.0) {
      fill_nadir(scanned.observation,
                 nadir_heights(*world.scene, from, to, world.depth_below,
                               options.nadir_gap_m + kFillerOverlap, sonar),
                 port_back, cost);
    }
    if (each) each(scanned);
    state = observe(std::move(state), *track, scanned.observation);
  }
  return state;
}

std::vector<ObjectSights> sights(const std::vector<DroppedObject>& objects,
                                 const std::vector<SurveyTrack>& tracks,
                                 const AccordionOptions& options, const ScanWorld& world) {
  std::vector<ObjectSights> result(objects.size());
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const Vec3 target = top(objects[i]);
    const Vec2 place = in_box(world.box, target.head<2>());
    for (const SurveyTrack& track : tracks) {
      const double aside = std::abs(place.x() - track.across_m);
      if (aside < options.nadir_gap_m || aside > sonar_range_m(options)) continue;
      const Vec2 at = box_point(world.box, track.across_m, place.y());
      const double z = sonar_height_m(world.depth_below(at), world.sonar);
      if (!in_sight(*world.scene, {at.x(), at.y(), z}, target)) continue;
      (track.across_m < place.x() ? result[i].from_below : result[i].from_above) = true;
    }
  }
  return result;
}

}  // namespace swathplan
