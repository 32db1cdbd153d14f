// The bounded accordion: a track skips no farther than the worst case allows. Its invariant: take
// the way sailed so far, and add an overlapping lawnmower over the rest of the area. The sum is
// never longer than the lawnmower over the whole area by more than one track and its connector.
#include <algorithm>
#include <cmath>

#include "planners/adaptive/accordion_bounded_internal.h"

namespace swathplan {
namespace {

constexpr double kSameTrack = 1e-6;  // tracks nearer than a micrometre are one track

// The prior share of strips with objects: 0.5 of 2 strips, a mean of a quarter. A skip pays while
// at most a third of the strips hold objects (alpha <= 1), so that a mission begins with skips.
constexpr double kPriorWith = 0.5;
constexpr double kPriorAll = 2.0;

double position(const AccordionState& state) {
  return state.sailed.empty() ? 0.0 : state.sailed.back().across_m;
}

// Before the first track, the rule behaves as if a track lay one strip outside the start edge.
double front(const AccordionState& state) {
  return state.sailed.empty() ? -state.options.spacing_m : state.front_m;
}

double lawnmower_length_m(const AccordionOptions& o, double from) {
  const double rest = o.width_m - from;
  if (rest < kSameTrack) return 0.0;
  return rest + std::ceil(rest / o.spacing_m - kSameTrack) * o.length_m;
}

// The worst outcome of a skip to `next`: a loop back to the strip's edge, then a lawnmower.
double worst_length_m(const AccordionState& state, double next) {
  const AccordionOptions& o = state.options;
  const double unseen = next - front(state) - o.spacing_m + o.clearance_m;
  return state.sailed_m + std::abs(next - position(state)) + o.length_m + 2.0 * unseen +
         o.length_m + lawnmower_length_m(o, next);
}

bool stays_in_bound(const AccordionState& state, double next) {
  const AccordionOptions& o = state.options;
  const double lawnmower = o.length_m + lawnmower_length_m(o, 0.0);
  return worst_length_m(state, next) <= lawnmower + o.length_m + o.spacing_m + kSameTrack;
}

// A skip over the share s of a strip saves s tracks if it succeeds. If it fails, it costs the rest
// of a track and a loop.
bool pays(const AccordionState& state, double next) {
  const AccordionOptions& o = state.options;
  const double s = (next - front(state) - o.spacing_m) / o.spacing_m;
  const double share = (state.strips_with_objects + kPriorWith) / (state.strips_seen + kPriorAll);
  const double failing = std::min(1.0, s * share);
  const double loop = (state.loops_m + 2.0 * o.spacing_m) / (state.loops + 1);
  return (1.0 - failing) * s * o.length_m >= failing * ((1.0 - s) * o.length_m + s * loop);
}

bool waits(const AccordionState& state, const Interval& o) {
  return o.high > state.front_m - state.options.nadir_gap_m && !state.seen_from_above.covers(o);
}

// The farthest track that still sees every object ahead from its far side.
double farthest_look(const AccordionState& state) {
  double result = front(state) + 2.0 * state.options.spacing_m;
  for (const Interval& o : state.pending) {
    if (!waits(state, o)) continue;
    result = std::min(result, state.seen_from_above.run_end(o.low) + sonar_range_m(state.options) -
                                  state.options.clearance_m);
  }
  return std::max(result, front(state) + state.options.spacing_m);
}

// How far back a loop has to see for an object: to the object's near edge. Where images place
// objects only roughly, one look may find what another did not. The loop then sees back to the end
// of what was seen from below, so that no second loop follows.
double loop_edge(const AccordionState& state, const Interval& object) {
  const AccordionOptions& o = state.options;
  if (o.clearance_m == 0.0) return state.seen_from_below.run_end(object.low);
  double end = 0.0;
  for (const Interval& s : state.seen_from_below.stretches()) {
    if (s.high <= object.low + kSameTrack || s.low <= object.low) end = std::max(end, s.high);
  }
  return end - std::min(o.clearance_m, o.nadir_gap_m);
}

// The first loop after a skip always stays in the bound. Contradicting looks may ask for further
// loops; these must not break it.
bool loop_stays_in_bound(const AccordionState& state, double back) {
  const AccordionOptions& o = state.options;
  const double whole = o.length_m + lawnmower_length_m(o, 0.0) + o.length_m + o.spacing_m;
  const double way = std::abs(position(state) - back) + o.length_m + state.front_m - back;
  return state.sailed_m + way + lawnmower_length_m(o, state.front_m) <= whole + kSameTrack;
}

// Whether a lawnmower from `next` on would still end within the bound. Objects that are not seen
// yet may ask for one.
bool lawnmower_stays_in_bound(const AccordionState& state, double next) {
  const AccordionOptions& o = state.options;
  const double whole = o.length_m + lawnmower_length_m(o, 0.0) + o.length_m + o.spacing_m;
  const double way = std::abs(next - position(state)) + o.length_m;
  return state.sailed_m + way + lawnmower_length_m(o, next) <= whole + kSameTrack;
}

// Nearest track beyond every object ahead; `none` where no object waits.
double beyond_objects(const AccordionState& state, double none) {
  double result = none;
  for (const Interval& o : state.pending) {
    if (!waits(state, o)) continue;
    result = std::max(result, o.high + state.options.nadir_gap_m + state.options.clearance_m);
  }
  return result;
}

}  // namespace

double bounded_start(const AccordionState& state) {
  const AccordionOptions& o = state.options;
  const double inside = std::min(o.spacing_m, o.width_m - o.spacing_m);
  if (inside < kSameTrack) return 0.0;
  return pays(state, inside) && stays_in_bound(state, inside) ? inside : 0.0;
}

std::optional<double> bounded_loop_back(const AccordionState& state) {
  const AccordionOptions& o = state.options;
  const double blind = state.front_m + o.nadir_gap_m;
  std::optional<double> back;
  double nearest = 0.0;  // no farther back than this, or the farthest object is out of range
  double farthest =
      state.front_m;  // no farther ahead than this, or an object lies in the loop's own nadir gap
  for (const Interval& object : state.pending) {
    // No later track can see from below what lies in the nadir gap ahead of the last track.
    if (object.low >= blind || state.seen_from_below.covers(object)) continue;
    const double edge = loop_edge(state, object) - o.nadir_gap_m;
    back = std::max(0.0, back ? std::min(*back, edge) : edge);
    nearest = std::max(nearest, std::min(object.high, blind) - sonar_range_m(o));
    farthest = std::min(farthest, state.seen_from_below.run_end(object.low) - o.nadir_gap_m);
  }
  if (!back) return std::nullopt;
  back = std::max(*back, std::min(nearest, farthest));
  if (*back > state.front_m - kSameTrack) return std::nullopt;
  const bool been_there = std::abs(position(state) - *back) < kSameTrack;
  return been_there || !loop_stays_in_bound(state, *back) ? std::nullopt : back;
}

double bounded_step(const AccordionState& state) {
  const AccordionOptions& o = state.options;
  const double rest = o.width_m - state.front_m;
  if (rest <= o.spacing_m + kSameTrack) {
    // A track at the far edge is certainly the last one. A nearer track may find another object
    // ahead.
    const double nearest = std::min(beyond_objects(state, o.width_m - o.spacing_m), o.width_m);
    return lawnmower_stays_in_bound(state, nearest) ? nearest : o.width_m;
  }
  const double one = state.front_m + o.spacing_m;
  if (rest <= 2.0 * o.spacing_m + kSameTrack) {
    // One track within a strip of the edge sees all the rest, and the objects ahead as well.
    return std::min(one, beyond_objects(state, o.width_m - o.spacing_m));
  }
  const double far = farthest_look(state);
  const bool skip = far > one + kSameTrack && pays(state, far) && stays_in_bound(state, far);
  return skip ? far : one;
}

}  // namespace swathplan
