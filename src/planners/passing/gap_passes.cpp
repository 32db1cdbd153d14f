#include "planners/passing/gap_passes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "coverage/judging/out_of_reach.h"
#include "mesh/base/parallel.h"
#include "mesh/plane/box.h"

namespace swathplan {
namespace {

/// Passes are looked for from cells so far apart, metres: those between lie in their swaths.
constexpr double kBetweenSeeds = 3.0;
/// So many at a time, and so often: passes from the first ones serve most of the others.
constexpr std::size_t kMostSeeds = 300;
constexpr int kSowings = 6;
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
/// Cells of a pass lie so far within its fan.
constexpr double kSpareDeg = 1.0;
constexpr double kBucket = 5.0;
constexpr double kPassDustM = 1e-6;
constexpr double kShortestPass = 1.0;

struct Candidate {
  Vec2 from, to;
  std::vector<std::uint32_t> cells;
};

double length_of(const Candidate& c) { return (c.to - c.from).norm(); }

/// Cells by squares of kBucket.
class CellBuckets {
 public:
  explicit CellBuckets(const std::vector<GapCell>& cells) {
    Box2 box;
    for (const GapCell& cell : cells) box.extend(cell.position);
    origin_ = box.min;
    columns_ = static_cast<std::size_t>(box.size().x() / kBucket) + 1;
    rows_ = static_cast<std::size_t>(box.size().y() / kBucket) + 1;
    buckets_.resize(columns_ * rows_);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const Vec2 at = (cells[i].position - origin_) / kBucket;
      buckets_[static_cast<std::size_t>(at.y()) * columns_ + static_cast<std::size_t>(at.x())]
          .push_back(static_cast<std::uint32_t>(i));
    }
  }

  template <class Visit>
  void each_in(const Vec2& low, const Vec2& high, const Visit& visit) const {
    const auto index = [](double at, std::size_t count) {
      return static_cast<std::size_t>(std::clamp(at, 0.0, static_cast<double>(count) - 1.0));
    };
    const Vec2 a = (low - origin_) / kBucket;
    const Vec2 b = (high - origin_) / kBucket;
    for (std::size_t y = index(a.y(), rows_); y <= index(b.y(), rows_); ++y) {
      for (std::size_t x = index(a.x(), columns_); x <= index(b.x(), columns_); ++x) {
        for (const std::uint32_t i : buckets_[y * columns_ + x]) visit(i);
      }
    }
  }

 private:
  Vec2 origin_ = Vec2::Zero();
  std::size_t columns_ = 0, rows_ = 0;
  std::vector<std::vector<std::uint32_t>> buckets_;
};

class GapPassSearch {
 public:
  GapPassSearch(const std::vector<GapCell>& cells, LineWorkshop& shop,
                const GapPassOptions& options)
      : cells_(cells),
        shop_(shop),
        options_(options),
        buckets_(cells),
        left_(cells.size()),
        sown_(cells.size(), 0) {
    const PlanOptions& how = shop.options();
    draft_ = how.vehicle.draft_m;
    widest_ = how.sonar.max_opening.deg() / 2.0;
    least_ = std::max(how.least_line_m, kShortestPass);
    usual_detour_ = kUsualDetourRadii * how.vehicle.turn_radius_m;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      left_[i] = cells[i].lines;
      deepest_ = std::max(deepest_, cells[i].depth_m - draft_);
    }
    slant_.resize(static_cast<std::size_t>(widest_) + 2);
    for (std::size_t k = 0; k < slant_.size(); ++k) {
      slant_[k] = reach_m(how.sonar, Angle::degrees(static_cast<double>(k)));
    }
    sin_off_ = sin(options.unsteady.heading);
    cos_off_ = cos(options.unsteady.heading);
  }

  GapPasses run(Itinerary& itinerary) {
    GapPasses result;
    for (int sowing = 0; sowing < kSowings; ++sowing) {
      const std::vector<std::uint32_t> seeds = seeds_of();
      if (seeds.empty()) break;
      std::vector<std::vector<Candidate>> found(seeds.size());
      for_each_index(std::size_t{0}, seeds.size(),
                     [&](std::size_t k) { found[k] = passes_from(cells_[seeds[k]]); });
      std::vector<Candidate> all;
      for (auto& list : found) std::move(list.begin(), list.end(), std::back_inserter(all));
      take(std::move(all), itinerary, result);
    }
    result.cells_left = static_cast<std::size_t>(
        std::count_if(left_.begin(), left_.end(), [](int n) { return n > 0; }));
    return result;
  }

