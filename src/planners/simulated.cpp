#include "planners/simulated.h"

#include "coverage/score.h"

namespace swathplan {

Outcome simulated_hits(const Route& route, const Ground& ground, const PlanOptions& options) {
  ScoreOptions how;
  how.resolution_m = options.resolution_m;
  how.pings = options.pings;
  how.footprint = false;
  how.noise = options.noise;
  how.threads = options.threads;
  const Score score = swathplan::score(route, ground, options.sonar, options.vehicle, how).score;
  Outcome outcome;
  outcome.length_ratio = score.route.length_ratio;
  outcome.cover_pct = options.counted == Counted::logged ? score.logged.hit_pct : score.all.hit_pct;
  outcome.turns = score.route.turns;
  outcome.length_m = score.route.length_m;
  outcome.duration_s = score.route.duration_s;
  outcome.infeasible_legs = score.route.infeasible_legs;
  return outcome;
}

}  // namespace swathplan
