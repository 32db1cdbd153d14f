#include "planners/passing/gap_passes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "coverage/judging/out_of_reach.h"
#include "mesh/base/parallel.h"

namespace swathplan {
namespace {

/// Passes are looked for from cells so far apart, metres: those between lie in their swaths.
constexpr double kBetweenSeeds = 3.0;
constexpr std::size_t kMostSeeds = 600;
constexpr int kPassAzimuths = 24;
/// Shares of the widest half-angle that a cell is seen at.
constexpr double kPassAngles[] = {0.1, 0.4, 0.65, 0.8, 0.92};
/// Lengths of passes in least lines, and which share of it lies before the cell.
constexpr double kPassLengths[] = {1.0, 2.5, 6.0};
constexpr double kPassShifts[] = {0.5, 0.3, 0.7, 0.16, 0.84};
/// Of the passes from one cell so many are kept.
constexpr std::size_t kKeptOfSeed = 4;
/// What a pass costs beside its own length before its detour is known, turn radii.
constexpr double kUsualDetourRadii = 6.0;
/// The fan opens so much wider than to the cells that a pass is for.
constexpr double kSpareDeg = 1.0;
constexpr double kBucket = 10.0;
constexpr double kPassDustM = 1e-6;
constexpr double kShortestPass = 1.0;

struct Candidate {
  Vec2 from, to;
  std::vector<std::uint32_t> cells;
  double half_deg = 0.0;  ///< fan to either side
};

double length_of(const Candidate& c) { return (c.to - c.from).norm(); }

class GapPassSearch {
 public:
  GapPassSearch(const std::vector<GapCell>& cells, LineWorkshop& shop,
                const GapPassOptions& options)
      : cells_(cells), shop_(shop), options_(options), left_(cells.size()) {
    const PlanOptions& how = shop.options();
    draft_ = how.vehicle.draft_m;
    widest_ = how.sonar.max_opening.deg() / 2.0;
    least_ = std::max(how.least_line_m, kShortestPass);
    usual_detour_ = kUsualDetourRadii * how.vehicle.turn_radius_m;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      left_[i] = cells[i].lines;
      buckets_[key(cells[i].position)].push_back(static_cast<std::uint32_t>(i));
      deepest_ = std::max(deepest_, cells[i].depth_m - draft_);
    }
    slant_.resize(static_cast<std::size_t>(widest_) + 2);
    for (std::size_t k = 0; k < slant_.size(); ++k) {
      slant_[k] = reach_m(how.sonar, Angle::degrees(static_cast<double>(k)));
    }
  }

  GapPasses run(Itinerary& itinerary) {
    const std::vector<std::uint32_t> seeds = seeds_of();
    std::vector<std::vector<Candidate>> found(seeds.size());
    for_each_index(std::size_t{0}, seeds.size(),
                   [&](std::size_t k) { found[k] = passes_from(cells_[seeds[k]]); });
    std::vector<Candidate> all;
    for (auto& list : found) std::move(list.begin(), list.end(), std::back_inserter(all));
    GapPasses result;
    result.passes = take(std::move(all), itinerary);
    result.cells_left = static_cast<std::size_t>(
        std::count_if(left_.begin(), left_.end(), [](int n) { return n > 0; }));
    return result;
  }

 private:
  using Key = std::pair<long, long>;
  static Key key(const Vec2& p) {
    return {std::lround(std::floor(p.x() / kBucket)), std::lround(std::floor(p.y() / kBucket))};
  }

  /// Cells spread over all gaps, in their order.
  [[nodiscard]] std::vector<std::uint32_t> seeds_of() const {
    std::map<Key, std::uint32_t> first;
    std::vector<std::uint32_t> seeds;
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      const Vec2 at = cells_[i].position / kBetweenSeeds;
      const Key k{std::lround(std::floor(at.x())), std::lround(std::floor(at.y()))};
      if (first.try_emplace(k, static_cast<std::uint32_t>(i)).second) {
        seeds.push_back(static_cast<std::uint32_t>(i));
      }
    }
    // Too many: an even choice of them.
    const std::size_t step = seeds.size() / kMostSeeds + 1;
    std::vector<std::uint32_t> chosen;
    for (std::size_t i = 0; i < seeds.size(); i += step) chosen.push_back(seeds[i]);
    return chosen;
  }