 private:
  /// Cells that are left and were no seeds yet, spread over all gaps, in their order.
  [[nodiscard]] std::vector<std::uint32_t> seeds_of() {
    std::vector<std::pair<std::pair<long, long>, std::uint32_t>> places;
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      if (left_[i] <= 0 || sown_[i] != 0) continue;
      const Vec2 at = cells_[i].position / kBetweenSeeds;
      places.push_back({{std::lround(std::floor(at.y())), std::lround(std::floor(at.x()))},
                        static_cast<std::uint32_t>(i)});
    }
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end(),
                             [](const auto& a, const auto& b) { return a.first == b.first; }),
                 places.end());
    // Too many: an even choice of them.
    const std::size_t step = places.size() / kMostSeeds + 1;
    std::vector<std::uint32_t> chosen;
    for (std::size_t k = 0; k < places.size(); k += step) {
      chosen.push_back(places[k].second);
      sown_[places[k].second] = 1;
    }
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
        if (!shop_.lines_in().contains(boat)) continue;
        const RayScene& scene = *shop_.ground().scene;
        if (!in_sight(scene, boat, draft_, seed.position, seed.depth_m)) continue;
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
        Candidate c{boat - shift * length * course, boat + (1.0 - shift) * length * course, {}};
        if (!shop_.lines_in().contains(c.from) || !shop_.lines_in().contains(c.to)) continue;
        if (shop_.lines_in().inside_length(c.from, c.to) < length - kPassDustM) continue;
        if (!shop_.connector().has_room({c.from, c.to})) continue;
        look(c, kept.size() < kKeptOfSeed ? 0.0 : rate(kept.back(), kept.back().cells.size()));
        if (c.cells.empty()) break;
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

  /// Fills in the cells that a pass sees; none if they cannot be worth more than `least_rate`.
  void look(Candidate& c, double least_rate) const {
    const double length = length_of(c);
    const double far = deepest_ * tan(Angle::degrees(widest_));
    const Vec2 low = c.from.cwiseMin(c.to) - Vec2::Constant(far);
    const Vec2 high = c.from.cwiseMax(c.to) + Vec2::Constant(far);
    std::vector<std::uint32_t> near;
    const auto enough = [&](std::size_t cells) {
      return cells >= options_.fewest_cells && rate(c, cells) > least_rate;
    };
    buckets_.each_in(low, high, [&](std::uint32_t i) {
      if (left_[i] > 0 && reaches(cells_[i], c, length)) near.push_back(i);
    });
    // Rays are what takes time.
    for (std::size_t k = 0; k < near.size(); ++k) {
      if (!enough(c.cells.size() + near.size() - k)) {
        c.cells.clear();
        return;
      }
      if (in_sight_of(cells_[near[k]], c)) c.cells.push_back(near[k]);
    }
    if (!enough(c.cells.size())) c.cells.clear();
  }

  /// Where the boat is that is off to one side when its fan points at the cell, and metres along
  /// the pass.
  struct Place {
    Vec2 boat;
    double along;
  };
  [[nodiscard]] Place place(const GapCell& cell, const Candidate& c, double side) const {
    const Vec2 along = (c.to - c.from).normalized();
    const Vec2 starboard(along.y(), -along.x());
    const Vec2 aside = side * options_.unsteady.aside_m * starboard;
    const Vec2 heading = cos_off_ * along + side * sin_off_ * starboard;
    const double at = (cell.position - c.from - aside).dot(heading) / cos_off_;
    return {c.from + aside + at * along, at};
  }

  [[nodiscard]] bool reaches(const GapCell& cell, const Candidate& c, double length) const {
    const double below = cell.depth_m - draft_;
    if (!(below > 0.0)) return false;
    const double end = options_.end_share * length;
    for (const double side : {1.0, -1.0}) {
      const Place p = place(cell, c, side);
      if (p.along < end || p.along > length - end) return false;
      const double away = (p.boat - cell.position).norm();
      const double degrees = std::atan(away / below) * 180.0 / std::numbers::pi + kSpareDeg;
      if (degrees > widest_ ||
          std::hypot(away, below) > slant_[static_cast<std::size_t>(degrees)]) {
        return false;
      }
    }
    return true;
  }

  [[nodiscard]] bool in_sight_of(const GapCell& cell, const Candidate& c) const {
    const RayScene& scene = *shop_.ground().scene;
    const bool steady = options_.unsteady.aside_m == 0.0 && sin_off_ == 0.0;
    return in_sight(scene, place(cell, c, 1.0).boat, draft_, cell.position, cell.depth_m) &&
           (steady ||
            in_sight(scene, place(cell, c, -1.0).boat, draft_, cell.position, cell.depth_m));
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

  /// Takes the pass with the most cells for the metres that it adds, again and again.
  void take(std::vector<Candidate> all, Itinerary& itinerary, GapPasses& result) {
    struct Offer {
      double rate;
      std::size_t pass;
      double detour;
    };
    const auto less = [](const Offer& a, const Offer& b) {
      return a.rate != b.rate ? a.rate < b.rate : a.pass > b.pass;
    };
    // Before a pass's detour is known it counts as none, so that no pass is looked at too late.
    std::vector<Offer> offers;
    for (std::size_t k = 0; k < all.size(); ++k) {
      offers.push_back({static_cast<double>(all[k].cells.size()) / length_of(all[k]), k, 0.0});
    }
    std::make_heap(offers.begin(), offers.end(), less);
    const auto wait = [&](const Offer& offer) {
      offers.push_back(offer);
      std::push_heap(offers.begin(), offers.end(), less);
    };
    while (!offers.empty() && result.passes < options_.most_passes) {
      std::pop_heap(offers.begin(), offers.end(), less);
      Offer offer = offers.back();
      offers.pop_back();
      const Candidate& c = all[offer.pass];
      const std::size_t cells = gain(c);
      if (cells < std::max<std::size_t>(options_.fewest_cells, 1)) continue;
      const auto rate_of = [&](double detour) {
        return static_cast<double>(cells) / (length_of(c) + std::max(detour, 0.0));
      };
      // A bound only shrinks, so the pass waits for its turn.
      offer.rate = rate_of(offer.detour);
      if (!offers.empty() && offer.rate < offers.front().rate) {
        wait(offer);
        continue;
      }
      if (offer.detour == 0.0 && barred(c)) continue;
      const Itinerary::Place place = itinerary.cheapest(c.from, c.to);
      const double known = offer.detour;
      offer.detour = std::max(place.cost, kPassDustM);
      offer.rate = rate_of(offer.detour);
      if (offer.detour > known && !offers.empty() && offer.rate < offers.front().rate) {
        wait(offer);
        continue;
      }
      itinerary.insert(waypoints(c, place.backwards), place.before);
      for (const std::uint32_t i : c.cells) left_[i] = std::max(0, left_[i] - 1);
      ++result.passes;
      // It may be worth sailing twice.
      wait(offer);
    }
  }

  [[nodiscard]] std::vector<Waypoint> waypoints(const Candidate& c, bool backwards) const {
    // As wide as the sonar serves over the deepest of its cells: what else it sees may spare
    // others.
    double below = 0.0;
    for (const std::uint32_t i : c.cells) below = std::max(below, cells_[i].depth_m - draft_);
    std::size_t degrees = slant_.size() - 2;
    while (degrees > 1 &&
           below / cos(Angle::degrees(static_cast<double>(degrees))) > slant_[degrees]) {
      --degrees;
    }
    Waypoint point;
    point.kind = LegKind::infill;
    const Angle open = Angle::degrees(static_cast<double>(degrees));
    point.fan = FanAngles{open, open};
    point.speed_mps = shop_.options().vehicle.speed_mps;
    std::vector<Waypoint> points(2, point);
    points[0].position = backwards ? c.to : c.from;
    points[1].position = backwards ? c.from : c.to;
    return points;
  }

  const std::vector<GapCell>& cells_;
  LineWorkshop& shop_;
  const GapPassOptions& options_;
  CellBuckets buckets_;
  std::vector<int> left_;
  std::vector<std::uint8_t> sown_;
  std::vector<double> slant_;  ///< that the sonar reaches, by whole degrees from nadir
  double draft_ = 0.0, widest_ = 65.0, least_ = 20.0, usual_detour_ = 0.0, deepest_ = 0.0;
  double sin_off_ = 0.0, cos_off_ = 1.0;
};

}  // namespace

GapPasses insert_gap_passes(const std::vector<GapCell>& cells, LineWorkshop& shop,
                            const GapPassOptions& options, Itinerary& itinerary) {
  if (cells.empty()) return {};
  return GapPassSearch(cells, shop, options).run(itinerary);
}

}  // namespace swathplan
