#include <sstream>

#include "apps/adapt/adapt_live.h"
#include "apps/adapt/live_curves.h"
#include "fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace swathplan;
  TrackSpacingOptions options;
  options.width_m = 400.0;
  options.length_m = 500.0;
  TrackSpacingState state = start_spacing(options);
  const SurveyBox box{};
  LivePlanner planner{"spacing", [&] { return next_track(state); }, {}, {}};
  planner.observe = [&](const SurveyTrack& track, const nlohmann::json& message) {
    state = observe(state, track, observed_curves(message));
  };
  planner.figures = [&] { return nlohmann::ordered_json{{"uncovered_m", uncovered_m(state)}}; };
  std::istringstream in(fuzz::text_of(data, size));
  std::ostringstream out;
  fuzz::expect_sentence([&] { static_cast<void>(run_live(in, out, box, {}, planner)); });
  return 0;
}
