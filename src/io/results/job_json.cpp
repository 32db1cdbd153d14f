#include "io/results/job_json.h"

namespace swathplan {
namespace {

using JobJson = nlohmann::ordered_json;

JobJson place_json(const Vec2& local, const Frame& frame) {
  const Vec2 file = frame.to_file(local);
  return JobJson::array({file.x(), file.y()});
}

JobJson sorties_json(const JobSummary& job, const std::vector<std::string>& files) {
  JobJson list = JobJson::array();
  for (std::size_t i = 0; i < job.sorties.size(); ++i) {
    const JobSortie& s = job.sorties[i];
    list.push_back({{"boat", s.boat},
                    {"sortie", s.number},
                    {"route", i < files.size() ? files[i] : "route.csv"},
                    {"begins_s", s.begins_s},
                    {"duration_s", s.duration_s},
                    {"duration_with_contingency_s", s.with_contingency_s},
                    {"length_m", s.length_m},
                    {"logged_length_m", s.logged_m},
                    {"lines", s.lines}});
  }
  return list;
}

JobJson boats_json(const JobSummary& job) {
  if (job.boats < 2) return nullptr;
  return {{"boats", job.boats},
          {"makespan_s", job.makespan_s},
          {"makespan_to_one_boat", job.makespan_s / job.undivided_s},
          {"within_a_swath_s", job.apart.within_a_swath_s},
          {"on_neighbouring_lines_s", job.apart.neighbours_s},
          {"least_distance_on_lines_m",
           job.apart.least_m ? JobJson(*job.apart.least_m) : JobJson(nullptr)}};
}

JobJson cross_json(const JobSummary& job) {
  if (!job.cross) return nullptr;
  return {{"asked_pct", 100.0 * job.cross_share_asked},
          {"share_pct", 100.0 * job.cross->share},
          {"depth_tenths_crossed", job.cross->depth_tenths},
          {"median_slope_at_crossings_deg", job.cross->median_slope_deg},
          {"median_slope_of_main_scheme_deg", job.cross->site_slope_deg}};
}

JobJson patch_json(const PatchTest& test, const Frame& frame) {
  JobJson json = {{"test", test.name},   {"met", test.met()},          {"reason", test.reason},
                  {"lines", test.lines}, {"passes", JobJson::array()}, {"depth_m", test.depth_m}};
  for (std::size_t i = 0; i < test.passes.size(); ++i) {
    json["passes"].push_back({{"line", test.lines[i]},
                              {"from_xy", place_json(test.passes[i].first, frame)},
                              {"to_xy", place_json(test.passes[i].second, frame)},
                              {"speed_mps", test.speeds_mps[i]}});
  }
  json["conditions"] = JobJson::array();
  for (const PatchCondition& c : test.conditions) {
    json["conditions"].push_back(
        {{"what", c.what}, {"asks", c.asks}, {"figure", c.figure}, {"met", c.met}});
  }
  return json;
}

}  // namespace

nlohmann::ordered_json job_json(const JobSummary& job, const std::vector<std::string>& files,
                                const Frame& frame) {
  JobJson json = {{"berth_xy", job.berth ? place_json(*job.berth, frame) : JobJson(nullptr)},
                  {"longest_sortie_s",
                   job.longest_sortie_s ? JobJson(*job.longest_sortie_s) : JobJson(nullptr)},
                  {"by_daylight", job.by_daylight},
                  {"undivided_s", job.undivided_s},
                  {"sailed_s", job.sailed_s},
                  {"sailed_to_undivided", job.sailed_s / job.undivided_s},
                  {"sorties", sorties_json(job, files)},
                  {"boats", boats_json(job)},
                  {"cross_lines", cross_json(job)},
                  {"patch_test", JobJson::array()}};
  for (const PatchTest& test : job.patch_tests) {
    json["patch_test"].push_back(patch_json(test, frame));
  }
  return json;
}

}  // namespace swathplan
