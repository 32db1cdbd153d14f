#include "coverage/judging/judged_soundings.h"

#include <algorithm>
#include <cmath>

namespace swathplan {

SoundingMaker::SoundingMaker(const Sonar& sonar, double draft_m, double swath_share,
                             const Criterion& criterion, const UncertaintyModel& model)
    : draft_(draft_m), criterion_(&criterion), model_(&model), tables_(sonar, swath_share) {}

void SoundingMaker::append(const TracedPings& block, std::vector<JudgedSounding>& soundings) {
  for (std::size_t i = 0; i < block.pings.size(); ++i) {
    if (block.pings[i].log) append_fan(block, i, soundings);
  }
}

void SoundingMaker::append_fan(const TracedPings& block, std::size_t k,
                               std::vector<JudgedSounding>& soundings) {
  const Ping& ping = block.pings[k];
  const FanTable& table = tables_.get(ping.fan);
  const float* const ranges = block.hits.floats.data() + block.hits.starts[k];
  const Vec2 starboard(ping.course.y(), -ping.course.x());
  const double sin_roll = sin(ping.roll);
  const double cos_roll = cos(ping.roll);
  for (std::size_t i = 0; i < table.beams; ++i) {
    const double range = ranges[i];
    if (!(range > 0.0)) continue;
    // As the tracer aims: with the starboard side down the fan swings to port.
    const double across = table.sine[i] * cos_roll - table.cosine[i] * sin_roll;
    const double cosine = table.cosine[i] * cos_roll + table.sine[i] * sin_roll;
    const double depth = range * cosine + draft_ - ping.heave_m;
    const SoundingUncertainty known =
        model_->of_beam(std::clamp(cosine, 1e-6, 1.0), range, ping.speed_mps);
    JudgedSounding s;
    s.position = ping.position + range * across * starboard;
    s.depth_m = static_cast<float>(depth);
    s.tvu_m = static_cast<float>(known.tvu_m);
    s.thu_m = static_cast<float>(known.thu_m);
    s.tvu_share = static_cast<float>(known.tvu_m / tvu_limit_m(*criterion_, depth));
    s.path_m = static_cast<float>(ping.path_m);
    s.line = block.line[k];
    s.accepted = s.tvu_share <= 1.0F && known.thu_m <= thu_limit_m(*criterion_, depth);
    if (const std::optional<double> cube = feature_m(*criterion_, depth)) {
      // Distance to the neighbouring beam on level ground at this range.
      const double step = std::max(table.step[i], table.next_step[i]);
      s.feature_pings = static_cast<float>(*cube / block.spacing_m[k]);
      s.feature_beams = static_cast<float>(*cube * cosine / (range * step));
    }
    soundings.push_back(s);
  }
}

}  // namespace swathplan
