#include "apps/adapt/live_curves.h"

namespace swathplan {
namespace {

DetectionCurve observed_curve(const nlohmann::json& sides) {
  if (sides.contains("curve")) {
    return {sides["curve"].at("range_m").get<std::vector<double>>(),
            sides["curve"].at("p").get<std::vector<double>>()};
  }
  const auto& counts = sides.at("counts");
  return estimated_curve({counts.value("first_m", 0.0), counts.at("step_m").get<double>(),
                          counts.at("trials").get<std::vector<std::int64_t>>(),
                          counts.at("detections").get<std::vector<std::int64_t>>()});
}

}  // namespace

SideCurves observed_curves(const nlohmann::json& message) {
  if (message.contains("port") || message.contains("starboard")) {
    return {observed_curve(message.at("port")), observed_curve(message.at("starboard"))};
  }
  const DetectionCurve both = observed_curve(message);
  return {both, both};
}

}  // namespace swathplan
