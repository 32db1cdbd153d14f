#include "coverage/judging/out_of_reach.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <numbers>
#include <optional>

#include "coverage/judging/steerable_poses.h"
#include "mesh/base/parallel.h"
#include "mesh/plane/area_query.h"

namespace swathplan {

namespace {

// A beam that ends so near to the middle of a cell has seen it: rounding, and the slope between.
constexpr double kSeenM = 0.05;
constexpr double kSeenShare = 0.005;

}  // namespace

bool in_sight(const RayScene& scene, const Vec2& boat, double draft_m, const Vec2& target,
              double depth_m) {
  const Vec3 from(boat.x(), boat.y(), -draft_m);
  const Vec3 way = Vec3(target.x(), target.y(), -depth_m) - from;
  const Eigen::Vector3f direction = way.normalized().cast<float>();
  RayHit hit;
  scene.trace(from, {&direction, 1}, {&hit, 1});
  return hit.range_m > 0.0F && hit.range_m >= way.norm() * (1.0 - kSeenShare) - kSeenM;
}

struct ReachSearch::Impl {
  struct Beam {
    double tangent;  // of its angle from nadir
    double reach_m;  // slant
  };
  enum class Reached { no, from_safe_water, steered };

  static Beam beam_of(const Sonar& sonar, double degrees) {
    const Angle angle = Angle::degrees(degrees);
    return {tan(angle), swathplan::reach_m(sonar, angle)};
  }

  Impl(const Ground& ground, const Sonar& sonar, const Vehicle& vehicle)
      : scene(ground.scene),
        safe_water(ground.water),
        water(ground.water),
        draft(vehicle.draft_m),
        off(vehicle.position_error_m),
        turn_radius(vehicle.turn_radius_m),
        widest(beam_of(sonar, sonar.max_opening.deg() / 2.0)) {
    const double degrees = sonar.max_opening.deg() / 2.0;
    for (double t = 0.0; t < degrees; t += kAngleStepDeg) beams.push_back(beam_of(sonar, t));
    beams.push_back(widest);
  }

  [[nodiscard]] Reached reached(const SteerablePoses& poses, const Vec2& target,
                                double depth) const {
    const double below = depth - draft;
    if (!(below > 0.0)) return Reached::no;
    Reached best = Reached::no;
    for (const Beam& beam : beams) {
      const double away = below * beam.tangent;
      if (std::hypot(away, below) > beam.reach_m) break;
      for (int k = 0; k < kAzimuths; ++k) {
        const double azimuth = 2.0 * std::numbers::pi * k / kAzimuths;
        const Vec2 across(std::sin(azimuth), std::cos(azimuth));
        const Vec2 boat = target + away * across;
        if (!water.contains(boat) || !in_sight(*scene, boat, draft, target, depth)) continue;
        best = Reached::from_safe_water;
        const Vec2 course(across.y(), -across.x());
        // Port and starboard sail the same line, so one course stands for both.
        if (poses.steerable(boat, course) && held(boat, across, target, depth)) {
          return Reached::steered;
        }
      }
    }
    return best;
  }

  // Whether the beam still sees the target from as far to either side as the boat may be off.
  [[nodiscard]] bool held(const Vec2& boat, const Vec2& across, const Vec2& target,
                          double depth) const {
    if (!(off > 0.0)) return true;
    return std::all_of(kSides.begin(), kSides.end(), [&](double side) {
      const Vec2 there = boat + side * off * across;
      const double away = (target - there).norm();
      return away <= (depth - draft) * widest.tangent &&
             in_sight(*scene, there, draft, target, depth);
    });
  }
  static constexpr std::array<double, 2> kSides{1.0, -1.0};

  const RayScene* scene;
  Area safe_water;
  AreaQuery water;
  double draft, off, turn_radius;
  Beam widest;
  std::vector<Beam> beams;
  std::optional<SteerablePoses> poses_of_water;  // made when the first cell asks for it
  std::once_flag once;

  [[nodiscard]] const SteerablePoses& poses() {
    std::call_once(once, [&] { poses_of_water.emplace(safe_water, turn_radius); });
    return *poses_of_water;
  }
};

ReachSearch::ReachSearch(const Ground& ground, const Sonar& sonar, const Vehicle& vehicle)
    : impl_(std::make_unique<Impl>(ground, sonar, vehicle)) {}
ReachSearch::~ReachSearch() = default;
ReachSearch::ReachSearch(ReachSearch&&) noexcept = default;
ReachSearch& ReachSearch::operator=(ReachSearch&&) noexcept = default;

OutOfReach ReachSearch::leave_out(std::vector<JudgedGrid>& grids) const {
  const auto unseen = [](const JudgedCell& cell) { return cell.asked && cell.soundings == 0; };
  OutOfReach out;
  for (JudgedGrid& grid : grids) {
    if (std::none_of(grid.cells.begin(), grid.cells.end(), unseen)) continue;
    const SteerablePoses& poses = impl_->poses();
    std::vector<std::size_t> hidden(grid.rows, 0);
    std::vector<std::size_t> unsteerable(grid.rows, 0);
    for_each_index(std::uint32_t{0}, grid.rows, [&](std::uint32_t row) {
      for (std::size_t i = std::size_t{row} * grid.columns, end = i + grid.columns; i < end; ++i) {
        JudgedCell& cell = grid.cells[i];
        if (!unseen(cell)) continue;
        const Impl::Reached reached = impl_->reached(poses, grid.centre(i), cell.depth_m);
        if (reached == Impl::Reached::steered) continue;
        cell.asked = false;
        ++(reached == Impl::Reached::no ? hidden : unsteerable)[row];
      }
    });
    for (std::size_t row = 0; row < grid.rows; ++row) {
      const double cell = grid.cell_m * grid.cell_m;
      out.hidden_m2 += static_cast<double>(hidden[row]) * cell;
      out.unsteerable_m2 += static_cast<double>(unsteerable[row]) * cell;
    }
  }
  return out;
}

}  // namespace swathplan
