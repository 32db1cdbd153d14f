#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "apps/commands.h"
#include "apps/site.h"
#include "apps/watch/terminal_watch.h"
#include "io/results/provenance_json.h"
#include "io/seafloor/inspection.h"

namespace swathplan {

Command inspect_command() {
  auto site = std::make_shared<SiteOptions>();
  auto json = std::make_shared<bool>(false);
  return {"inspect",
          "What is in a seafloor file: extent, CRS, depths, mesh health, suggested settings",
          joined({without(site_options(*site), {"--area", "--no-go", "--buffer", "--run-out-margin",
                                                "--hazards", "--keep-off", "--chart-margin"}),
                  {flag("--json", "", *json, "Print as JSON", "")}}),
          [site, json] {
            TerminalWatch watch(false);
            watch.phase(fmt::format("reading {}", site->file.filename().string()));
            const ImportedSeafloor imported = imported_seafloor(*site);
            watch.rest();
            if (*json) {
              fmt::print("{}", in_flags(json_text(inspection_json(imported))));
            } else {
              fmt::print("{}", in_flags(inspection_text(imported)));
            }
          },
          {}};
}

}  // namespace swathplan