  [[nodiscard]] std::vector<Candidate> passes_from(const GapCell& seed) const {
    std::vector<Candidate> kept;
    const double below = seed.depth_m - draft_;
    if (!(below > 0.0)) return kept;
    for (const double share : kPassAngles) {
      const double away = below * tan(Angle::degrees(share * widest_));
      for (int k = 0; k < kPassAzimuths; ++k) {
        const double azimuth = 2.0 * std::numbers::pi * k / kPassAzimuths;
        const Vec2 across(std::sin(azimuth), std::cos(azimuth));
        const Vec2 boat = seed.position + away * across;
        if (!shop_.lines_in().contains(boat) || !seen(seed, boat, across)) continue;
        best_through(boat, Vec2(across.y(), -across.x()), kept);
      }
    }
    return kept;
  }

  /// Keeps the best passes through a place on a course.
  void best_through(const Vec2& boat, const Vec2& course, std::vector<Candidate>& kept) const {
    for (const double lengths : kPassLengths) {
      const double length = lengths * least_;
      for (const double shift : kPassShifts) {
        Candidate c{boat - shift * length * course, boat + (1.0 - shift) * length * course, {}, 0};
        if (!shop_.lines_in().contains(c.from) || !shop_.lines_in().contains(c.to)) continue;
        if (shop_.lines_in().inside_length(c.from, c.to) < length - kPassDustM) continue;
        look(c);
        if (c.cells.empty()) continue;
        const auto worse = [&](const Candidate& a, const Candidate& b) {
          return rate(a, a.cells.size()) > rate(b, b.cells.size());
        };
        kept.insert(std::upper_bound(kept.begin(), kept.end(), c, worse), std::move(c));
        if (kept.size() > kKeptOfSeed) kept.pop_back();
        break;  // other shifts see about the same
      }
    }
  }

  [[nodiscard]] double rate(const Candidate& c, std::size_t cells) const {
    return static_cast<double>(cells) / (length_of(c) + usual_detour_);
  }

  /// Fills in the cells that a pass sees.
  void look(Candidate& c) const {
    const double length = length_of(c);
    const Vec2 along = (c.to - c.from) / length;
    const Vec2 across(along.y(), -along.x());
    const double far = deepest_ * tan(Angle::degrees(widest_));
    Vec2 low = c.from.cwiseMin(c.to) - Vec2::Constant(far);
    Vec2 high = c.from.cwiseMax(c.to) + Vec2::Constant(far);
    const Key a = key(low);
    const Key b = key(high);
    for (long x = a.first; x <= b.first; ++x) {
      for (long y = a.second; y <= b.second; ++y) {
        const auto bucket = buckets_.find({x, y});
        if (bucket == buckets_.end()) continue;
        for (const std::uint32_t i : bucket->second) {
          const GapCell& cell = cells_[i];
          const double s = (cell.position - c.from).dot(along);
          const double aside = (cell.position - c.from).dot(across);
          const double end =
              options_.end_share * length + std::abs(aside) * tan(options_.unsteady.heading);
          if (s < end || s > length - end || std::abs(aside) > far) continue;
          const Vec2 foot = c.from + s * along;
          if (!seen(cell, foot, aside < 0.0 ? across : Vec2(-across))) continue;
          c.cells.push_back(i);
          const double off = std::abs(aside) + options_.unsteady.aside_m;
          const double angle = std::atan(off / (cell.depth_m - draft_)) * 180.0 / std::numbers::pi;
          c.half_deg = std::max(c.half_deg, angle);
        }
      }
    }
  }

