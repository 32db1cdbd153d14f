#include "io/report/report.h"

#include <functional>
#include <map>

#include "io/files/atomic_file.h"
#include "io/report/assets_internal.h"
#include "io/report/plan_data_internal.h"
#include "io/report/report_data_internal.h"
#include "mesh/base/error.h"

namespace swathplan {
namespace {

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

/// JSON for a script element. The text must not close this element.
std::string script_json(const nlohmann::ordered_json& json) {
  const std::string text =
      json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  std::string out;
  out.reserve(text.size());
  for (const char c : text) {
    if (c == '<') {
      out += "\\u003c";
    } else {
      out += c;
    }
  }
  return out;
}

/// The page with each {{name}} replaced. Text that was put in is not searched again.
std::string filled(std::string_view page, const std::map<std::string_view, std::string>& values) {
  std::string out;
  while (true) {
    const std::size_t open = page.find("{{");
    out += page.substr(0, open);
    if (open == std::string_view::npos) return out;
    const std::size_t close = page.find("}}", open);
    out += values.at(page.substr(open + 2, close - open - 2));
    page.remove_prefix(close + 2);
  }
}

/// What a browser without scripts shows.
std::string plain_list(const std::vector<internal::ComparedPlan>& plans) {
  std::string out;
  for (const internal::ComparedPlan& plan : plans) {
    out += "<li><strong>" + escaped(plan.name) + "</strong>: " + escaped(internal::verdict(plan)) +
           "</li>";
  }
  return out;
}

}  // namespace

std::string report_html(const ReportSite& site, const std::vector<ReportPlan>& plans) {
  if (plans.empty()) throw InvalidInput("a report needs at least one plan");
  const std::vector<internal::ComparedPlan> all = internal::compared(plans);
  const internal::ComparedPlan& best = all[internal::best_plan(all)];
  return filled(internal::kReportPage, {{"title", escaped(site.title)},
                                        {"verdict", escaped(internal::verdict(best))},
                                        {"overall", escaped(internal::overall_verdict(all))},
                                        {"plain", plain_list(all)},
                                        {"style", std::string(internal::kReportStyle)},
                                        {"libraries", std::string(internal::kReportLibraries)},
                                        {"script", std::string(internal::kReportScript)},
                                        {"data", script_json(internal::report_data(site, plans))}});
}

std::string best_of_plans(const std::vector<ReportPlan>& plans) {
  return internal::overall_verdict(internal::compared(plans));
}

void write_report(const std::filesystem::path& path, const ReportSite& site,
                  const std::vector<ReportPlan>& plans) {
  write_text_atomically(path, report_html(site, plans));
}

}  // namespace swathplan
