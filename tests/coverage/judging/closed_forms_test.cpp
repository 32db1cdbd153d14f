// Level, tilted and stepped floors: ping spacing and soundings a cell against closed forms, to a
// thousandth. TVU and THU are held against theirs in judged_survey_test.cpp.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "coverage/judging/judged_survey.h"
#include "coverage/judging/traced_pings.h"
#include "coverage/scenes.h"
#include "mesh/synthetic.h"

namespace swathplan {
namespace {

using testing::rectangle;
using testing::route_through;
using testing::TestGround;

constexpr double kHalfDeg = 45.0;
constexpr double kFormDraft = 0.5;
constexpr double kRad = M_PI / 180.0;

/// A floor of 60 x 60 m: where a beam at `t` (starboard, east, positive) meets it, metres east of
/// the boat in its middle, and at which slant range.
struct FloorForm {
  const char* name;
  Seafloor floor;
  std::function<double(double)> range;
};

std::vector<FloorForm> floor_forms() {
  const double slope = std::tan(15.0 * kRad);
  const double middle = 5.0 + 30.0 * slope - kFormDraft;
  std::vector<FloorForm> forms;
  forms.push_back({"level", flat(60, 60, 12), [](double t) { return 11.5 / std::cos(t); }});
  forms.push_back({"tilted", tilted(60, 60, 5, Angle::degrees(15)),
                   [=](double t) { return middle / (std::cos(t) - std::sin(t) * slope); }});
  // The boat sails over the wall's foot, so its port side sees the shoal and its starboard the
  // deep.
  forms.push_back({"stepped", stepped(60, 60, 8, 14),
                   [](double t) { return (t < 0.0 ? 7.5 : 13.5) / std::cos(t); }});
  return forms;
}

Route northwards() {
  return route_through({{30, -20}, {30, 80}}, {Angle::degrees(kHalfDeg), Angle::degrees(kHalfDeg)});
}

Sonar form_sonar() {
  Sonar sonar = *sonar_preset("em2040");
  sonar.max_ping_rate_hz = 1000.0;  // so that sound binds
  return sonar;
}

TEST(ClosedForms, PingsByTheClockStandAsFarApartAsTheFarthestSoundingAsks) {
  for (const FloorForm& form : floor_forms()) {
    const TestGround site(form.floor, Nodata::open, rectangle(0, 0, 60, 60));
    const CoverageGrid grid(rectangle(0, 0, 60, 60), 1.0);
    ScoreOptions scoring;
    scoring.pings.spacing_m.reset();
    const Route route = northwards();
    const Sonar sonar = form_sonar();
    TracedPingReader reader(route, site.scene, sonar, kFormDraft, scoring, grid);
    TracedPings all;
    ASSERT_TRUE(reader.next(1000000, all));
    const double farthest = std::max(form.range(kHalfDeg * kRad), form.range(-kHalfDeg * kRad));
    const double spacing = 2.0 * 2.0 * farthest / (0.9 * 1500.0);
    std::size_t seen = 0;
    for (std::size_t i = 0; i + 1 < all.pings.size(); ++i) {
      const double y = all.pings[i].position.y();
      if (y < 5.0 || y > 55.0) continue;
      ++seen;
      const double apart = (all.pings[i + 1].position - all.pings[i].position).norm();
      EXPECT_NEAR(apart, spacing, 1e-3 * spacing) << form.name;
      EXPECT_NEAR(all.spacing_m[i], spacing, 1e-3 * spacing) << form.name;
    }
    EXPECT_GT(seen, 500U) << form.name;
  }
}

TEST(ClosedForms, SoundingsOfACellAreThoseOfItsBeamsAndPings) {
  UncertaintyBudget budget;
  use_sonar("em2040", budget);
  use_positioning("rtk", budget);
  use_motion_sensor("ins", budget);
  budget.beam_width_along = Angle::degrees(1);
  budget.mean_sound_speed_mps = budget.head_sound_speed_mps = 0.2;
  budget.draft_m = budget.squat_m = 0.02;
  for (const FloorForm& form : floor_forms()) {
    const TestGround site(form.floor, Nodata::open, rectangle(0, 0, 60, 60));
    const SurveyJudge judge(site.ground, criterion("s44-1a"), budget);
    ScoreOptions scoring;
    scoring.resolution_m = 1.0;
    scoring.pings.spacing_m = 0.05;
    Vehicle vehicle;
    vehicle.draft_m = kFormDraft;
    const Sonar sonar = form_sonar();
    const std::vector<JudgedGrid> grids = judge.filled(northwards(), sonar, vehicle, scoring);
    ASSERT_EQ(grids.size(), 1U);
    ASSERT_EQ(grids[0].cell_m, 1.0);
    // Twenty pings a cell along the course.
    std::vector<double> exact(60, 0.0);
    for (int i = 0; i < sonar.beams; ++i) {
      const double t = (2.0 * i / (sonar.beams - 1) - 1.0) * kHalfDeg * kRad;
      const double x = 30.0 + form.range(t) * std::sin(t);
      if (x >= 0.0 && x < 60.0) exact[static_cast<std::size_t>(x)] += 20.0;
    }
    double total = 0.0;
    double off = 0.0;
    for (std::size_t row = 10; row < 50; ++row) {
      for (std::size_t column = 0; column < 60; ++column) {
        const double counted = grids[0].cells[row * 60 + column].soundings;
        total += counted;
        off += std::abs(counted - exact[column]);
      }
    }
    EXPECT_GT(total, 40.0 * 20.0 * 350.0) << form.name;
    EXPECT_LE(off, 1e-3 * total) << form.name;
  }
}

}  // namespace
}  // namespace swathplan