  /// From there, and from as far to either side as the boat is unsteady. `outwards` points from the
  /// cell to the boat.
  [[nodiscard]] bool seen(const GapCell& cell, const Vec2& boat, const Vec2& outwards) const {
    const double below = cell.depth_m - draft_;
    if (!(below > 0.0)) return false;
    const double off = options_.unsteady.aside_m;
    const double away = (boat - cell.position).norm() + off;
    const double degrees = std::atan(away / below) * 180.0 / std::numbers::pi + kSpareDeg;
    if (degrees > widest_ || std::hypot(away, below) > slant_[static_cast<std::size_t>(degrees)]) {
      return false;
    }
    const RayScene& scene = *shop_.ground().scene;
    for (const double side : {0.0, off, -off}) {
      if (!in_sight(scene, boat + side * outwards, draft_, cell.position, cell.depth_m)) {
        return false;
      }
      if (off == 0.0) break;
    }
    return true;
  }

  [[nodiscard]] std::size_t gain(const Candidate& c) const {
    return static_cast<std::size_t>(std::count_if(c.cells.begin(), c.cells.end(),
                                                  [&](std::uint32_t i) { return left_[i] > 0; }));
  }

  [[nodiscard]] bool barred(const Candidate& c) const {
    const Vec2 middle = 0.5 * (c.from + c.to);
    return std::any_of(options_.barred.begin(), options_.barred.end(),
                       [&](const Vec2& p) { return (p - middle).norm() < kBarredM; });
  }

  /// Takes the pass with the most cells a metre, again and again.
  std::size_t take(std::vector<Candidate> all, Itinerary& itinerary) {
    struct Offer {
      double rate;
      std::size_t pass;
    };
    const auto less = [](const Offer& a, const Offer& b) {
      return a.rate != b.rate ? a.rate < b.rate : a.pass > b.pass;
    };
    std::vector<Offer> offers;
    for (std::size_t k = 0; k < all.size(); ++k) {
      offers.push_back({rate(all[k], all[k].cells.size()), k});
    }
    std::make_heap(offers.begin(), offers.end(), less);
    std::size_t passes = 0;
    while (!offers.empty() && passes < options_.most_passes) {
      std::pop_heap(offers.begin(), offers.end(), less);
      Offer offer = offers.back();
      offers.pop_back();
      const Candidate& c = all[offer.pass];
      if (barred(c)) continue;
      const std::size_t cells = gain(c);
      if (cells < std::max<std::size_t>(options_.fewest_cells, 1)) continue;
      const double now = rate(c, cells);
      if (!offers.empty() && now < offers.front().rate) {
        // A bound only shrinks, so the pass waits for its turn.
        offer.rate = now;
        offers.push_back(offer);
        std::push_heap(offers.begin(), offers.end(), less);
        continue;
      }
      if (!shop_.connector().has_room({c.from, c.to})) continue;
      const Itinerary::Place place = itinerary.cheapest(c.from, c.to);
      itinerary.insert(waypoints(c, place.backwards), place.before);
      for (const std::uint32_t i : c.cells) left_[i] = std::max(0, left_[i] - 1);
      ++passes;
      // It may be worth sailing twice.
      offers.push_back(offer);
      std::push_heap(offers.begin(), offers.end(), less);
    }
    return passes;
  }

  [[nodiscard]] std::vector<Waypoint> waypoints(const Candidate& c, bool backwards) const {
    Waypoint point;
    point.kind = LegKind::infill;
    const Angle half = Angle::degrees(std::min(std::ceil(c.half_deg + kSpareDeg), widest_));
    point.fan = FanAngles{half, half};
    point.speed_mps = shop_.options().vehicle.speed_mps;
    std::vector<Waypoint> points(2, point);
    points[0].position = backwards ? c.to : c.from;
    points[1].position = backwards ? c.from : c.to;
    return points;
  }

  const std::vector<GapCell>& cells_;
  LineWorkshop& shop_;
  const GapPassOptions& options_;
  std::vector<int> left_;
  std::map<Key, std::vector<std::uint32_t>> buckets_;
  std::vector<double> slant_;  ///< that the sonar reaches, by whole degrees from nadir
  double draft_ = 0.0, widest_ = 65.0, least_ = 20.0, usual_detour_ = 0.0, deepest_ = 0.0;
};

}  // namespace

GapPasses insert_gap_passes(const std::vector<GapCell>& cells, LineWorkshop& shop,
                            const GapPassOptions& options, Itinerary& itinerary) {
  if (cells.empty()) return {};
  return GapPassSearch(cells, shop, options).run(itinerary);
}

}  // namespace swathplan
