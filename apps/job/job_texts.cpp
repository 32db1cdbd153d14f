#include "apps/job/job_texts.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "planners/wording.h"

namespace swathplan {
namespace {

double in_hours(double seconds) { return seconds / 3600.0; }

/// '+2:05' after the beginning, or '2, 06:00' for a day and its time.
std::string clock_text(double seconds, bool by_daylight) {
  const auto minutes = static_cast<long>(std::floor(seconds / 60.0 + 1e-6));
  if (!by_daylight) return fmt::format("+{}:{:02}", minutes / 60, minutes % 60);
  constexpr long kDay = 24L * 60L;
  return fmt::format("day {}, {:02}:{:02}", 1 + minutes / kDay, minutes % kDay / 60, minutes % 60);
}

std::string sorties_table(const JobSummary& job) {
  if (!job.divided()) return {};
  const std::vector<std::string> stems = sortie_stems(job);
  std::string text = "sorties";
  if (job.longest_sortie_s) {
    text +=
        fmt::format(" of {:.2f} h at most, contingency included", in_hours(*job.longest_sortie_s));
  }
  text +=
      fmt::format(":\n{:>4} {:>6} {:>13} {:>7} {:>12} {:>8} {:>10} {:>6}  {}\n", "boat", "sortie",
                  "begins", "hours", "contingency", "km", "logged km", "lines", "route");
  for (std::size_t i = 0; i < job.sorties.size(); ++i) {
    const JobSortie& s = job.sorties[i];
    text += fmt::format("{:>4} {:>6} {:>13} {:>7.2f} {:>12.2f} {:>8.2f} {:>10.2f} {:>6}  {}.csv\n",
                        s.boat, s.number, clock_text(s.begins_s, job.by_daylight),
                        in_hours(s.duration_s), in_hours(s.with_contingency_s), s.length_m / 1000.0,
                        s.logged_m / 1000.0, s.lines.size(), stems[i]);
  }
  return text + fmt::format(
                    "together {:.2f} h, {:.3f} times the {:.2f} h of one boat in one go; route.csv "
                    "holds them one after the other\n",
                    in_hours(job.sailed_s), job.sailed_s / job.undivided_s,
                    in_hours(job.undivided_s));
}

std::string boats_text(const JobSummary& job) {
  if (job.boats < 2) return {};
  std::string text =
      fmt::format("{} boats: all done after {:.2f} h, {:.3f} of one boat's time; ", job.boats,
                  in_hours(job.makespan_s), job.makespan_s / job.undivided_s);
  text += job.apart.within_a_swath_s > 0.0
              ? fmt::format("on lines within a swath of each other for {:.0f} s",
                            job.apart.within_a_swath_s)
              : "on lines never within a swath of each other";
  if (job.apart.least_m) text += fmt::format(" (at least {:.0f} m)", *job.apart.least_m);
  text += job.apart.neighbours_s > 0.0
              ? fmt::format(", on neighbouring lines for {:.0f} s", job.apart.neighbours_s)
              : ", never on neighbouring lines at the same time";
  return text + "\n";
}

std::string patch_text(const PatchTest& test) {
  if (test.lines.empty()) return fmt::format("  {:<8} no lines: {}\n", test.name, test.reason);
  std::string text =
      fmt::format("  {:<8} lines {}: {}\n", test.name, fmt::join(test.lines, ", "), test.reason);
  for (const PatchCondition& c : test.conditions) {
    text += fmt::format("           {} {}: {} (asked: {})\n", c.met ? "met    " : "NOT MET", c.what,
                        c.figure, c.asks);
  }
  return text;
}

}  // namespace

std::vector<std::string> sortie_stems(const JobSummary& job) {
  std::vector<std::string> stems;
  if (!job.divided()) return stems;
  const bool several = std::any_of(job.sorties.begin(), job.sorties.end(),
                                   [](const JobSortie& s) { return s.number > 1; });
  for (const JobSortie& s : job.sorties) {
    std::string stem = "route";
    if (job.boats > 1) stem += fmt::format("_boat{}", s.boat);
    if (several) stem += fmt::format("_sortie{}", s.number);
    stems.push_back(stem);
  }
  return stems;
}

std::string job_table(const JobSummary& job) {
  std::string text = sorties_table(job) + boats_text(job);
  if (job.patch_tests.empty()) return text;
  text += "patch test:\n";
  for (const PatchTest& test : job.patch_tests) text += patch_text(test);
  return text;
}

std::vector<std::string> job_notes(const JobSummary& job, const CrossFigures& cross) {
  std::vector<std::string> notes;
  if (cross.lines > 0) {
    std::string note = fmt::format(
        "{} of {:.0f} m make up {:.2f} % of the main scheme's {:.0f} m; they cross it {} times, {} "
        "of them within {:g} degrees of a right angle",
        counted(cross.lines, "cross-line"), cross.length_m, 100.0 * cross.share(),
        cross.main_length_m, cross.crossings, cross.right_angled, kRightAngleDeg);
    if (job.cross) {
      note += fmt::format(
          ", in {} of ten tenths of its depths, where the ground slopes by {:.1f} degrees (median; "
          "{:.1f} below the main scheme)",
          job.cross->depth_tenths, job.cross->median_slope_deg, job.cross->site_slope_deg);
    }
    notes.push_back(note);
  }
  for (const PatchTest& test : job.patch_tests) {
    if (test.lines.empty()) continue;
    notes.push_back(fmt::format(
        "patch test, {} (lines {}): {}; {}", test.name, fmt::join(test.lines, ", "), test.reason,
        test.met() ? "all its conditions are met" : "not all of its conditions are met"));
  }
  return notes;
}

}  // namespace swathplan
